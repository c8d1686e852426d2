#include "core/angle/alignment.h"
#include "tests/core/angle/synthetic_sweep.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace straightedge::angle {
namespace {

struct Refusal {
  std::string name;
  std::function<void(Sweep&)> spoil; ///< of a good sweep of 36 angles
  std::string message;
};

Sweep turningAtRatio(double ratio, int count, double stepDeg) {
  Sweep sweep;
  sweep.source.file = "sweep.csv";
  for (int i = 0; i < count; ++i) {
    sweep.encoderDeg.push_back(stepDeg * i);
    sweep.sensorDeg.push_back(wrap360(40.0 + ratio * stepDeg * i));
  }
  return sweep;
}

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

const std::string turnRemedy = "; check the gear ratio, the magnet's pole pairs and which column is which";

const std::vector<Refusal> refusals = {
    {"EmptySweep", [](Sweep& s) { s.enabled.assign(36, false); },
     "sweep.csv: only 0 distinct encoder angles; a calibration needs at least 8; record more angles, spread over the "
     "whole turn"},
    {"SevenAngles", [](Sweep& s) { s = sweepOf({}, 7); },
     "sweep.csv: only 7 distinct encoder angles; a calibration needs at least 8; record more angles, spread over the "
     "whole turn"},
    {"SevenAnglesManyTimes",
     [](Sweep& s) {
       s = sweepOf({}, 7);
       for (int i = 0; i < 70; ++i) {
         // a stage that comes back to within a thousandth of a degree
         s.encoderDeg.push_back(s.encoderDeg[static_cast<std::size_t>(i % 7)] + 360.0 + 0.0001 * (i % 10));
         s.sensorDeg.push_back(s.sensorDeg[static_cast<std::size_t>(i % 7)]);
       }
     },
     "sweep.csv: only 7 distinct encoder angles; a calibration needs at least 8; record more angles, spread over the "
     "whole turn"},
    {"SwitchedOffToFew",
     [](Sweep& s) {
       s.enabled.assign(36, false);
       for (std::size_t i = 0; i < 35; i += 5) {
         s.enabled[i] = true;
       }
     },
     "sweep.csv: only 7 distinct encoder angles; a calibration needs at least 8; record more angles, spread over the "
     "whole turn"},
    {"QuarterMissing",
     [](Sweep& s) {
       s.enabled.assign(36, true);
       for (std::size_t i = 10; i < 19; ++i) {
         s.enabled[i] = false;
       }
     },
     "sweep.csv: no encoder angle in the 100° from 90.00° to 190.0°; gaps up to 90° are accepted; record the missing "
     "part of the turn"},
    {"SensorLeaps",
     [](Sweep& s) {
       // 80° without points where the sensor moves fastest
       SyntheticSensor steep;
       steep.offsetDeg = 0.0;
       steep.terms = {{1, 30.0, -std::numbers::pi / 2.0}};
       s = sweepOf(steep, 36);
       s.enabled.assign(36, false);
       for (std::size_t i = 4; i <= 32; ++i) {
         s.enabled[i] = true;
       }
     },
     "sweep.csv: the sensor leaps over 119°, from 300.7° to 59.28°, between neighbouring points; gaps up to 90° are "
     "accepted; record more angles where the sensor moves fast"},
    {"TwoTurnsPerTurn", [](Sweep& s) { s = turningAtRatio(2.0, 36, 10.0); },
     "sweep.csv: the sensor makes 2 turns while the encoder makes one; it must make exactly one" + turnRemedy},
    {"FourTurnsBackwards", [](Sweep& s) { s = turningAtRatio(-4.0, 36, 10.0); },
     "sweep.csv: the sensor makes 4 turns while the encoder makes one; it must make exactly one" + turnRemedy},
    {"ThirdOfATurn", [](Sweep& s) { s = turningAtRatio(1.0 / 3.0, 36, 10.0); },
     "sweep.csv: the sensor turns less than once while the encoder makes one turn: it comes back after 117°; it must "
     "make exactly one" +
         turnRemedy},
    {"NineTenthsOfATurn", [](Sweep& s) { s = turningAtRatio(0.9, 36, 10.0); },
     "sweep.csv: the sensor seems to make 0.90 turns while the encoder makes one: it drifts steadily against the "
     "encoder and jumps back by 35.0° after encoder angle 350°; it must make exactly one" +
         turnRemedy},
    {"ElevenTenthsOfATurn", [](Sweep& s) { s = turningAtRatio(1.1, 360, 1.0); },
     "sweep.csv: the sensor seems to make 1.1 turns while the encoder makes one: it drifts steadily against the "
     "encoder and jumps back by 35.5° after encoder angle 355°; it must make exactly one" +
         turnRemedy},
    {"HalfATurnOverTwoTurns", [](Sweep& s) { s = turningAtRatio(0.5, 72, 10.0); },
     "sweep.csv: the sensor does not come back to the same angle: readings at neighbouring encoder angles differ by "
     "178° (median); it must make exactly one turn while the encoder makes one" +
         turnRemedy},
    {"SlowDriftOverFourTurns", [](Sweep& s) { s = turningAtRatio(0.99, 144, 10.0); },
     "sweep.csv: the sensor loses 3.60° against the encoder with every turn; it must make exactly one turn while the "
     "encoder makes one" +
         turnRemedy},
    {"NoRule",
     [](Sweep& s) {
       Randomness random(5);
       s = turningAtRatio(1.0, 360, 1.0);
       for (double& sensor : s.sensorDeg) {
         sensor = 360.0 * random.uniform();
       }
     },
     "sweep.csv: the sensor does not come back to the same angle: readings at neighbouring encoder angles differ by"},
    {"Constant", [](Sweep& s) { s.sensorDeg.assign(36, 123.5); },
     "sweep.csv: the sensor shows the same angle, 124°, at every encoder angle; check the sensor's wiring and that the "
     "magnet turns with the shaft"},
    {"NearlyConstant",
     [](Sweep& s) {
       for (std::size_t i = 0; i < 36; ++i) { // about the seam, too
         s.sensorDeg[i] = i % 2 == 0 ? 359.9 : 0.2;
       }
     },
     "sweep.csv: the sensor stays within 0.300° while the encoder makes a whole turn; check the sensor's wiring and "
     "that the magnet turns with the shaft"},
    {"SensorIsNaN", [](Sweep& s) { s.sensorDeg[4] = std::numeric_limits<double>::quiet_NaN(); },
     "sweep.csv: the sensor angle in row 5 is not a finite number (nan); remove the row or switch it off"},
    {"EncoderIsInfinite",
     [](Sweep& s) {
       s.line.resize(36);
       for (std::size_t i = 0; i < 36; ++i) {
         s.line[i] = i + 2;
       }
       s.encoderDeg[4] = -std::numeric_limits<double>::infinity();
     },
     "sweep.csv:6: the encoder angle is not a finite number (-inf); remove the row or switch it off"},
    {"SensorAbove360", [](Sweep& s) { s.sensorDeg[35] = 360.5; },
     "sweep.csv: the sensor angle 360.5° in row 36 is outside 0° to 360°; give angles in degrees, or remove the row"},
    {"SensorBelowZero", [](Sweep& s) { s.sensorDeg[0] = -0.25; },
     "sweep.csv: the sensor angle -0.25° in row 1 is outside 0° to 360°; give angles in degrees, or remove the row"},
    {"EncoderFarOff", [](Sweep& s) { s.encoderDeg[1] = 4e6; },
     "sweep.csv: the encoder angle 4e+06° in row 2 is outside -3600000° to 3600000°; give angles in degrees, or remove "
     "the row"},
    {"ColumnsDiffer", [](Sweep& s) { s.sensorDeg.pop_back(); },
     "sweep.csv: the sweep's columns differ in length; give every row a value in every column"},
};

class Refusals : public testing::TestWithParam<Refusal> {};

TEST_P(Refusals, SayWhatIsWrongAndWhatToDo) {
  Sweep sweep = sweepOf({}, 36);
  ASSERT_TRUE(alignSweep(sweep).has_value());
  GetParam().spoil(sweep);
  const auto aligned = alignSweep(sweep);
  ASSERT_FALSE(aligned.has_value());
  EXPECT_EQ(aligned.error().kind, ErrorKind::Input);
  EXPECT_EQ(aligned.error().message().substr(0, GetParam().message.size()), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(Sweep, Refusals, testing::ValuesIn(refusals),
                         [](const auto& refusal) { return refusal.param.name; });

TEST(Refusals, SwitchedOffRowsMayHoldAnything) {
  Sweep sweep = sweepOf({}, 36);
  sweep.enabled.assign(36, true);
  sweep.enabled[7] = false;
  sweep.sensorDeg[7] = std::numeric_limits<double>::quiet_NaN();
  sweep.encoderDeg[7] = 1e300;
  const auto aligned = alignSweep(sweep);
  ASSERT_TRUE(aligned.has_value()) << aligned.error().message();
  EXPECT_EQ(aligned->readingDeg.size(), 35);
}

TEST(Refusals, EightAnglesAndAGapOf90DegreesAreEnough) {
  EXPECT_TRUE(alignSweep(sweepOf({}, 8)).has_value());
  SyntheticSensor small;
  small.terms = {{1, 0.5, 0.0}};
  Sweep sweep = sweepOf(small, 36);
  sweep.enabled.assign(36, true);
  for (std::size_t i = 10; i < 18; ++i) {
    sweep.enabled[i] = false;
  }
  const auto aligned = alignSweep(sweep);
  ASSERT_TRUE(aligned.has_value()) << aligned.error().message();
}

TEST(Refusals, OneBadReadingIsNotTakenForAWrongRatio) {
  Sweep sweep = sweepOf({}, 36);
  sweep.sensorDeg[20] = wrap360(sweep.sensorDeg[20] + 30.0);
  EXPECT_TRUE(alignSweep(sweep).has_value());
}

} // namespace
} // namespace straightedge::angle
