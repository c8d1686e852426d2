// FTDI adapters. FTDI publishes no protocol; requests, divisors and status bytes as Linux drivers/usb/serial/ftdi_sio.c
// and libftdi 1.5 carry them out.
#include "devices/transport/usb_serial_chip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace straightedge::devices {

namespace {

constexpr std::chrono::milliseconds ftdiRequestTime(5000);
constexpr std::uint16_t ftdiVendor = 0x0403;
constexpr std::uint8_t toFtdiDevice = 0x40; ///< vendor, device, from the computer
constexpr std::size_t statusBytes = 2;      ///< before the data of every packet
constexpr std::uint16_t latencyMs = 2;      ///< until a packet that is not full is sent; 16 after a reset

enum class FtdiRequest : std::uint8_t {
  Reset = 0,
  ModemControl = 1,
  FlowControl = 2,
  BaudRate = 3,
  Data = 4,
  Latency = 9
};

constexpr std::uint16_t resetChip = 0;
constexpr std::uint16_t purgeReceived = 1;
constexpr std::uint16_t purgeToSend = 2;

struct Divisor {
  std::uint32_t bits = 0; ///< 14 bits, then 3 for the eighths
  double baud = 0.0;      ///< what comes of it
};

/// From `clock`/8: whole and eighths; FT232R: 3 MHz, the H types: 12 MHz.
std::optional<Divisor> divisorFor(int baud, double clockHz) {
  constexpr std::array<std::uint32_t, 8> codes = {0, 3, 2, 4, 1, 5, 6, 7};
  if (baud <= 0) {
    return std::nullopt;
  }
  const auto eighths = static_cast<std::uint32_t>(std::lround(clockHz * 8 / baud));
  if (eighths < 8 || eighths > 0x3FFFU * 8 + 7) {
    return std::nullopt;
  }
  Divisor divisor{.bits = (eighths >> 3U) | (codes.at(eighths & 7U) << 14U), .baud = clockHz * 8 / eighths};
  if (eighths == 8) { // the two fastest have divisors of their own
    divisor.bits = 0;
  } else if (eighths == 12) {
    divisor.bits = 1;
  } else if (eighths < 16) {
    return std::nullopt; // no fraction below 2 but 1.5
  }
  return divisor;
}

class FtdiChip final : public UsbSerialChip {
public:
  FtdiChip(const UsbInterface& interface, std::uint16_t release, bool manyPorts)
      : m_interface(interface.number), m_in(*interface.find(UsbEndpointType::Bulk, true)),
        m_out(*interface.find(UsbEndpointType::Bulk, false)),
        m_isHighSpeed(release == 0x0700 || release == 0x0800 || release == 0x0900),
        m_port(static_cast<std::uint16_t>(manyPorts || m_isHighSpeed ? interface.number + 1 : 0)) {}

  std::vector<std::uint8_t> interfaces() const override { return {m_interface}; }
  UsbEndpoint in() const override { return m_in; }
  UsbEndpoint out() const override { return m_out; }

  std::string refuses(const SerialSettings& settings) const override {
    const auto divisor = divisorFor(settings.baud, clockHz());
    if (!divisor || std::abs(divisor->baud / settings.baud - 1) > 0.03) {
      return std::to_string(settings.baud) + " baud";
    }
    if (settings.dataBits != 7 && settings.dataBits != 8) {
      return std::to_string(settings.dataBits) + " data bits";
    }
    return {};
  }

  UsbResult<void> setUp(UsbPipe& pipe, const SerialSettings& settings) override {
    auto done = request(pipe, FtdiRequest::Reset, resetChip);
    if (done) {
      done = request(pipe, FtdiRequest::Latency, latencyMs);
    }
    if (done) {
      done = setRate(pipe, settings.baud);
    }
    if (done) {
      const unsigned parity = settings.parity == Parity::None ? 0U : (settings.parity == Parity::Odd ? 1U : 2U);
      const unsigned stop = settings.stopBits == 2 ? 2U : 0U;
      const auto bits = static_cast<unsigned>(settings.dataBits);
      done = request(pipe, FtdiRequest::Data, static_cast<std::uint16_t>(bits | parity << 8U | stop << 11U));
    }
    if (done) {
      done = setFlow(pipe, settings.flow);
    }
    if (done) {
      done = setControlLines(pipe, settings.dtr, settings.rts);
    }
    return done;
  }

