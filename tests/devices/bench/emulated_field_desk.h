// A desk with a magnet, a teslameter, an NMR, a PT100's multimeter and a chamber's thermometer, emulated on USB, and
// the person who does what the program asks for. All instruments see the same field; what they sent is remembered.
#pragma once

#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::fakes {

/// Thread: the instruments answer in the bus's thread, the rest is called from the test's.
class EmulatedFieldDesk {
public:
  struct Sent {
    std::vector<std::array<double, 3>> rawT; ///< by the teslameter
    std::vector<double> electronicsC;        ///< in the same replies
    std::vector<std::optional<double>> nmrT; ///< none: not locked
    std::vector<double> ohm;
  };

  /// `leavesAt`: is unplugged in the middle of that reading of its own, counted from 1; 0: never.
  std::shared_ptr<UsbTmcDevice> teslameter(int leavesAt = 0);
  std::shared_ptr<FtdiDevice> nmr(int leavesAt = 0, int silentAt = 0); ///< `silentAt`: does not answer once
  std::shared_ptr<UsbTmcDevice> multimeter();
  std::shared_ptr<CdcAcmDevice> chamberThermometer(); ///< always 21.5 °C

  /// Does what "Please …, then press Enter" asks for.
  void obey(const std::string& line);
  void setFieldT(double fieldT);

  Sent sent() const;
  /// What the teslameter shows for a field along a package axis ("+x"), without rounding.
  static std::array<double, 3> readingT(double fieldT, std::size_t axis);

  static constexpr double celsiusPerCount = 0.001; ///< of the teslameter's thermometer, for the bench's settings
  /// `multimeter`: id of its driver or profile; empty: there is none.
  static std::string benchJson(bool withNmr = true, const std::string& multimeter = "scpi-multimeter",
                               bool withChamber = false);

private:
  std::string teslameterReply();
  std::string nmrReply();

  mutable std::mutex m_mutex;
  Sent m_sent;
  double m_fieldT = 0.5;
  std::size_t m_axis = 0; ///< of the package, along the field; 3: in the zero-field chamber
  double m_sign = 1.0;
  int m_searching = 0; ///< NMR readings until it has locked on a new field
};

} // namespace straightedge::fakes
