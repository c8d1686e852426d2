// Status byte, service request, trigger: USB488 1.0.
#include "devices/transport/usb_faults.h"
#include "devices/transport/usbtmc_deadline.h"

namespace straightedge::devices {

void UsbTmcTransport::takeNotifications() {
  while (true) {
    const auto notification = m_pipe->nextRead(m_channel.interrupt->address, Milliseconds(0));
    if (!notification) {
      return; // none waits; if the endpoint broke, waiting for the answer tells
    }
    if (notification->size() >= 2 && notification->front() == usbtmc::serviceRequest) {
      m_serviceRequests.push_back(notification->at(1));
    }
  }
}

TransportResult<std::uint8_t> UsbTmcTransport::statusByte(Milliseconds time) {
  const Deadline deadline(time);
  if (m_channel.interrupt) {
    takeNotifications(); // a read has to be posted: without one the THM1176 refuses (manual p. 45)
  }
  m_statusTag = static_cast<std::uint8_t>(m_statusTag >= 127 ? 2 : m_statusTag + 1);
  std::array<std::uint8_t, 3> answer{};
  auto size = ask(usbtmc::toInterface, usbtmc::Request::ReadStatusByte, m_statusTag, m_channel.interfaceNumber, answer,
                  deadline.left());
  if (!size) {
    return failed(std::move(size.error()));
  }
  if (*size < answer.size() || answer[0] != usbtmc::statusSuccess || answer[1] != m_statusTag) {
    return misused("the device does not tell its status byte (it says " + std::to_string(answer[0]) + ")",
                   "ask for it with *STB?");
  }
  return m_channel.interrupt ? notifiedStatus(m_statusTag, deadline) : TransportResult<std::uint8_t>(answer[2]);
}

TransportResult<std::uint8_t> UsbTmcTransport::notifiedStatus(std::uint8_t tag, const Deadline& deadline) {
  while (true) {
    auto notification = m_pipe->nextRead(m_channel.interrupt->address, deadline.left());
    if (!notification) {
      return failed(std::move(notification.error()));
    }
    if (notification->size() < 2) {
      continue;
    }
    if (notification->front() == usbtmc::serviceRequest) {
      m_serviceRequests.push_back(notification->at(1));
    } else if (notification->front() == (0x80U | tag)) {
      return notification->at(1);
    }
  }
}

TransportResult<std::uint8_t> UsbTmcTransport::waitForServiceRequest(Milliseconds time) {
  const Deadline deadline(time);
  if (!m_channel.interrupt) {
    return std::unexpected(
        TransportError{TransportFault::Unsupported, Error{ErrorKind::Instrument, "the device cannot request service",
                                                          "ask for its status byte instead", m_name}});
  }
  while (m_serviceRequests.empty()) {
    auto notification = m_pipe->nextRead(m_channel.interrupt->address, deadline.left());
    if (!notification) {
      return failed(std::move(notification.error()));
    }
    if (notification->size() >= 2 && notification->front() == usbtmc::serviceRequest) {
      m_serviceRequests.push_back(notification->at(1));
    }
  }
  const auto status = m_serviceRequests.front();
  m_serviceRequests.pop_front();
  return status;
}

TransportResult<void> UsbTmcTransport::trigger(Milliseconds time) {
  if (!m_capabilities.trigger) {
    return std::unexpected(
        TransportError{TransportFault::Unsupported, Error{ErrorKind::Instrument, "the device knows no trigger over USB",
                                                          "trigger it with *TRG", m_name}});
  }
  m_tag = usbtmc::nextTag(m_tag);
  return sendHeader(usbtmc::triggerHeader(m_tag), Deadline(time));
}

} // namespace straightedge::devices
