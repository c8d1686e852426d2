// Whether an encoder that counts from where it was switched on still has the zero that a sweep was begun with.
#include "devices/capture/reference_zero.h"

#include <gmock/gmock.h>

#include <cmath>

namespace straightedge::devices {
namespace {

using ::testing::HasSubstr;

class CountingEncoder : public AngleReference {
public:
  InstrumentIdentity identity() const override { return {}; }
  Result<TimedReading> readDeg() override { return TimedReading{}; }
  std::optional<double> incrementDeg() const override { return increment; }
  int timesOpened() const override { return opened; }

  std::optional<double> increment = 0.1;
  int opened = 1;
};

session::AngleSample sampleAt(double encoderDeg, double sensorDeg) {
  session::AngleSample sample;
  sample.encoderDeg = encoderDeg;
  sample.sensorDeg = sensorDeg;
  return sample;
}

class ReferenceZeroTest : public ::testing::Test {
protected:
  std::string message(double encoderDeg, double sensorDeg) {
    const auto error = m_zero.compare(encoderDeg, sensorDeg);
    return error ? error->message() : "";
  }
  CountingEncoder m_encoder;
  ReferenceZero m_zero{m_encoder};
};

TEST_F(ReferenceZeroTest, IsInDoubtOnlyWhereSamplesExistAndTheEncoderWasOpenedAgain) {
  EXPECT_FALSE(m_zero.inDoubt()) << "any zero is as good as another before the first sample";
  m_encoder.opened = 2;
  EXPECT_FALSE(m_zero.inDoubt());
  m_zero.stored(sampleAt(90.0, 110.0));
  EXPECT_FALSE(m_zero.inDoubt());
  m_encoder.opened = 3;
  EXPECT_TRUE(m_zero.inDoubt());
  m_encoder.increment.reset(); // it knows its angle by itself
  EXPECT_FALSE(m_zero.inDoubt());
}

TEST_F(ReferenceZeroTest, AShaftThatStoodStillHasToReadTheSameWithinOneAndAHalfCounts) {
  m_zero.stored(sampleAt(90.0, 110.0));
  m_zero.seen(95.0); // turned on since
  m_encoder.opened = 2;
  EXPECT_EQ(message(95.149, 0.0), "") << "the sensor may have been turned off: it is not asked";
  EXPECT_FALSE(m_zero.inDoubt());
  m_encoder.opened = 3;
  EXPECT_THAT(message(0.0, 115.0),
              HasSubstr("the encoder reads 0.000° and read 95.15° before it was unplugged; if only "
                        "the shaft was moved, turn it back to the last reading at 90.00°"));
  EXPECT_TRUE(m_zero.inDoubt());
}

TEST_F(ReferenceZeroTest, WhatIsNoAngleIsNotWhatWasReadLast) {
  m_zero.stored(sampleAt(90.0, 110.0));
  m_zero.seen(std::nan(""));
  m_encoder.opened = 2;
  EXPECT_NE(message(0.0, 20.0), "");
  EXPECT_EQ(message(90.0, 110.0), "");
}

TEST_F(ReferenceZeroTest, AFineEncoderMayMoveAsFarAsAShaftThatCountsAsStill) {
  m_encoder.increment = 0.0;
  m_zero.stored(sampleAt(90.0, 110.0));
  m_encoder.opened = 2;
  EXPECT_NE(message(90.021, 110.0), "");
  m_zero.stored(sampleAt(90.0, 110.0));
  m_encoder.opened = 3;
  EXPECT_EQ(message(89.981, 110.0), "");
}

TEST_F(ReferenceZeroTest, WholeTurnsDoNotCount) {
  m_zero.stored(sampleAt(450.0, 110.0));
  m_encoder.opened = 2;
  EXPECT_EQ(message(90.0, 110.0), "");
}

TEST_F(ReferenceZeroTest, TurnedBackItIsTheSensorThatProvesTheZero) {
  m_zero.stored(sampleAt(90.0, 110.0));
  m_encoder.opened = 2;
  EXPECT_NE(message(0.0, 110.0), ""); // without power: zero where it stands
  EXPECT_THAT(message(60.0, 170.0), HasSubstr("the encoder reads 60.00° and the sweep's last reading was at 90.00°"));
  const auto fooled = m_zero.compare(90.0, 200.0); // turned until it reads what it read
  ASSERT_TRUE(fooled);
  EXPECT_EQ(fooled->kind, ErrorKind::Input);
  EXPECT_THAT(fooled->message(), HasSubstr("another zero than before: at 90.00° the sensor reads 200.0°, and read "
                                           "110.0° at 90.00°; begin the sweep again"));
  EXPECT_TRUE(m_zero.inDoubt());
  EXPECT_EQ(message(90.5, 110.3), "") << "the shaft was turned back, and the encoder has its zero";
  EXPECT_FALSE(m_zero.inDoubt());
}

TEST_F(ReferenceZeroTest, ASweepTakenUpAgainNeedsTheSensorsWord) {
  m_zero.takeUp(sampleAt(359.9, 0.1));
  EXPECT_TRUE(m_zero.inDoubt());
  EXPECT_NE(message(359.9, 0.5), "");
  EXPECT_NE(message(1.1, 1.3), "") << "too far away to tell";
  EXPECT_EQ(message(0.3, 359.7), "") << "a sensor that runs backwards";
  EXPECT_FALSE(m_zero.inDoubt());
}

} // namespace
} // namespace straightedge::devices
