// Boards with a serial line of their own: USB CDC PSTN 1.2, section 6.3.
#include "devices/transport/usb_serial_chip.h"

#include <algorithm>
#include <array>

namespace straightedge::devices {

namespace {

constexpr std::chrono::milliseconds cdcRequestTime(5000);
constexpr std::uint8_t communicationsClass = 0x02;
constexpr std::uint8_t abstractControl = 0x02;
constexpr std::uint8_t dataClass = 0x0A;
constexpr std::uint8_t toCdcInterface = 0x21; ///< class, interface, from the computer
constexpr std::uint8_t setLineCoding = 0x20;
constexpr std::uint8_t setControlLineState = 0x22;

class CdcAcmChip final : public UsbSerialChip {
public:
  CdcAcmChip(std::uint8_t control, const UsbInterface& data)
      : m_control(control), m_data(data.number), m_in(*data.find(UsbEndpointType::Bulk, true)),
        m_out(*data.find(UsbEndpointType::Bulk, false)) {}

  std::vector<std::uint8_t> interfaces() const override { return {m_control, m_data}; }
  UsbEndpoint in() const override { return m_in; }
  UsbEndpoint out() const override { return m_out; }

  std::string refuses(const SerialSettings& settings) const override {
    return settings.flow == FlowControl::None ? "" : "flow control";
  }

  UsbResult<void> setUp(UsbPipe& pipe, const SerialSettings& settings) override {
    const auto baud = static_cast<std::uint32_t>(settings.baud);
    const auto byte = [baud](unsigned shift) { return static_cast<std::uint8_t>((baud >> shift) & 0xFFU); };
    std::array<std::uint8_t, 7> coding = {
        byte(0),
        byte(8),
        byte(16),
        byte(24),
        static_cast<std::uint8_t>(settings.stopBits == 2 ? 2 : 0),
        static_cast<std::uint8_t>(settings.parity == Parity::None ? 0 : (settings.parity == Parity::Odd ? 1 : 2)),
        static_cast<std::uint8_t>(settings.dataBits)};
    auto set = pipe.control({.requestType = toCdcInterface, .request = setLineCoding, .value = 0, .index = m_control},
                            coding, cdcRequestTime);
    // A board without a real line behind it may refuse to hear of its rate.
    if (!set && set.error().fault != UsbFault::Stalled) {
      return std::unexpected(std::move(set.error()));
    }
    return setControlLines(pipe, settings.dtr, settings.rts);
  }

  UsbResult<void> setControlLines(UsbPipe& pipe, bool dtr, bool rts) override {
    const auto lines = static_cast<std::uint16_t>((dtr ? 1 : 0) | (rts ? 2 : 0));
    auto set = pipe.control(
        {.requestType = toCdcInterface, .request = setControlLineState, .value = lines, .index = m_control}, {},
        cdcRequestTime);
    if (!set && set.error().fault != UsbFault::Stalled) {
      return std::unexpected(std::move(set.error()));
    }
    return {};
  }

  UsbResult<void> empty(UsbPipe& /*pipe*/) override { return {}; }

  LineErrors unpack(std::span<const std::uint8_t> transfer, std::string& bytes) const override {
    bytes.append(transfer.begin(), transfer.end());
    return {};
  }

private:
  std::uint8_t m_control;
  std::uint8_t m_data;
  UsbEndpoint m_in;
  UsbEndpoint m_out;
};

} // namespace

std::unique_ptr<UsbSerialChip> cdcAcmChip(const UsbDevice& device) {
  const auto* control = device.findInterface(communicationsClass, abstractControl);
  if (control == nullptr) {
    return nullptr;
  }
  const auto data = std::ranges::find_if(device.interfaces, [&](const UsbInterface& i) {
    return i.classCode == dataClass && i.number > control->number && i.find(UsbEndpointType::Bulk, true) != nullptr &&
           i.find(UsbEndpointType::Bulk, false) != nullptr;
  });
  if (data == device.interfaces.end()) {
    return nullptr;
  }
  return std::make_unique<CdcAcmChip>(control->number, *data);
}

} // namespace straightedge::devices
