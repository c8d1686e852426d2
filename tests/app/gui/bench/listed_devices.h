// Devices as a listing would give them, without any USB.
#pragma once

#include "devices/bench/device_listing.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

namespace straightedge::gui {

inline devices::ListedDevice listedEncoder() {
  devices::ListedDevice device;
  device.ids = devices::UsbIds{0x0403, 0x6001};
  device.serial = "FT-1";
  device.name = "FTDI FT232R USB UART";
  device.candidates = {"usdigital-qsb", "ascii-board", "group3-dtm151"};
  device.roles = {devices::InstrumentRole::AngleReference, devices::InstrumentRole::AngleSensor,
                  devices::InstrumentRole::Temperature, devices::InstrumentRole::FieldReference};
  return device;
}

inline devices::ListedDevice listedBoard() {
  devices::ListedDevice device;
  device.ids = devices::UsbIds{0x2341, 0x0043};
  device.serial = "ACM-1";
  device.name = "Arduino Uno";
  device.candidates = {"ascii-board"};
  device.roles = {devices::InstrumentRole::AngleSensor, devices::InstrumentRole::AngleReference,
                  devices::InstrumentRole::Temperature};
  return device;
}

inline devices::ListedDevice listedTeslameter() {
  devices::ListedDevice device;
  device.ids = devices::UsbIds{0x1bfa, 0x0498};
  device.serial = "0123456";
  device.name = "Metrolab Technology SA THM1176";
  device.instrument = "metrolab-thm1176";
  device.instrumentName = "Metrolab THM1176 / TFM1186 three-axis teslameter";
  device.roles = {devices::InstrumentRole::FieldProbe};
  device.problem = "access to the USB device is denied";
  device.remedy = "run: installer/run --udev, then plug the device in again";
  return device;
}

inline devices::ListedDevice listedMouse() {
  devices::ListedDevice device;
  device.ids = devices::UsbIds{0x046d, 0xc077};
  device.name = "Logitech Mouse";
  return device;
}

/// A desk whose devices the test puts there and takes away; may be looked at from any thread.
class PretendedDesk {
public:
  void put(std::vector<devices::ListedDevice> devices) {
    const std::lock_guard lock(m_state->mutex);
    m_state->devices = std::move(devices);
  }
  void breakDown(const Error& error) {
    const std::lock_guard lock(m_state->mutex);
    m_state->problem = error;
  }
  std::function<Result<std::vector<devices::ListedDevice>>()> lister() const {
    return [state = m_state]() -> Result<std::vector<devices::ListedDevice>> {
      const std::lock_guard lock(state->mutex);
      ++state->looks;
      if (state->problem) {
        return std::unexpected(*state->problem);
      }
      return state->devices;
    };
  }
  int looks() const { return m_state->looks; }

private:
  struct State {
    std::mutex mutex;
    std::vector<devices::ListedDevice> devices;
    std::optional<Error> problem;
    std::atomic<int> looks = 0;
  };
  std::shared_ptr<State> m_state = std::make_shared<State>();
};

} // namespace straightedge::gui
