#include "devices/instruments/conversation.h"

#include "devices/transport/dialogue.h"

#include <utility>

namespace straightedge::devices {

Conversation::Conversation(Transport& transport, const BenchClock& clock, ConversationStyle style)
    : m_transport(transport), m_clock(clock), m_style(std::move(style)) {}

std::unexpected<Error> Conversation::failed(const TransportError& error, std::string_view doing) {
  m_lastFault = error.fault;
  m_outOfStep = true;
  Error passed = error.error;
  if (!doing.empty()) {
    passed.what += " ";
    passed.what += doing;
  }
  return std::unexpected(std::move(passed));
}

std::unexpected<Error> Conversation::misunderstood(std::string_view command, std::string_view reply,
                                                   std::string_view expected) {
  m_lastFault.reset();
  m_outOfStep = true;
  return fail(ErrorKind::Instrument,
              "the reply to " + shown(command) + " is " + shown(reply) + " instead of " + std::string(expected),
              "check the cable and the line's settings, and whether this is the instrument it is taken for",
              m_transport.name());
}

std::unexpected<Error> Conversation::refused(std::string what, std::string remedy) {
  m_lastFault.reset();
  return fail(ErrorKind::Instrument, std::move(what), std::move(remedy), m_transport.name());
}

Result<void> Conversation::clear() {
  if (auto cleared = m_transport.clear(); !cleared && cleared.error().fault != TransportFault::Unsupported) {
    return failed(cleared.error(), "while clearing the line");
  }
  m_outOfStep = false;
  return {};
}

Result<void> Conversation::begin() {
  m_lastFault.reset();
  return m_outOfStep ? clear() : Result<void>{};
}

Result<void> Conversation::send(std::string_view command) {
  if (auto begun = begin(); !begun) {
    return begun;
  }
  const std::string bytes = std::string(command) + m_style.commandEnd;
  if (auto sent = m_transport.write(bytes, m_style.deadline); !sent) {
    return failed(sent.error(), "while sending " + shown(command));
  }
  return {};
}

Result<TimedReply> Conversation::ask(std::string_view command, Milliseconds deadline) {
  if (auto sent = send(command); !sent) {
    return std::unexpected(std::move(sent.error()));
  }
  return receiveAfter("after " + shown(command), deadline, m_clock.nowS());
}

Result<TimedReply> Conversation::receive(Milliseconds deadline) {
  m_lastFault.reset();
  return receiveAfter({}, deadline, m_clock.nowS());
}

Result<TimedReply> Conversation::receiveAfter(std::string_view doing, Milliseconds deadline, double sentS) {
  auto reply =
      m_transport.hasMessages() ? m_transport.read(deadline) : m_transport.readUntil(m_style.replyEnd, deadline);
  if (!reply) {
    return failed(reply.error(), doing);
  }
  return TimedReply{std::string(withoutBlanks(*reply)), (sentS + m_clock.nowS()) / 2};
}

std::string_view withoutBlanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  return "'" + escaped(text.substr(0, longest)) + (text.size() > longest ? "…'" : "'");
}

} // namespace straightedge::devices
