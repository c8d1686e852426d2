#include "devices/transport/dialogue.h"
#include "devices/transport/recording_transport.h"
#include "devices/transport/replay_transport.h"

#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <unistd.h>

namespace straightedge::devices {
namespace {

namespace fs = std::filesystem;

constexpr Milliseconds anyTime{100};

TransportError fault(TransportFault kind, const char* what) {
  return {kind, Error{ErrorKind::Instrument, what, "plug it in; again", "somewhere"}};
}

/// Answers what it was told to, and remembers what it was sent.
class ScriptedTransport : public Transport {
public:
  std::deque<TransportResult<std::string>> replies;
  std::deque<TransportResult<void>> outcomes;
  std::vector<std::string> sent;

  std::string name() const override { return "fake \\ line"; }
  bool hasMessages() const override { return true; }
  TransportResult<void> write(std::string_view bytes, Milliseconds) override {
    sent.emplace_back(bytes);
    return outcome();
  }
  TransportResult<std::string> read(Milliseconds) override {
    auto reply = replies.front();
    replies.pop_front();
    return reply;
  }
  TransportResult<std::string> readUntil(std::string_view, Milliseconds deadline) override { return read(deadline); }
  TransportResult<void> clear() override { return outcome(); }
  TransportResult<std::uint8_t> statusByte(Milliseconds) override { return std::uint8_t{0x50}; }

private:
  TransportResult<void> outcome() {
    if (outcomes.empty()) {
      return {};
    }
    auto next = outcomes.front();
    outcomes.pop_front();
    return next;
  }
};

std::string allBytes() {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) {
    all += static_cast<char>(byte);
  }
  return all;
}

TEST(DialogueText, EveryByteComesBack) {
  for (const std::string& bytes :
       {allBytes(), std::string(), std::string(" a "), std::string("\\x41"), std::string("\\")}) {
    const std::string line = escaped(bytes);
    EXPECT_EQ(line.find_first_not_of(" !\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmn"
                                     "opqrstuvwxyz{|}~"),
              std::string::npos);
    EXPECT_FALSE(line.ends_with(' '));
    EXPECT_EQ(unescaped(line), bytes);
  }
  EXPECT_EQ(escaped("*IDN?\n\x05\xFF"), "*IDN?\\n\\x05\\xFF");
  for (const char* bad : {"\\", "\\q", "\\x", "\\x4", "\\xZZ"}) {
    EXPECT_EQ(unescaped(bad), std::nullopt) << bad;
  }
}

TEST(Dialogue, WhatWasRecordedPlaysAgain) {
  const fs::path file = fs::temp_directory_path() / ("straightedge-dialogue-" + std::to_string(::getpid()));
  fs::remove(file);
  {
    auto inner = std::make_unique<ScriptedTransport>();
    inner->replies = {std::string("METROLAB,THM1176\n"), allBytes(),
                      std::unexpected(fault(TransportFault::TimedOut, "no answer: none; at all"))};
    inner->outcomes = {TransportResult<void>{}, TransportResult<void>{},
                       std::unexpected(fault(TransportFault::Stalled, "it stalled"))};
    auto recorded = DialogueFile::create(file.string(), *inner);
    ASSERT_TRUE(recorded) << recorded.error().message();
    int heard = 0;
    RecordingTransport transport(std::move(inner), [&](const DialogueEntry& entry) {
      ++heard;
      recorded->add(entry);
    });
    EXPECT_TRUE(transport.hasMessages());
    EXPECT_TRUE(transport.write("*IDN?\n", anyTime));
    EXPECT_EQ(transport.readUntil("\n", anyTime).value(), "METROLAB,THM1176\n");
    EXPECT_EQ(transport.read(anyTime).value(), allBytes());
    EXPECT_FALSE(transport.read(anyTime));
    EXPECT_TRUE(transport.clear());
    EXPECT_EQ(transport.statusByte(anyTime).value(), 0x50);
    EXPECT_FALSE(transport.write(allBytes(), anyTime));
    EXPECT_EQ(heard, 8);
    EXPECT_FALSE(recorded->problem());
    EXPECT_FALSE(DialogueFile::create(file.string(), transport)) << "an older recording was overwritten";
  }
  auto dialogue = readDialogue(file.string());
  fs::remove(file);
  ASSERT_TRUE(dialogue) << dialogue.error().message();
  ReplayTransport replay(*std::move(dialogue), file.string());
  EXPECT_EQ(replay.name(), "fake \\ line");
  EXPECT_TRUE(replay.hasMessages());
  EXPECT_FALSE(replay.finished());
  EXPECT_TRUE(replay.write("*IDN?\n", anyTime));
  EXPECT_EQ(replay.readUntil("\n", anyTime).value(), "METROLAB,THM1176\n");
  EXPECT_EQ(replay.read(anyTime).value(), allBytes());
  const auto late = replay.read(anyTime);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().fault, TransportFault::TimedOut);
  EXPECT_EQ(late.error().error.what, "no answer: none; at all");
  EXPECT_EQ(late.error().error.remedy, "plug it in; again");
  EXPECT_EQ(late.error().error.where, "fake \\ line");
  EXPECT_TRUE(replay.clear());
  EXPECT_EQ(replay.statusByte(anyTime).value(), 0x50);
  const auto stalled = replay.write(allBytes(), anyTime);
  ASSERT_FALSE(stalled);
  EXPECT_EQ(stalled.error().fault, TransportFault::Stalled);
  EXPECT_TRUE(replay.finished());
}

