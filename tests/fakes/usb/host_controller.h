// One plugged device and its open files: the usbfs ioctls, answered from an EmulatedDevice.
#pragma once

#include "tests/fakes/usb/emulated_device.h"

#include <functional>
#include <list>
#include <memory>
#include <umockdev.h>

struct usbdevfs_urb;

namespace straightedge::fakes {

struct GObjectDeleter {
  void operator()(void* object) const { g_object_unref(object); }
};
template <typename T>
using GPtr = std::unique_ptr<T, GObjectDeleter>;
template <typename T>
GPtr<T> keep(T* object) {
  return GPtr<T>(static_cast<T*>(g_object_ref(object)));
}

/// Thread: everything with the device's lock held; handle() in umockdev's thread.
class HostController {
public:
  HostController(std::shared_ptr<EmulatedDevice> device, std::string driver, std::function<void()> deviceLeaves);

  EmulatedDevice& device() const { return *m_device; }
  bool handle(UMockdevIoctlClient* client);
  void deviceGone(); ///< every transfer under way ends with ESHUTDOWN, every later request with ENODEV
  bool isGone() const { return m_gone; }
  void setHeldByOther(bool held) { m_heldByOther = held; }
  std::string driver(int interfaceNumber) const;

private:
  struct Urb {
    GPtr<UMockdevIoctlClient> client;
    GPtr<UMockdevIoctlData> data;
    UMockdevIoctlData* buffer = nullptr; ///< child of data
    usbdevfs_urb* urb = nullptr;
    bool done = false;
  };
  struct Claim {
    GPtr<UMockdevIoctlClient> owner;
    bool tookFromDriver = false;
  };

  void submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  void discard(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  void reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  bool giveDone(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  void claim(UMockdevIoctlClient* client, unsigned interfaceNumber, bool detach);
  void dropClosedClients();
  void pump();
  bool advance(Urb& urb); ///< true when it has ended
  bool advanceOut(Urb& urb);
  bool advanceIn(Urb& urb);
  void runControl(Urb& urb);

  std::shared_ptr<EmulatedDevice> m_device;
  std::string m_driver;
  std::function<void()> m_deviceLeaves;
  std::map<unsigned, Claim> m_claims;
  std::set<unsigned> m_detached;
  std::list<Urb> m_urbs;
  int m_idleReaps = 0;
  bool m_gone = false;
  bool m_heldByOther = false;
};

} // namespace straightedge::fakes
