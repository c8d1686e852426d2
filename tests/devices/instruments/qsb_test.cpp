#include "devices/instruments/qsb.h"
#include "tests/devices/instruments/scripted_dialogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace straightedge::devices {
namespace {

using testing::HasSubstr;

TEST(QsbReply, TheManualsFormsAreRead) {
  const auto streamed = parseQsbReply("s 0E FFFFFC18 00000FF1 !"); // a real line
  ASSERT_TRUE(streamed);
  EXPECT_EQ(streamed->kind, 's');
  EXPECT_EQ(streamed->reg, 0x0E);
  EXPECT_EQ(static_cast<std::int32_t>(streamed->data), -1000);
  EXPECT_EQ(streamed->stamp, 0xFF1U);
  const auto plain = parseQsbReply("r0E00000010!"); // EOR 0: no blanks, no stamp
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->data, 16U);
  EXPECT_FALSE(plain->stamp);
  EXPECT_TRUE(parseQsbReply("\r\nw 15 0000000F 00000000 !"));
  for (const char* bad : {"", "!", "QSB-D  0E!", "s 0E FFFFFC18 00000FF1", "s 0E FFFFFC1 00000FF1 !", "q 0E FFFFFC18 !",
                          "s 0E FFFFFC1G !", "s 0E -FFFFC18 !", "s 0E FFFFFC18 00000FF1 00 !", "00FF1 !"}) {
    EXPECT_FALSE(parseQsbReply(bad)) << bad;
  }
}

const std::vector<std::string> setUp = {"x",
                                        "> R0E\\r\\n",
                                        "< r 0E 00000000 !\\r\\n",
                                        "> W150000000F\\r\\n",
                                        "< w 15 0000000F 00000001 !\\r\\n",
                                        "> R14\\r\\n",
                                        "< r 14 12345009 00000002 !\\r\\n",
                                        "> W033\\r\\n",
                                        "< w 03 00000003 00000003 !\\r\\n",
                                        "> W040\\r\\n",
                                        "< w 04 00000000 00000003 !\\r\\n",
                                        "> W0B0\\r\\n",
                                        "< w 0B 00000000 00000003 !\\r\\n",
                                        "> W0C1\\r\\n",
                                        "< w 0C 00000001 00000003 !\\r\\n",
                                        "> W0D1\\r\\n",
                                        "< w 0D 00000001 00000000 !\\r\\n"};

ReplayTransport afterSetUp(const std::vector<std::string>& more) { return script(setUp, false, more); }

TEST(Qsb, CountsBecomeDegrees) {
  auto line = afterSetUp(
      {"> R0E\\r\\n", "< r 0E 00000064 00000010 !\\r\\n", "> R0E\\r\\n", "< r 0E FFFFFC18 00000020 !\\r\\n"});
  SteppingClock clock;
  auto made = Qsb::make(line, clock, {{"counts_per_turn", "4000"}});
  ASSERT_TRUE(made) << problemOf(made);
  const auto prepared = (*made)->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  EXPECT_EQ((*made)->identity().model, "US Digital QSB-D");
  EXPECT_EQ((*made)->identity().serial, "12345");
  EXPECT_EQ((*made)->identity().firmware, "09");
  AngleReference* reference = (*made)->angleReference();
  ASSERT_NE(reference, nullptr);
  EXPECT_DOUBLE_EQ(reference->readDeg().value().value, 9.0);
  EXPECT_DOUBLE_EQ(reference->readDeg().value().value, -90.0);
  EXPECT_EQ((*made)->angleSensor(), nullptr);
  expectPlayed(line);
}

TEST(Qsb, ItsZeroIsWhereItWasSwitchedOn) {
  auto line = script({"x"});
  SteppingClock clock;
  const auto made = Qsb::make(line, clock, {{"counts_per_turn", "10000"}});
  ASSERT_TRUE(made) << problemOf(made);
  EXPECT_EQ((*made)->angleReference()->incrementDeg(), 0.036);
}