ReplayTransport replayOf(const std::string& exchanges) {
  auto dialogue = parseDialogue("straightedge-dialogue 1\ntransport wire\nmessages no\n" + exchanges, "log");
  EXPECT_TRUE(dialogue) << dialogue.error().message();
  return {*std::move(dialogue), "log"};
}

TEST(Replay, ADifferenceIsToldWithLineAndPlace) {
  auto replay = replayOf("# set up\n0 > W0303\\r\n0 < w 03\n");
  const auto wrong = replay.write("W0304\r", anyTime);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().fault, TransportFault::Protocol);
  EXPECT_EQ(wrong.error().error.where, "log:5");
  EXPECT_EQ(wrong.error().error.what,
            "the recording expects 'W0303\\r' to be sent, but 'W0304\\r' was sent, different from byte 5 on");
  EXPECT_EQ(replay.read(anyTime).error().error.where, "log:5");
  EXPECT_EQ(replay.finished().error().where, "log:5");
  EXPECT_TRUE(replay.write("W0303\r", anyTime)) << "the recording stays where it differed";
  EXPECT_EQ(replay.clear().error().error.where, "log:6");
  EXPECT_EQ(replay.statusByte(anyTime).error().error.where, "log:6");
  EXPECT_EQ(replay.write("x", anyTime).error().error.where, "log:6");
  EXPECT_TRUE(replay.read(anyTime));
  EXPECT_EQ(replay.write("x", anyTime).error().error.what, "the recording ends here, but 'x' was sent");
}

TEST(Replay, LinesInPiecesAreJoinedAndTheRestIsKept) {
  auto replay = replayOf("0 < N44.91\n0 !< timed-out: nothing; wait\n0 < 4011F\\r\\nL\n0 < 1\\r\\n\n");
  EXPECT_EQ(replay.readUntil("\r\n", anyTime).error().fault, TransportFault::TimedOut);
  EXPECT_EQ(replay.readUntil("\r\n", anyTime).value(), "N44.914011F\r\n");
  EXPECT_EQ(replay.readUntil("\r\n", anyTime).value(), "L1\r\n");
  EXPECT_EQ(replay.readUntil("\r\n", anyTime).error().error.what.find("the recording ends here"), 0U);
  EXPECT_TRUE(replay.finished());
}

TEST(Dialogue, ADamagedFileIsRefusedWithItsLine) {
  const auto problem = [](const char* text) {
    const auto parsed = parseDialogue(text, "log");
    EXPECT_FALSE(parsed) << text;
    return parsed ? std::string() : parsed.error().where;
  };
  EXPECT_EQ(problem(""), "log");
  EXPECT_EQ(problem("PDF\n"), "log:1");
  EXPECT_EQ(problem("straightedge-dialogue 2\n"), "log:1");
  EXPECT_EQ(problem("straightedge-dialogue 1\n"), "log");
  for (const char* line : {"x > a", "0 ? a", "0", "0 > \\q", "0 s ab", "0 x ab", "nan > a", "-1 > a", "1e99 > a",
                           "0 !< boom: what; remedy", "> a"}) {
    EXPECT_EQ(problem(("straightedge-dialogue 1\n0 > ok\n" + std::string(line) + "\n").c_str()), "log:3") << line;
  }
}

} // namespace
} // namespace straightedge::devices