  UsbResult<void> setControlLines(UsbPipe& pipe, bool dtr, bool rts) override {
    const unsigned levels = (dtr ? 1U : 0U) | (rts ? 2U : 0U);
    return request(pipe, FtdiRequest::ModemControl, static_cast<std::uint16_t>(0x300U | levels));
  }

  UsbResult<void> empty(UsbPipe& pipe) override {
    auto done = request(pipe, FtdiRequest::Reset, purgeReceived);
    return done ? request(pipe, FtdiRequest::Reset, purgeToSend) : done;
  }

  LineErrors unpack(std::span<const std::uint8_t> transfer, std::string& bytes) const override {
    LineErrors errors;
    const std::size_t packet = std::max<std::size_t>(statusBytes + 1, m_in.packetSize);
    for (std::size_t from = 0; from + statusBytes <= transfer.size(); from += packet) {
      const auto one = transfer.subspan(from, std::min(packet, transfer.size() - from));
      errors.overrun = errors.overrun || (one[1] & 0x02U) != 0;
      errors.parity = errors.parity || (one[1] & 0x04U) != 0;
      errors.framing = errors.framing || (one[1] & 0x08U) != 0;
      bytes.append(one.begin() + statusBytes, one.end());
    }
    return errors;
  }

private:
  double clockHz() const { return m_isHighSpeed ? 12e6 : 3e6; }

  UsbResult<void> request(UsbPipe& pipe, FtdiRequest what, std::uint16_t value, std::uint16_t indexHigh = 0) const {
    const auto index = static_cast<std::uint16_t>(indexHigh | m_port);
    auto done = pipe.control(
        {.requestType = toFtdiDevice, .request = static_cast<std::uint8_t>(what), .value = value, .index = index}, {},
        ftdiRequestTime);
    if (!done) {
      return std::unexpected(std::move(done.error()));
    }
    return {};
  }

  UsbResult<void> setRate(UsbPipe& pipe, int baud) const {
    auto bits = divisorFor(baud, clockHz())->bits; // refuses() has seen to it
    if (m_isHighSpeed) {
      bits |= 0x20000U; // from 120 MHz / 10
    }
    const auto high = static_cast<std::uint16_t>(bits >> 16U);
    return request(pipe, FtdiRequest::BaudRate, static_cast<std::uint16_t>(bits & 0xFFFFU),
                   m_port == 0 ? high : static_cast<std::uint16_t>(high << 8U));
  }

  UsbResult<void> setFlow(UsbPipe& pipe, FlowControl flow) const {
    constexpr std::uint16_t xonXoff = 0x1311; // XOFF, XON
    switch (flow) {
    case FlowControl::RtsCts:
      return request(pipe, FtdiRequest::FlowControl, 0, 0x0100);
    case FlowControl::XonXoff:
      return request(pipe, FtdiRequest::FlowControl, xonXoff, 0x0400);
    case FlowControl::None:
      break;
    }
    return request(pipe, FtdiRequest::FlowControl, 0);
  }

  std::uint8_t m_interface;
  UsbEndpoint m_in;
  UsbEndpoint m_out;
  bool m_isHighSpeed;   ///< FT2232H, FT4232H, FT232H
  std::uint16_t m_port; ///< 1 … where the chip has several, else 0
};

} // namespace

std::unique_ptr<UsbSerialChip> ftdiChip(const UsbDevice& device) {
  // The class codes say "vendor specific" only: what is not FTDI's own number is not taken for one.
  if (device.vendorId != ftdiVendor) {
    return nullptr;
  }
  const auto it = std::ranges::find_if(device.interfaces, [](const UsbInterface& i) {
    return i.classCode == 0xFF && i.find(UsbEndpointType::Bulk, true) != nullptr &&
           i.find(UsbEndpointType::Bulk, false) != nullptr;
  });
  if (it == device.interfaces.end()) {
    return nullptr;
  }
  return std::make_unique<FtdiChip>(*it, device.release, device.interfaces.size() > 1);
}

} // namespace straightedge::devices
