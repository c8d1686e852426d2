// A USB device in the test's process, packet by packet, as the host controller of emulated_usb.h sees it.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::fakes {

using Bytes = std::vector<std::uint8_t>;

struct DeviceIdentity {
  std::uint16_t vendorId = 0;
  std::uint16_t productId = 0;
  std::string manufacturer;
  std::string product;
  std::string serial;
  std::uint16_t release = 0x0100; ///< bcdDevice
};

struct ControlSetup {
  std::uint8_t requestType = 0;
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
  std::uint16_t length = 0;
};

enum class Handshake : std::uint8_t { Ack, Nak, Stall };

/// Thread: the controller calls the virtual members in its own thread with lock() held; a test's accessors take lock().
class EmulatedDevice {
public:
  explicit EmulatedDevice(DeviceIdentity identity) : m_identity(std::move(identity)) {}
  virtual ~EmulatedDevice() = default;
  EmulatedDevice(const EmulatedDevice&) = delete;
  EmulatedDevice& operator=(const EmulatedDevice&) = delete;

  const DeviceIdentity& identity() const { return m_identity; }
  virtual Bytes configurationDescriptor() const = 0;
  virtual std::size_t packetSize(std::uint8_t endpoint) const = 0;
  virtual bool highSpeed() const { return false; }

  /// Data of the answer, empty when there is none; nullopt stalls the request.
  virtual std::optional<Bytes> control(const ControlSetup& setup, const Bytes& data) = 0;
  virtual Handshake packetOut(std::uint8_t endpoint, const Bytes& packet) = 0;
  virtual std::optional<Bytes> packetIn(std::uint8_t endpoint); ///< nullopt: NAK. Takes from queueIn() as it stands
  virtual void haltCleared(std::uint8_t endpoint) { m_halted.erase(endpoint); }
  virtual void wasClaimed() {} ///< a program has opened it
  virtual void wasReset() { m_halted.clear(); }

  bool isHalted(std::uint8_t endpoint) const { return m_halted.contains(endpoint); }
  void halt(std::uint8_t endpoint) { m_halted.insert(endpoint); }

  std::unique_lock<std::recursive_mutex> lock() const { return std::unique_lock(m_mutex); }

  /// What the host did wrong, in the order it happened. A test that ends with an entry here has found a bug of the
  /// host.
  std::vector<std::string> violations() const;
  void forgetViolations();

  int resets() const;
  int haltsCleared(std::uint8_t endpoint) const; ///< CLEAR_FEATURE(HALT) of it so far

protected:
  void violation(std::string what) { m_violations.push_back(std::move(what)); }

  /// Splits into packets; `ended`: with a zero-length packet where the last one is full, as the end of a transfer asks.
  void queueIn(std::uint8_t endpoint, const Bytes& bytes, bool ended = true,
               std::chrono::milliseconds after = std::chrono::milliseconds(0));
  void queuePacket(std::uint8_t endpoint, Bytes packet, std::chrono::milliseconds after = std::chrono::milliseconds(0));
  bool hasQueued(std::uint8_t endpoint) const;
  void dropQueued(std::uint8_t endpoint) { m_in[endpoint].clear(); }
  bool isReadPosted(std::uint8_t endpoint) const { return m_posted.contains(endpoint); }
  void unplugNow() { m_leaving = true; } ///< the controller takes the device away when the current packet is done

private:
  friend class EmulatedUsb;
  friend class HostController;
  struct Packet {
    Bytes bytes;
    std::chrono::steady_clock::time_point ready;
  };

  const DeviceIdentity m_identity;
  mutable std::recursive_mutex m_mutex;
  std::map<std::uint8_t, std::deque<Packet>> m_in;
  std::set<std::uint8_t> m_halted;
  std::set<std::uint8_t> m_posted; ///< IN endpoints with a read of the host under way
  std::map<std::uint8_t, int> m_haltsCleared;
  std::vector<std::string> m_violations;
  int m_resets = 0;
  bool m_leaving = false;
};

/// Pieces of a configuration descriptor.
Bytes configurationHeader(std::size_t interfaces, const Bytes& rest);
Bytes interfaceDescriptor(std::uint8_t number, std::uint8_t endpoints, std::uint8_t classCode, std::uint8_t subclass,
                          std::uint8_t protocol);
Bytes endpointDescriptor(std::uint8_t address, std::uint8_t attributes, std::size_t packetSize);
void append(Bytes& to, const Bytes& more);
Bytes bytesOf(std::string_view text);
std::string textOf(const Bytes& bytes);

} // namespace straightedge::fakes
