// Abort and clear, after USBTMC 1.0 section 4.2.1 as Linux drivers/usb/class/usbtmc.c carries it out.
#include "devices/transport/usb_faults.h"
#include "devices/transport/usbtmc_deadline.h"

#include <thread>

namespace straightedge::devices {

namespace {

/// For a packet that the device should have ready.
Milliseconds drainTime(Milliseconds recoveryTime) { return recoveryTime / 5; }

} // namespace

UsbResult<std::size_t> UsbTmcTransport::ask(std::uint8_t to, usbtmc::Request request, std::uint16_t value,
                                            std::uint16_t index, std::span<std::uint8_t> answer,
                                            Milliseconds deadline) {
  return m_pipe->control(
      {.requestType = to, .request = static_cast<std::uint8_t>(request), .value = value, .index = index}, answer,
      deadline);
}

void UsbTmcTransport::drainIn() {
  const std::size_t packet = std::max<std::size_t>(1, m_channel.in.packetSize);
  m_in.resize(std::max(m_in.size(), packet));
  const Deadline deadline(m_options.recoveryTime);
  while (deadline.left() > Milliseconds(0)) {
    const auto bytes =
        m_pipe->bulkIn(m_channel.in.address, m_in, std::min(drainTime(m_options.recoveryTime), deadline.left()));
    if (!bytes && (bytes.error().fault == UsbFault::Stalled || bytes.error().fault == UsbFault::Overflow)) {
      static_cast<void>(m_pipe->clearHalt(m_channel.in.address)); // the next read tells whether it helped
      return;
    }
    if (!bytes || *bytes % packet != 0 || *bytes == 0) {
      return; // the short packet, or nothing
    }
  }
}

void UsbTmcTransport::awaitEndOfAbort(usbtmc::Request check, std::uint8_t endpoint) {
  const Deadline deadline(m_options.recoveryTime);
  while (deadline.left() > Milliseconds(0)) {
    std::array<std::uint8_t, 8> status{};
    const auto size = ask(usbtmc::toEndpoint, check, 0, endpoint, status, deadline.left());
    if (!size || *size == 0 || status[0] != usbtmc::statusPending) {
      return;
    }
    if (check == usbtmc::Request::CheckAbortBulkInStatus && (status[1] & 1U) != 0) {
      drainIn();
    } else {
      std::this_thread::sleep_for(Milliseconds(1));
    }
  }
}

void UsbTmcTransport::abortIn(std::uint8_t tag) {
  const auto endpoint = m_channel.in.address;
  std::array<std::uint8_t, 2> status{};
  const auto size =
      ask(usbtmc::toEndpoint, usbtmc::Request::InitiateAbortBulkIn, tag, endpoint, status, m_options.recoveryTime);
  // 0x80: nothing is under way. 0x81: another tag is; TinyUSB says so of every tag above 127. The clear before the next
  // message settles both.
  if (!size || *size == 0 || status[0] != usbtmc::statusSuccess) {
    return;
  }
  drainIn();
  awaitEndOfAbort(usbtmc::Request::CheckAbortBulkInStatus, endpoint);
}

void UsbTmcTransport::abortOut(std::uint8_t tag) {
  const auto endpoint = m_channel.out.address;
  std::array<std::uint8_t, 2> status{};
  const auto size =
      ask(usbtmc::toEndpoint, usbtmc::Request::InitiateAbortBulkOut, tag, endpoint, status, m_options.recoveryTime);
  if (size && *size > 0 && status[0] == usbtmc::statusSuccess) {
    awaitEndOfAbort(usbtmc::Request::CheckAbortBulkOutStatus, endpoint);
  }
  static_cast<void>(m_pipe->clearHalt(endpoint)); // the device halts it at the end of the abort
}

TransportResult<void> UsbTmcTransport::clear() {
  if (m_options.quirks.noClear) {
    clearByReading();
    return {};
  }
  forgetReply();
  return clearByRequest();
}

TransportResult<void> UsbTmcTransport::clearByRequest() {
  std::array<std::uint8_t, 1> begun{};
  auto size = ask(usbtmc::toInterface, usbtmc::Request::InitiateClear, 0, m_channel.interfaceNumber, begun,
                  m_options.recoveryTime);
  if (!size) {
    return failed(std::move(size.error()));
  }
  if (*size == 0 || begun[0] != usbtmc::statusSuccess) {
    return misused("the device refused to be cleared", "switch it off and on");
  }
  const Deadline deadline(m_options.recoveryTime);
  while (true) {
    std::array<std::uint8_t, 2> status{};
    size = ask(usbtmc::toInterface, usbtmc::Request::CheckClearStatus, 0, m_channel.interfaceNumber, status,
               m_options.recoveryTime);
    if (!size) {
      return failed(std::move(size.error()));
    }
    if (*size == 0 || status[0] != usbtmc::statusPending) {
      break;
    }
    if (deadline.left() == Milliseconds(0)) {
      return std::unexpected(TransportError{
          TransportFault::TimedOut,
          Error{ErrorKind::Instrument, "the device does not finish being cleared", "switch it off and on", m_name}});
    }
    if ((status[1] & 1U) != 0) {
      drainIn();
    } else {
      std::this_thread::sleep_for(Milliseconds(1));
    }
  }
  auto cleared = m_pipe->clearHalt(m_channel.out.address); // the device halts it during a clear
  if (!cleared) {
    return failed(std::move(cleared.error()));
  }
  m_stale = false;
  return {};
}

void UsbTmcTransport::clearByReading() {
  const Deadline deadline(m_options.recoveryTime);
  while (!m_unansweredQuery.empty() && !m_ended && receivePart(nullptr, deadline)) {
    m_received.clear();
  }
  forgetReply();
  m_stale = false;
}

} // namespace straightedge::devices
