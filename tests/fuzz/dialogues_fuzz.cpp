// Recorded dialogues: read, written and read again they are the same; replayed they end.
#include "devices/transport/dialogue.h"
#include "devices/transport/replay_transport.h"
#include "tests/fuzz/promise.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

using namespace straightedge::devices;

namespace {

void replay(const Dialogue& dialogue) {
  ReplayTransport transport(dialogue, "log");
  for (const DialogueEntry& entry : dialogue.entries) {
    switch (entry.mark) {
    case DialogueMark::Sent:
      static_cast<void>(transport.write(entry.bytes, Milliseconds{0})); // its outcome is what was recorded, good or bad
      break;
    case DialogueMark::Received:
      static_cast<void>(transport.readUntil("\n", Milliseconds{0}));
      break;
    default:
      static_cast<void>(transport.clear());
      static_cast<void>(transport.statusByte(Milliseconds{0}));
      break;
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  promise(unescaped(escaped(text)) == text, "every byte comes back");
  const auto dialogue = parseDialogue(text, "log");
  if (!dialogue) {
    return 0;
  }
  std::string again = "straightedge-dialogue 1\n";
  for (const DialogueEntry& entry : dialogue->entries) {
    again += dialogueLine(entry);
  }
  const auto second = parseDialogue(again, "log");
  promise(second.has_value(), "what is written can be read");
  promise(second->entries.size() == dialogue->entries.size(), "as many exchanges");
  for (std::size_t i = 0; i < dialogue->entries.size(); ++i) {
    promise(second->entries[i].mark == dialogue->entries[i].mark, "the same marks");
    promise(second->entries[i].bytes == dialogue->entries[i].bytes, "the same bytes");
    promise(second->entries[i].fault.error.what == dialogue->entries[i].fault.error.what, "the same faults");
  }
  replay(*dialogue);
  return 0;
}
