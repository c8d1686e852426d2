#include "devices/transport/usb_serial_transport.h"

#include "devices/transport/usb_faults.h"
#include "devices/usb/usb_handle.h"

#include <algorithm>

namespace straightedge::devices {

namespace {

// A read ends with a packet that is not full. A board that sends each line as a packet of its own fills one read with
// each: at 10,000 lines a second these are 6 ms, and what comes meanwhile waits in the board.
constexpr std::size_t postedReads = 64;
constexpr std::size_t packetsPerRead = 16;

constexpr Milliseconds emptyingTime(2000);

std::unique_ptr<UsbSerialChip> chipOf(const UsbDevice& device) {
  auto chip = ftdiChip(device);
  return chip ? std::move(chip) : cdcAcmChip(device);
}

} // namespace

bool UsbSerialTransport::canOpen(const UsbDevice& device) { return chipOf(device) != nullptr; }

TransportResult<std::unique_ptr<UsbSerialTransport>> UsbSerialTransport::open(const UsbDevice& device,
                                                                              const SerialSettings& settings) {
  const std::string name = "USB serial " + device.label();
  auto chip = chipOf(device);
  if (!chip) {
    return std::unexpected(
        TransportError{TransportFault::Unsupported, Error{ErrorKind::Instrument, "this USB device is no serial line",
                                                          "choose another connection for it", name}});
  }
  auto handle = UsbHandle::open(device, chip->interfaces());
  if (!handle) {
    return std::unexpected(transportError(std::move(handle.error()), name));
  }
  return start(std::move(*handle), name, std::move(chip), settings);
}

TransportResult<std::unique_ptr<UsbSerialTransport>> UsbSerialTransport::start(std::unique_ptr<UsbPipe> pipe,
                                                                               std::string name,
                                                                               std::unique_ptr<UsbSerialChip> chip,
                                                                               const SerialSettings& settings) {
  std::unique_ptr<UsbSerialTransport> transport(
      new UsbSerialTransport(std::move(pipe), std::move(name), std::move(chip)));
  if (const auto refused = transport->m_chip->refuses(settings); !refused.empty()) {
    return transport->failed(TransportFault::Unsupported, "the adapter refuses " + refused,
                             "choose other settings of the line");
  }
  // Listening first: a board that starts at DTR says its first words at once.
  const auto in = transport->m_chip->in();
  auto ready = transport->m_pipe->startReading(in.address, in.packetSize * packetsPerRead, postedReads);
  if (ready) {
    ready = transport->m_chip->setUp(*transport->m_pipe, settings);
  }
  if (!ready) {
    return std::unexpected(transportError(std::move(ready.error()), transport->m_name));
  }
  return transport;
}

TransportResult<void> UsbSerialTransport::write(std::string_view bytes, Milliseconds deadline) {
  const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
  const auto endpoint = m_chip->out().address;
  auto sent = m_pipe->bulkOut(endpoint, data, deadline);
  if (sent) {
    return {};
  }
  if (sent.error().fault == UsbFault::Stalled) {
    static_cast<void>(m_pipe->clearHalt(endpoint)); // the error to tell is the stall
  }
  if (sent.error().fault == UsbFault::TimedOut) {
    return failed(TransportFault::TimedOut,
                  "the line took no more bytes within the time allowed (" +
                      std::to_string(data.size() - std::min(sent.error().bytes, data.size())) + " are left to send)",
                  "check that the instrument is switched on and its flow control");
  }
  return std::unexpected(transportError(std::move(sent.error()), m_name));
}

/// At least one byte more into m_received. FTDI sends its status alone, too: such transfers are passed over, after the
/// deadline as many as can have been waiting by then.
TransportResult<void> UsbSerialTransport::receive(Clock::time_point until) {
  for (std::size_t late = 0; late <= postedReads;) {
    const auto left = std::max(Milliseconds(0), std::chrono::ceil<Milliseconds>(until - Clock::now()));
    auto came = m_pipe->nextRead(m_chip->in().address, left);
    if (!came && came.error().fault == UsbFault::TimedOut) {
      break;
    }
    if (!came) {
      return std::unexpected(transportError(std::move(came.error()), m_name));
    }
    std::string bytes;
    const auto errors = m_chip->unpack(*came, bytes);
    m_received.append(bytes);
    if (errors.overrun) {
      return failed(TransportFault::Overflow, "the adapter lost bytes: its buffer ran over",
                    "lower the instrument's rate of readings");
    }
    if (errors.any()) {
      return failed(TransportFault::Protocol,
                    errors.parity ? "bytes came with wrong parity" : "bytes came without their stop bit",
                    "check the line's settings: rate, data bits, parity");
    }
    if (!bytes.empty()) {
      return {};
    }
    late += Clock::now() >= until ? 1U : 0U;
  }
  return failed(TransportFault::TimedOut, "no answer within the time allowed",
                "check the cable, the instrument's power and the line's settings");
}

TransportResult<std::string> UsbSerialTransport::read(Milliseconds deadline) {
  const auto until = Clock::now() + deadline;
  while (m_received.empty()) {
    if (auto came = receive(until); !came) {
      return std::unexpected(std::move(came.error()));
    }
  }
  return m_received.takeAll();
}

TransportResult<std::string> UsbSerialTransport::readUntil(std::string_view end, Milliseconds deadline) {
  const auto until = Clock::now() + deadline;
  while (true) {
    if (auto taken = m_received.takeThrough(end)) {
      return *std::move(taken);
    }
    if (auto came = receive(until); !came) {
      return std::unexpected(std::move(came.error()));
    }
  }
}

TransportResult<void> UsbSerialTransport::clear() {
  if (auto emptied = m_chip->empty(*m_pipe); !emptied) {
    return std::unexpected(transportError(std::move(emptied.error()), m_name));
  }
  // A board that streams without a pause is never empty: what had come by now is what counts.
  const auto until = Clock::now() + emptyingTime;
  while (Clock::now() < until) {
    auto old = m_pipe->nextRead(m_chip->in().address, Milliseconds(0));
    if (!old && old.error().fault == UsbFault::TimedOut) {
      break;
    }
    if (!old) {
      return std::unexpected(transportError(std::move(old.error()), m_name));
    }
  }
  m_received.clear();
  return {};
}

TransportResult<void> UsbSerialTransport::setControlLines(bool dtr, bool rts) {
  auto set = m_chip->setControlLines(*m_pipe, dtr, rts);
  if (!set) {
    return std::unexpected(transportError(std::move(set.error()), m_name));
  }
  return {};
}

std::unexpected<TransportError> UsbSerialTransport::failed(TransportFault fault, std::string what,
                                                           std::string remedy) const {
  return std::unexpected(
      TransportError{fault, Error{ErrorKind::Instrument, std::move(what), std::move(remedy), m_name}});
}

} // namespace straightedge::devices
