// Plays a recorded dialogue: for tests, and to run a bug report again without the instrument.
#pragma once

#include "devices/transport/byte_buffer.h"
#include "devices/transport/dialogue.h"

namespace straightedge::devices {

/// What the program does must be what was recorded, in the same order; it answers at once, whatever the times say, and
/// recorded faults come again. Errors: Protocol, where = FILE:LINE, with what was expected and what happened instead.
class ReplayTransport : public Transport {
public:
  /// `file` is the dialogue's name in messages.
  ReplayTransport(Dialogue dialogue, std::string file);

  std::string name() const override { return m_dialogue.transportName; }
  bool hasMessages() const override { return m_dialogue.hasMessages; }
  TransportResult<void> write(std::string_view bytes, Milliseconds deadline) override;
  TransportResult<std::string> read(Milliseconds deadline) override;
  TransportResult<std::string> readUntil(std::string_view end, Milliseconds deadline) override;
  TransportResult<void> clear() override;
  TransportResult<std::uint8_t> statusByte(Milliseconds deadline) override;

  /// Whether everything was played. Errors (Instrument): FILE:LINE of the first exchange that was not.
  Result<void> finished() const;

private:
  const DialogueEntry* next() const;
  std::optional<TransportError> takeFault(DialogueMark mark);
  std::unexpected<TransportError> differs(const std::string& happened) const;

  Dialogue m_dialogue;
  std::string m_file;
  std::size_t m_next = 0;
  ByteBuffer m_received;
};

} // namespace straightedge::devices
