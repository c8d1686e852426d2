// Requests of the USBTMC device on endpoint 0: abort, clear, status byte, capabilities.
#include "tests/fakes/usb/usbtmc_device.h"

namespace straightedge::fakes {

namespace {

constexpr std::uint8_t success = 0x01;
constexpr std::uint8_t pending = 0x02;
constexpr std::uint8_t failed = 0x80;
constexpr std::uint8_t notInProgress = 0x81;

} // namespace

void UsbTmcDevice::expectLength(const ControlSetup& setup, std::uint16_t length) {
  if (setup.length != length) {
    violation("request " + std::to_string(setup.request) + " with wLength " + std::to_string(setup.length) +
              " instead of " + std::to_string(length));
  }
}

std::optional<Bytes> UsbTmcDevice::control(const ControlSetup& setup, const Bytes& /*data*/) {
  if (setup.requestType == 0xA2) { // class, endpoint
    switch (setup.request) {
    case 1:
    case 2:
      return abortOut(setup);
    case 3:
      return initiateAbortIn(setup);
    case 4:
      return checkAbortIn(setup);
    default:
      return std::nullopt;
    }
  }
  if (setup.requestType != 0xA1) { // class, interface
    return std::nullopt;
  }
  switch (setup.request) {
  case 5:
  case 6:
    return clearRequest(setup);
  case 7: {
    expectLength(setup, 0x18);
    Bytes capabilities(0x18, 0);
    capabilities[0] = success;
    capabilities[3] = 1; // bcdUSBTMC 1.00
    capabilities[5] = m_options.termChar ? 1 : 0;
    capabilities[13] = 1;
    capabilities[14] = m_options.interruptEndpoint ? 7 : 0; // USB488.2, REN_CONTROL, TRIGGER
    capabilities[15] = m_options.interruptEndpoint ? 0x0F : 0;
    return capabilities;
  }
  case 128:
    return statusByteRequest(setup);
  case 160:
    expectLength(setup, 1);
    m_remote = setup.value != 0;
    return Bytes{success};
  case 161:
    expectLength(setup, 1);
    m_remote = false;
    return Bytes{success};
  default:
    return std::nullopt;
  }
}

std::optional<Bytes> UsbTmcDevice::initiateAbortIn(const ControlSetup& setup) {
  expectLength(setup, 2);
  if (setup.index != in) {
    violation("abort of endpoint " + std::to_string(setup.index));
  }
  const auto tag = static_cast<std::uint8_t>(setup.value & (m_options.answersTagsOf7Bits ? 0x7FU : 0xFFU));
  m_abortedTags.push_back(setup.value);
  if (!m_reading && !hasQueued(in)) {
    return Bytes{failed, m_readTag};
  }
  if (tag != m_readTag) {
    return Bytes{notInProgress, m_readTag};
  }
  m_aborting = true;
  dropQueued(in);      // an answer that is not ready yet stays due: the host has to clear before it asks anew
  queuePacket(in, {}); // the short packet that ends the transfer
  return Bytes{success, m_readTag};
}

std::optional<Bytes> UsbTmcDevice::checkAbortIn(const ControlSetup& setup) {
  expectLength(setup, 8);
  if (hasQueued(in)) {
    if (m_pendingAnswers == 0) {
      return Bytes{pending, 1, 0, 0, 0, 0, 0, 0}; // bytes wait to be read
    }
  }
  if (m_pendingAnswers > 0) {
    --m_pendingAnswers;
    return Bytes{pending, static_cast<std::uint8_t>(hasQueued(in) ? 1 : 0), 0, 0, 0, 0, 0, 0};
  }
  m_aborting = false;
  m_reading = false;
  return Bytes{success, 0, 0, 0, 0, 0, 0, 0};
}

std::optional<Bytes> UsbTmcDevice::abortOut(const ControlSetup& setup) {
  if (setup.index != out) {
    violation("abort of endpoint " + std::to_string(setup.index));
  }
  if (setup.request == 1) {
    m_abortedOutTags.push_back(setup.value);
    expectLength(setup, 2);
    if (!m_neverTaking && m_transfer.empty()) {
      return Bytes{failed, m_lastTag.value_or(0)};
    }
    m_lastTag = static_cast<std::uint8_t>(setup.value);
    m_neverTaking = false;
    m_transfer.clear();
    m_message.clear();
    m_aborting = true;
    return Bytes{success, static_cast<std::uint8_t>(setup.value)};
  }
  expectLength(setup, 8);
  m_aborting = false;
  halt(out); // until CLEAR_FEATURE
  return Bytes{success, 0, 0, 0, 0, 0, 0, 0};
}

std::optional<Bytes> UsbTmcDevice::clearRequest(const ControlSetup& setup) {
  if (setup.request == 5) {
    expectLength(setup, 1);
    if (m_options.clearHangs) {
      return std::nullopt;
    }
    const bool leavesBytes = m_fault == UsbTmcFault::ClearStaysPending;
    dropAll();
    m_neverTaking = false;
    m_clearing = true;
    if (leavesBytes) {
      m_fault = UsbTmcFault::None;
      m_pendingAnswers = 3;
      queueIn(in, Bytes(m_options.packet + 7, 'z'));
    }
    return Bytes{success};
  }
  expectLength(setup, 2);
  if (!m_clearing) {
    violation("CHECK_CLEAR_STATUS without INITIATE_CLEAR");
  }
  if (m_pendingAnswers > 0 || hasQueued(in)) {
    m_pendingAnswers -= m_pendingAnswers > 0 ? 1 : 0;
    return Bytes{pending, static_cast<std::uint8_t>(hasQueued(in) ? 1 : 0)};
  }
  m_clearing = false;
  ++m_clears;
  halt(out); // until CLEAR_FEATURE
  return Bytes{success, 0};
}

std::optional<Bytes> UsbTmcDevice::statusByteRequest(const ControlSetup& setup) {
  expectLength(setup, 3);
  const auto tag = static_cast<std::uint8_t>(setup.value);
  if (setup.value < 2 || setup.value > 127) {
    violation("status tag " + std::to_string(setup.value));
  }
  if (tag == m_lastStatusTag) {
    violation("the same status tag twice");
  }
  m_lastStatusTag = tag;
  if (takeFault(UsbTmcFault::StatusFails)) {
    return Bytes{failed, tag, 0};
  }
  if (!m_options.interruptEndpoint) {
    return Bytes{success, tag, m_status};
  }
  if (!isReadPosted(interrupt)) {
    violation("READ_STATUS_BYTE without a read posted on the interrupt endpoint");
    return Bytes{failed, tag, 0};
  }
  queuePacket(interrupt, {static_cast<std::uint8_t>(0x80U | tag), m_status});
  return Bytes{success, tag, 0};
}

} // namespace straightedge::fakes