TEST(Qsb, TheRegistersRolloverIsNoJump) {
  auto line = afterSetUp(
      {"> R0E\\r\\n", "< r 0E 7FFFFFFF 00000010 !\\r\\n", "> R0E\\r\\n", "< r 0E 80000001 00000020 !\\r\\n"});
  SteppingClock clock;
  Qsb qsb(line, clock, 1.0, false);
  ASSERT_TRUE(qsb.prepare());
  const double before = qsb.readDeg().value().value;
  EXPECT_DOUBLE_EQ(qsb.readDeg().value().value - before, 2.0);
}

TEST(Qsb, BannerAndOldStreamAreNoReplies) {
  auto line =
      script({"x", "> R0E\\r\\n", "< 00FF1 !\\r\\ns 0E FFFFFC18 00000FF1 !\\r\\nQSB-D  0E!\\r\\nr 0E 00000000 !\\r\\n",
              "> W150000000F\\r\\n", "< z 15 !"});
  SteppingClock clock;
  Qsb qsb(line, clock, 1.0, false);
  const auto prepared = qsb.prepare();
  ASSERT_FALSE(prepared);
  EXPECT_THAT(problemOf(prepared), HasSubstr("'W150000000F'")) << "it came as far as the second command";
  EXPECT_FALSE(qsb.lastFault()) << "the transport is well";
  expectPlayed(line);
}

TEST(Qsb, ARefusalIsTold) {
  auto line = script({"x", "> R0E\\r\\n", "< e 0E 00000002 !\\r\\n"});
  SteppingClock clock;
  Qsb qsb(line, clock, 1.0, false);
  EXPECT_THAT(problemOf(qsb.prepare()), HasSubstr("refuses 'R0E'"));
}

TEST(Qsb, ATimeOutIsAnErrorAndTheNextReadingIsItsOwn) {
  auto line = afterSetUp({"> R0E\\r\\n", "!< timed-out", "x", "> R0E\\r\\n", "< r 0E 00000001 00000020 !\\r\\n"});
  SteppingClock clock;
  Qsb qsb(line, clock, 1.0, false);
  ASSERT_TRUE(qsb.prepare());
  const auto late = qsb.readDeg();
  ASSERT_FALSE(late);
  EXPECT_EQ(qsb.lastFault(), TransportFault::TimedOut);
  EXPECT_THAT(problemOf(late), HasSubstr("'R0E'"));
  EXPECT_DOUBLE_EQ(qsb.readDeg().value().value, 1.0);
  EXPECT_FALSE(qsb.lastFault());
  expectPlayed(line);
}

TEST(Qsb, AStreamIsSpacedByItsStamps) {
  auto line = afterSetUp(
      {"> S0E\\r\\n", "< s 0E 00000000 00000FEF !\\r\\n",
       "< s 0E 00000001 00000FF0 !\\r\\ns 0E 0000#002 00000FF1 !\\r\\ns 0E 00000003 00000FF4 !\\r\\ns 0E 000",
       "!< timed-out", "< 00004 00000FF5 !", "!< timed-out", "x", "> R0E\\r\\n",
       "< 5 00001000 !\\r\\ns 0E 00000005 00001001 !\\r\\nr 0E 00000006 00001002 !\\r\\n"});
  SteppingClock clock;
  Qsb qsb(line, clock, 1.0, false);
  ASSERT_TRUE(qsb.prepare());
  ASSERT_TRUE(qsb.start());
  EXPECT_FALSE(qsb.readDeg()) << "single readings and a stream do not go together";
  const auto block = qsb.read();
  ASSERT_TRUE(block) << problemOf(block);
  ASSERT_EQ(block->readings.size(), 2U);
  EXPECT_EQ(block->rejected, 1);
  EXPECT_DOUBLE_EQ(block->readings[0].value, 1.0);
  EXPECT_DOUBLE_EQ(block->readings[1].value, 3.0);
  EXPECT_DOUBLE_EQ(block->readings[1].timeS - block->readings[0].timeS, 4.0 / 512);
  const auto next = qsb.read();
  ASSERT_TRUE(next);
  ASSERT_EQ(next->readings.size(), 1U);
  EXPECT_DOUBLE_EQ(next->readings[0].value, 4.0) << "a line in two pieces is one reading";
  const auto stopped = qsb.stop();
  EXPECT_TRUE(stopped) << problemOf(stopped);
  expectPlayed(line);
}

