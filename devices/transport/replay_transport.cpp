#include "devices/transport/replay_transport.h"

#include <algorithm>
#include <utility>

namespace straightedge::devices {

namespace {

std::string inQuotes(std::string_view bytes) { return "'" + escaped(bytes) + "'"; }

std::string describe(const DialogueEntry& entry) {
  switch (entry.mark) {
  case DialogueMark::Sent:
    return inQuotes(entry.bytes) + " to be sent";
  case DialogueMark::Received:
    return inQuotes(entry.bytes) + " to be read";
  case DialogueMark::Cleared:
  case DialogueMark::ClearingFailed:
    return "the transport to be cleared";
  case DialogueMark::Status:
  case DialogueMark::StatusFailed:
    return "the status byte to be asked for";
  case DialogueMark::SendingFailed:
    return "sending to fail";
  case DialogueMark::ReceivingFailed:
    return "reading to fail";
  }
  return {};
}

} // namespace

ReplayTransport::ReplayTransport(Dialogue dialogue, std::string file)
    : m_dialogue(std::move(dialogue)), m_file(std::move(file)) {}

const DialogueEntry* ReplayTransport::next() const {
  return m_next < m_dialogue.entries.size() ? &m_dialogue.entries[m_next] : nullptr;
}

std::optional<TransportError> ReplayTransport::takeFault(DialogueMark mark) {
  const DialogueEntry* entry = next();
  if (entry == nullptr || entry->mark != mark) {
    return std::nullopt;
  }
  ++m_next;
  TransportError fault = entry->fault;
  fault.error.where = name();
  return fault;
}

std::unexpected<TransportError> ReplayTransport::differs(const std::string& happened) const {
  const DialogueEntry* entry = next();
  const std::string expected =
      entry == nullptr ? "the recording ends here" : "the recording expects " + describe(*entry);
  const std::string where = entry == nullptr ? m_file : m_file + ":" + std::to_string(entry->line);
  return std::unexpected(TransportError{TransportFault::Protocol,
                                        Error{ErrorKind::Instrument, expected + ", but " + happened,
                                              "record the dialogue anew, or mend what drives the instrument", where}});
}

TransportResult<void> ReplayTransport::write(std::string_view bytes, Milliseconds /*deadline*/) {
  const DialogueEntry* entry = next();
  if (entry == nullptr || entry->mark != DialogueMark::Sent) {
    return differs(inQuotes(bytes) + " was sent");
  }
  if (entry->bytes != bytes) {
    const auto first = std::ranges::mismatch(entry->bytes, bytes).in1 - entry->bytes.begin();
    return differs(inQuotes(bytes) + " was sent, different from byte " + std::to_string(first + 1) + " on");
  }
  ++m_next;
  if (auto fault = takeFault(DialogueMark::SendingFailed)) {
    return std::unexpected(*std::move(fault));
  }
  return {};
}

TransportResult<std::string> ReplayTransport::read(Milliseconds /*deadline*/) {
  if (!m_received.empty()) {
    return m_received.takeAll();
  }
  if (auto fault = takeFault(DialogueMark::ReceivingFailed)) {
    return std::unexpected(*std::move(fault));
  }
  const DialogueEntry* entry = next();
  if (entry == nullptr || entry->mark != DialogueMark::Received) {
    return differs("a reply was read");
  }
  ++m_next;
  return entry->bytes;
}

TransportResult<std::string> ReplayTransport::readUntil(std::string_view end, Milliseconds /*deadline*/) {
  for (;;) {
    if (auto taken = m_received.takeThrough(end)) {
      return *std::move(taken);
    }
    if (auto fault = takeFault(DialogueMark::ReceivingFailed)) {
      return std::unexpected(*std::move(fault));
    }
    const DialogueEntry* entry = next();
    if (entry == nullptr || entry->mark != DialogueMark::Received) {
      return differs("a reply was read up to " + inQuotes(end) +
                     (m_received.empty() ? "" : ", of which " + std::to_string(m_received.size()) + " bytes had come"));
    }
    m_received.append(entry->bytes);
    ++m_next;
  }
}

TransportResult<void> ReplayTransport::clear() {
  if (auto fault = takeFault(DialogueMark::ClearingFailed)) {
    return std::unexpected(*std::move(fault));
  }
  const DialogueEntry* entry = next();
  if (entry == nullptr || entry->mark != DialogueMark::Cleared) {
    return differs("the transport was cleared");
  }
  ++m_next;
  m_received.clear();
  return {};
}

TransportResult<std::uint8_t> ReplayTransport::statusByte(Milliseconds /*deadline*/) {
  if (auto fault = takeFault(DialogueMark::StatusFailed)) {
    return std::unexpected(*std::move(fault));
  }
  const DialogueEntry* entry = next();
  if (entry == nullptr || entry->mark != DialogueMark::Status) {
    return differs("the status byte was asked for");
  }
  ++m_next;
  return static_cast<std::uint8_t>(entry->bytes.front());
}

Result<void> ReplayTransport::finished() const {
  if (const DialogueEntry* entry = next()) {
    return fail(ErrorKind::Instrument, "the recording expects " + describe(*entry) + ", but nothing more was done",
                "record the dialogue anew, or mend what drives the instrument",
                m_file + ":" + std::to_string(entry->line));
  }
  return {};
}

} // namespace straightedge::devices
