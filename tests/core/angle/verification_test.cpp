#include "core/angle/verification.h"
#include "tests/core/angle/synthetic_sweep.h"

#include <gtest/gtest.h>

#include <limits>

namespace straightedge::angle {
namespace {

/// A correction of −10° everywhere, so that the error of a reading is plain to see.
AngleCalibration minusTen(double expandedDeg, SensorDirection direction = SensorDirection::Increasing) {
  AngleCalibration calibration;
  Model model;
  model.body = HarmonicModel{-10.0, {}};
  calibration.direction = direction;
  calibration.models = {model};
  UncertaintyBudget budget;
  budget.model = model.name.text();
  budget.expandedDeg = expandedDeg;
  calibration.uncertainty = {budget};
  return calibration;
}

VerificationReport verified(const AngleCalibration& calibration, const Sweep& sweep, double limitDeg) {
  const auto report = verify(calibration, calibration.models[0], sweep, limitDeg);
  EXPECT_TRUE(report.has_value()) << report.error().message();
  return report.value_or(VerificationReport{});
}

Sweep fourPoints() {
  Sweep sweep;
  sweep.source.file = "fresh.csv";
  sweep.encoderDeg = {0.0, 90.0, 355.0, 720.5};
  sweep.sensorDeg = {10.0, 100.3, 5.0, 10.0}; // corrected 0, 90.3, 355, 0: errors 0, 0.3, 0, −0.5
  return sweep;
}

TEST(Verification, LargestWrappedErrorAgainstTheLimit) {
  const VerificationReport report = verified(minusTen(0.0), fourPoints(), 0.5);
  EXPECT_EQ(report.points, 4U);
  EXPECT_NEAR(report.maxErrorDeg, 0.5, 1e-12);
  EXPECT_NEAR(report.rmsErrorDeg, std::sqrt((0.09 + 0.25) / 4.0), 1e-12);
  EXPECT_NEAR(report.maxErrorBeforeDeg, 10.3, 1e-12);
  EXPECT_NEAR(report.errorAfterDeg[3], -0.5, 1e-12);
  EXPECT_EQ(report.encoderDeg, fourPoints().encoderDeg);
  EXPECT_TRUE(verified(minusTen(0.0), fourPoints(), 0.501).met);
  EXPECT_FALSE(verified(minusTen(0.0), fourPoints(), 0.499).met);
}

TEST(Verification, SwitchedOffRowsDoNotCount) {
  Sweep sweep = fourPoints();
  sweep.enabled = {true, true, true, false};
  sweep.sensorDeg[3] = std::numeric_limits<double>::quiet_NaN();
  const VerificationReport report = verified(minusTen(0.0), sweep, 1.0);
  EXPECT_EQ(report.points, 3U);
  EXPECT_NEAR(report.maxErrorDeg, 0.3, 1e-12);
}

TEST(Verification, SensorThatRunsBackwardsIsMirrored) {
  Sweep sweep = fourPoints();
  for (double& sensor : sweep.sensorDeg) {
    sensor = wrap360(360.0 - sensor);
  }
  const VerificationReport report = verified(minusTen(0.0, SensorDirection::Decreasing), sweep, 1.0);
  EXPECT_NEAR(report.maxErrorDeg, 0.5, 1e-9);
  EXPECT_NEAR(report.maxErrorBeforeDeg, 10.3, 1e-9);
}

TEST(Verification, UncertaintySaysHowFirmTheVerdictIs) {
  const VerificationReport pass = verified(minusTen(0.05), fourPoints(), 0.6);
  EXPECT_EQ(pass.verdict, Verdict::Pass);
  EXPECT_EQ(pass.decisionRule, "Simple acceptance: passed, because the largest error 0.500° is within the limit of "
                               "0.600°, by more than the expanded uncertainty (95 %) of 0.0500°.");
  const VerificationReport near = verified(minusTen(0.2), fourPoints(), 0.6);
  EXPECT_TRUE(near.met);
  EXPECT_EQ(near.verdict, Verdict::PassWithinUncertainty);
  EXPECT_EQ(
      near.decisionRule,
      "Simple acceptance: passed, because the largest error 0.500° is within the limit of 0.600°; it is nearer "
      "to the limit than the expanded uncertainty (95 %) of 0.200°, so the true error may lie on the other side.");
  EXPECT_EQ(verified(minusTen(0.05), fourPoints(), 0.4).verdict, Verdict::Fail);
  const VerificationReport nearFail = verified(minusTen(0.2), fourPoints(), 0.4);
  EXPECT_FALSE(nearFail.met);
  EXPECT_EQ(nearFail.verdict, Verdict::FailWithinUncertainty);
  const VerificationReport unknown = verified(minusTen(0.0), fourPoints(), 0.6);
  EXPECT_EQ(unknown.verdict, Verdict::Pass);
  EXPECT_EQ(unknown.decisionRule, "Simple acceptance: passed, because the largest error 0.500° is within the limit of "
                                  "0.600°; the uncertainty of the corrected angle is not known and does not count.");
}

TEST(Verification, Refusals) {
  const AngleCalibration calibration = minusTen(0.0);
  const Model& model = calibration.models[0];
  for (const double limit : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const auto refused = verify(calibration, model, fourPoints(), limit);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
  }
  Sweep empty;
  empty.source.file = "fresh.csv";
  const auto refused = verify(calibration, model, empty, 1.0);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().message(),
            "fresh.csv: the sweep has no points to verify with; record a sweep, or switch points on");
  Sweep broken = fourPoints();
  broken.sensorDeg[1] = std::numeric_limits<double>::infinity();
  const auto notANumber = verify(calibration, model, broken, 1.0);
  ASSERT_FALSE(notANumber.has_value());
  EXPECT_EQ(notANumber.error().message(),
            "fresh.csv: the sensor angle in row 2 is not a finite number (inf); remove the row or switch it off");
}

} // namespace
} // namespace straightedge::angle
