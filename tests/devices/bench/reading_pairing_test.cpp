// Readings of two instruments, scripted with their times, become pairs.
#include "devices/instruments/reading_pairing.h"

#include <gmock/gmock.h>

namespace straightedge::devices {
namespace {

using ::testing::SizeIs;

ReadingPairing pairing(double maxAgeS) { return ReadingPairing({PairingKind::Interpolate, maxAgeS}); }

TEST(ReadingPairing, TheSensorsValueIsTakenAtTheReferencesTime) {
  auto both = pairing(0.1);
  both.addSensor({10.0, 1.000});
  both.addReference({100.0, 1.025});
  EXPECT_THAT(both.takePairs(), SizeIs(0)); // the reading after it is yet to come
  EXPECT_EQ(both.waiting(), 1U);
  both.addSensor({14.0, 1.100});
  const auto pairs = both.takePairs();
  ASSERT_THAT(pairs, SizeIs(1));
  EXPECT_DOUBLE_EQ(pairs[0].sensorDeg, 11.0);
  EXPECT_DOUBLE_EQ(pairs[0].encoderDeg, 100.0);
  EXPECT_DOUBLE_EQ(pairs[0].timeS, 1.025);
  EXPECT_EQ(both.rejected(), 0);
}

TEST(ReadingPairing, AShaftOfConstantSpeedComesOutExactlyThroughTheTurnsEnd) {
  // 200° a second, the sensor every 10 ms, the encoder every 7 ms: the sensor's own angle is the encoder's plus 3°.
  auto both = pairing(0.02);
  std::vector<StreamedAngle> pairs;
  int next = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double timeS = 0.010 * i;
    for (; 0.007 * next < timeS; ++next) {
      both.addReference({200.0 * 0.007 * next, 0.007 * next});
    }
    both.addSensor({std::fmod(200.0 * timeS + 3.0, 360.0), timeS});
    const auto some = both.takePairs();
    pairs.insert(pairs.end(), some.begin(), some.end());
  }
  EXPECT_EQ(both.rejected(), 0);
  ASSERT_THAT(pairs, SizeIs(1429));
  for (const auto& pair : pairs) {
    EXPECT_NEAR(pair.sensorDeg, std::fmod(pair.encoderDeg + 3.0, 360.0), 1e-9);
  }
}

TEST(ReadingPairing, BackwardsThroughZeroGoesTheShortWay) {
  auto both = pairing(1.0);
  both.addSensor({2.0, 0.0});
  both.addReference({0.0, 0.5});
  both.addSensor({356.0, 1.0});
  const auto pairs = both.takePairs();
  ASSERT_THAT(pairs, SizeIs(1));
  EXPECT_NEAR(pairs[0].sensorDeg, 359.0, 1e-12);
}

TEST(ReadingPairing, BeyondTheStatedAgeThereIsNoPair) {
  auto both = pairing(0.05);
  both.addSensor({10.0, 1.00});
  both.addReference({100.0, 1.02}); // 0.04 to the next: a pair
  both.addSensor({11.0, 1.06});
  both.addReference({101.0, 1.08}); // 0.07 to the next: none
  both.addReference({102.0, 1.12}); // 0.06 from the last: none
  both.addReference({103.0, 1.15}); // the very time of a reading: a pair
  both.addSensor({12.0, 1.15});
  EXPECT_THAT(both.takePairs(), SizeIs(2));
  EXPECT_EQ(both.rejected(), 2);
}

TEST(ReadingPairing, NothingIsMadeUpBeforeTheFirstReadingOrBackInTime) {
  auto both = pairing(1.0);
  both.addReference({100.0, 0.9}); // before the first sensor reading
  both.addSensor({10.0, 1.0});
  both.addReference({100.0, 1.2});
  both.addReference({100.0, 1.1}); // back in time
  both.addSensor({9.0, 0.5});      // likewise
  both.addSensor({12.0, 1.4});
  const auto pairs = both.takePairs();
  ASSERT_THAT(pairs, SizeIs(1));
  EXPECT_DOUBLE_EQ(pairs[0].sensorDeg, 11.0);
  EXPECT_EQ(both.rejected(), 2);
}

TEST(ReadingPairing, MemoryIsBoundedWhereOneSideIsSilent) {
  auto both = pairing(0.1);
  constexpr auto most = ReadingPairing::mostWaiting;
  for (std::size_t i = 0; i < most + 10; ++i) {
    both.addReference({0.0, 1.0 + 1e-4 * static_cast<double>(i)});
  }
  EXPECT_EQ(both.waiting(), most);
  EXPECT_EQ(both.rejected(), 10) << "given up and counted";
  auto sensors = pairing(0.1);
  for (std::size_t i = 0; i < most + 10; ++i) {
    sensors.addSensor({0.0, 1.0 + 1e-4 * static_cast<double>(i)});
  }
  sensors.addReference({0.0, 1.0}); // the first ten are gone: nothing lies before it
  EXPECT_THAT(sensors.takePairs(), SizeIs(0));
  EXPECT_EQ(sensors.rejected(), 1);
}

} // namespace
} // namespace straightedge::devices