TEST(Qsb, AFaultBehindStreamedReadingsIsToldAfterThem) {
  auto line = afterSetUp({"> S0E\\r\\n", "< s 0E 00000000 00000FEF !\\r\\n", "< s 0E 00000001 00000FF0 !",
                          "!< overflow", "< s 0E 00000002 00000FF9 !", "!< timed-out"});
  SteppingClock clock;
  Qsb qsb(line, clock, 1.0, false);
  ASSERT_TRUE(qsb.prepare());
  ASSERT_TRUE(qsb.start());
  EXPECT_EQ(qsb.read().value().readings.size(), 1U);
  const auto lost = qsb.read();
  EXPECT_THAT(problemOf(lost), HasSubstr("while streaming"));
  EXPECT_EQ(qsb.lastFault(), TransportFault::Overflow);
  EXPECT_EQ(qsb.read().value().readings.size(), 1U);
}

TEST(StampedTimes, TicksSpaceTheReadingsAndTheQuickestArrivalPlacesThem) {
  StampedTimes times(0.01);
  const std::vector<std::uint32_t> first = {0xFFFFFFFE, 0xFFFFFFFF, 1}; // the register goes round
  auto placed = times.place(first, 5.0);
  ASSERT_EQ(placed.size(), 3U);
  EXPECT_NEAR(placed[0], 4.97, 1e-12);
  EXPECT_NEAR(placed[1], 4.98, 1e-12);
  EXPECT_NEAR(placed[2], 5.00, 1e-12);
  placed = times.place(std::vector<std::uint32_t>{2, 3}, 5.05); // 30 ms late: the line was slow
  EXPECT_NEAR(placed[0], 5.01, 1e-3);
  EXPECT_NEAR(placed[1], 5.02, 1e-3);
  placed = times.place(std::vector<std::uint32_t>{6}, 5.04); // quicker than any before: none arrives before it is taken
  EXPECT_NEAR(placed[0], 5.04, 1e-12);
  placed = times.place(std::vector<std::uint32_t>{7}, 9.0); // the instrument had paused
  EXPECT_NEAR(placed[0], 9.0, 1e-12);
  placed = times.place(std::vector<std::uint32_t>{8}, 8.9);
  EXPECT_NEAR(placed[0], 9.0, 1e-12) << "never back";
  times.restart();
  EXPECT_NEAR(times.place(std::vector<std::uint32_t>{100}, 1.0)[0], 1.0, 1e-12);
}

TEST(Qsb, SettingsAreChecked) {
  auto line = script({"x"});
  SteppingClock clock;
  EXPECT_THAT(problemOf(Qsb::make(line, clock, {})), HasSubstr("counts_per_turn"));
  EXPECT_THAT(problemOf(Qsb::make(line, clock, {{"counts_per_turn", "many"}})), HasSubstr("'many'"));
  EXPECT_THAT(problemOf(Qsb::make(line, clock, {{"counts_per_turn", "4000"}, {"colour", "red"}})),
              HasSubstr("'colour'"));
  EXPECT_EQ(Qsb::make(line, clock, {{"direction", "left"}, {"counts_per_turn", "4000"}}).error().kind,
            ErrorKind::Usage);
}

} // namespace
} // namespace straightedge::devices
