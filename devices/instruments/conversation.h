// Commands and replies of one instrument on its transport: sending, asking, and staying in step after a fault.
#pragma once

#include "devices/instruments/angle_instruments.h"
#include "devices/transport/transport.h"

#include <optional>
#include <string>
#include <string_view>

namespace straightedge::devices {

struct ConversationStyle {
  std::string commandEnd = "\n"; ///< appended to every command
  std::string replyEnd = "\n";   ///< ends a reply where the transport has no messages; taken off
  Milliseconds deadline{1000};   ///< for a command and for its reply
};

/// A reply and when it was asked for: halfway between sending and receiving, on the bench's clock.
struct TimedReply {
  std::string text;
  double timeS = 0.0;
};

/// After a fault a late reply may still be on its way. The next command first clears the transport, so that it is
/// answered by its own reply. Blanks and line ends around a reply are taken off. Errors (Instrument) name the command.
/// One thread.
class Conversation {
public:
  Conversation(Transport& transport, const BenchClock& clock, ConversationStyle style);

  Result<void> send(std::string_view command);
  Result<TimedReply> ask(std::string_view command) { return ask(command, m_style.deadline); }
  Result<TimedReply> ask(std::string_view command, Milliseconds deadline);
  Result<TimedReply> receive(Milliseconds deadline); ///< a reply that was asked for otherwise

  /// For replies that came and cannot be what was asked for: clears before the next command.
  std::unexpected<Error> misunderstood(std::string_view command, std::string_view reply, std::string_view expected);
  /// An error that the instrument reports, or a reply that says there is no reading; the line is in step.
  std::unexpected<Error> refused(std::string what, std::string remedy);

  Result<void> clear();
  Transport& transport() { return m_transport; }
  const BenchClock& clock() const { return m_clock; }
  std::optional<TransportFault> lastFault() const { return m_lastFault; }

  /// Passes a transport's error on and remembers its fault. `doing`: "after '*IDN?'", may be empty.
  std::unexpected<Error> failed(const TransportError& error, std::string_view doing);

private:
  Result<void> begin();
  Result<TimedReply> receiveAfter(std::string_view doing, Milliseconds deadline, double sentS);

  Transport& m_transport;
  const BenchClock& m_clock;
  ConversationStyle m_style;
  bool m_outOfStep = false;
  std::optional<TransportFault> m_lastFault;
};

/// Text without blanks and line ends around it.
std::string_view withoutBlanks(std::string_view text);

/// At most 60 bytes of `text`, unprintable ones escaped, in quotes.
std::string shown(std::string_view text);

} // namespace straightedge::devices
