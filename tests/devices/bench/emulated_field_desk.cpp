#include "tests/devices/bench/emulated_field_desk.h"

#include "tests/fakes/usb/thm1176.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace straightedge::fakes {

namespace {

/// Small steps by which no two replies are alike.
double step(std::size_t count, double size) { return static_cast<double>(count % 7) * size; }

double sentAs(const std::string& text) { return std::stod(text); }

template <typename... Numbers>
std::string printed(const char* format, Numbers... numbers) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, numbers...);
  return text.data();
}

} // namespace

std::array<double, 3> EmulatedFieldDesk::readingT(double fieldT, std::size_t axis) {
  std::array<double, 3> raw = {0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < raw.size() && axis < raw.size(); ++i) {
    const double along = i == axis ? fieldT : 0.01 * static_cast<double>(1 + i) * fieldT; // axes not quite square
    raw[i] = 0.98 * along - 0.002 * along * along * along;
  }
  return raw;
}

std::string EmulatedFieldDesk::teslameterReply() {
  const std::scoped_lock lock(m_mutex);
  const auto raw = readingT(m_sign * m_fieldT, m_axis);
  const std::size_t count = m_sent.rawT.size();
  std::array<double, 3> sent{};
  std::string reply;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const std::string text = printed("%.6f", raw[i] + step(count, 1e-6));
    sent[i] = sentAs(text);
    reply += text + " T;";
  }
  const int counts = 23000 + static_cast<int>(count);
  m_sent.rawT.push_back(sent);
  m_sent.electronicsC.push_back(0.0 + celsiusPerCount * counts);
  return reply + "0x00000000000012AB;" + std::to_string(counts) + ";0";
}

std::shared_ptr<UsbTmcDevice> EmulatedFieldDesk::teslameter(int leavesAt) {
  auto device = std::make_shared<UsbTmcDevice>(UsbTmcDevice::Options{.packet = 64}); // a reply is more than one packet
  device->onMessage(thm1176Answers([this, leavesAt, asked = 0, raw = device.get()]() mutable {
    if (++asked == leavesAt) {
      raw->fault(UsbTmcFault::UnplugMidReply);
    }
    return teslameterReply();
  }));
  return device;
}

std::string EmulatedFieldDesk::nmrReply() {
  const std::scoped_lock lock(m_mutex);
  if (m_searching > 0) {
    --m_searching;
    m_sent.nmrT.emplace_back();
    return printed("S%.7fT\r\n", std::abs(m_fieldT) + 0.01); // a number that must not be taken
  }
  const std::string text = printed("%.7f", std::abs(m_fieldT) + step(m_sent.nmrT.size(), 1e-7));
  m_sent.nmrT.emplace_back(sentAs(text));
  return "L" + text + "T\r\n";
}

std::shared_ptr<FtdiDevice> EmulatedFieldDesk::nmr(int leavesAt, int silentAt) {
  auto device =
      std::make_shared<FtdiDevice>(DeviceIdentity{0x0403, 0x6001, "FTDI", "FT232R USB UART", "NMR-1", 0x0600});
  device->onBytes(
      [this, leavesAt, silentAt, asked = 0, raw = device.get()](const std::string& bytes) mutable -> std::string {
        std::string reply;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
          if (bytes[i] == '\x05') {
            if (++asked == leavesAt) {
              raw->unplugAfter(4);
            }
            reply += asked == silentAt ? "" : nmrReply();
          } else if (bytes[i] == 'S') { // register 1: locked, data ready
            reply += "S21\r\n";
            ++i;
          }
        }
        return reply;
      });
  return device;
}

std::shared_ptr<UsbTmcDevice> EmulatedFieldDesk::multimeter() {
  auto device = std::make_shared<UsbTmcDevice>(
      UsbTmcDevice::Options{.identity = {0x0957, 0x0607, "Agilent Technologies", "34401A", "DMM-1"}});
  device->onMessage([this](const std::string& message) -> std::optional<std::string> {
    if (message == "*IDN?") {
      return "HEWLETT-PACKARD,34401A,0,11-5-2";
    }
    if (message == "SYST:ERR?") {
      return R"(+0,"No error")";
    }
    if (message != "READ?") {
      return std::nullopt;
    }
    const std::scoped_lock lock(m_mutex);
    const std::string text = printed("%+.8E", 109.35 + step(m_sent.ohm.size(), 1e-5));
    m_sent.ohm.push_back(sentAs(text));
    return text;
  });
  return device;
}

std::shared_ptr<CdcAcmDevice> EmulatedFieldDesk::chamberThermometer() {
  auto device = std::make_shared<CdcAcmDevice>();
  device->generate([next = std::chrono::steady_clock::now()]() mutable -> std::string {
    const auto now = std::chrono::steady_clock::now();
    if (now < next) {
      return {};
    }
    next = now + std::chrono::milliseconds(2);
    return "0,21.5\r\n";
  });
  return device;
}

void EmulatedFieldDesk::obey(const std::string& line) {
  const std::scoped_lock lock(m_mutex);
  const auto after = [&line](const std::string& words) -> std::string {
    const auto at = line.find(words);
    return at == std::string::npos ? std::string() : line.substr(at + words.size());
  };
  if (const std::string axis = after("place the probe with its "); axis.size() > 1) {
    m_sign = axis[0] == '-' ? -1.0 : 1.0;
    m_axis = static_cast<std::size_t>(axis[1] - 'x');
  } else if (!after("put the probe into the zero-field chamber").empty()) {
    m_axis = 3;
  } else if (const std::string field = after("set the field to "); !field.empty()) {
    m_fieldT = sentAs(field.substr(0, field.find(' ')));
    m_searching = 1;
  }
}

void EmulatedFieldDesk::setFieldT(double fieldT) {
  const std::scoped_lock lock(m_mutex);
  m_fieldT = fieldT;
}

EmulatedFieldDesk::Sent EmulatedFieldDesk::sent() const {
  const std::scoped_lock lock(m_mutex);
  return m_sent;
}

std::string EmulatedFieldDesk::benchJson(bool withNmr, const std::string& multimeter, bool withChamber) {
  std::string json = R"({"format": "straightedge-bench", "version": 1, "name": "magnet", "instruments": [
    {"instrument": "metrolab-thm1176", "roles": ["field-probe"], "serial": "0123456",
     "settings": {"celsius_per_count": "0.001"}})";
  if (withNmr) {
    json += R"(, {"instrument": "metrolab-pt2025", "roles": ["field-reference"], "serial": "NMR-1"})";
  }
  if (!multimeter.empty()) {
    json += R"(, {"instrument": ")" + multimeter + R"(", "roles": ["resistance"], "serial": "DMM-1"})";
  }
  if (withChamber) {
    json += R"(, {"instrument": "ascii-board", "roles": ["chamber-temperature"], "serial": "ACM-1",
                  "settings": {"temperature_column": "2"}})";
  }
  return json + "]}";
}

} // namespace straightedge::fakes
