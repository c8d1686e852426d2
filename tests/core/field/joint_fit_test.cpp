#include "core/field/chain.h"
#include "core/field/closest_fit.h"
#include "core/field/field_fit.h"
#include "core/field/joint_fit.h"
#include "tests/core/field/example_campaign.h"
#include "tests/core/field/stepwise_chain.h"

#include <gmock/gmock.h>

#include <cmath>

namespace straightedge::field {
namespace {

using testing::stepwiseChain;
using testing::verificationPeaks;

const CorrectionChain& stepwise() {
  static const CorrectionChain chain = stepwiseChain(exampleParts());
  return chain;
}

std::vector<ChainParameter> everyParameter(const AxisChain& axis) {
  std::vector<ChainParameter> all;
  const auto add = [&all](ChainBlock block, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      all.push_back({block, k});
    }
  };
  add(ChainBlock::Nonlinearity, axis.nonlinearity.size());
  add(ChainBlock::Offset, 2);
  add(ChainBlock::SensitivitySlope, axis.sensitivitySlope->size());
  add(ChainBlock::SensitivityIntercept, axis.sensitivityIntercept->size());
  add(ChainBlock::Electronics, 2);
  add(ChainBlock::ElectronicsSensitivity, 2);
  return all;
}

TEST(AxisGradient, agreesWithDifferencesForEveryCoefficient) {
  const AxisChain chain = stepwise().axes[1];
  const auto parameters = everyParameter(chain);
  const auto count = static_cast<Eigen::Index>(parameters.size());
  Eigen::VectorXd by(count);
  Eigen::VectorXd unused(count);
  for (const double raw : {-1.9, -0.3, 0.0, 1.2}) {
    const AxisGradient at = axisGradient(chain, parameters, raw, 6.0, -5.0, by);
    const auto value = [&](double r, double t, double e) {
      return axisGradient(chain, parameters, r, t, e, unused).valueT;
    };
    EXPECT_NEAR(at.valueT, axisStages(chain, raw, 6.0, -5.0).electronicsSensitivityT, 1e-15);
    EXPECT_NEAR(at.byRaw, (value(raw + 1e-5, 6.0, -5.0) - value(raw - 1e-5, 6.0, -5.0)) / 2e-5, 1e-8);
    EXPECT_NEAR(at.byProbe, (value(raw, 6.01, -5.0) - value(raw, 5.99, -5.0)) / 0.02, 1e-11);
    EXPECT_NEAR(at.byElectronics, (value(raw, 6.0, -4.99) - value(raw, 6.0, -5.01)) / 0.02, 1e-11);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      constexpr double step = 1e-5;
      AxisChain more = chain;
      AxisChain less = chain;
      valueOf(more, parameters[i]) += step;
      valueOf(less, parameters[i]) -= step;
      const double numeric = (axisGradient(more, parameters, raw, 6.0, -5.0, unused).valueT -
                              axisGradient(less, parameters, raw, 6.0, -5.0, unused).valueT) /
                             (2.0 * step);
      EXPECT_NEAR(by[static_cast<Eigen::Index>(i)], numeric, 1e-8 * std::max(1.0, std::abs(numeric))) << i;
    }
  }
}

TEST(IndependentParameters, theCorrectionStaysTheSameToFirstOrder) {
  const AxisChain& before = stepwise().axes[0];
  const AxisChain after = inIndependentParameters(before);
  for (const double raw : {-1.9, -0.3, 0.0, 1.2}) {
    EXPECT_NEAR(axisStages(before, raw, 5.0, -6.0).electronicsSensitivityT,
                axisStages(after, raw, 5.0, -6.0).electronicsSensitivityT, 3e-6);
  }
  EXPECT_EQ((*after.offsetT)[0], 0.0);
  EXPECT_EQ(after.sensitivitySlope->front(), 0.0);
  EXPECT_THAT(*after.sensitivityIntercept, ::testing::Each(0.0));
  EXPECT_EQ((*after.electronicsT)[0], 0.0);
  EXPECT_EQ((*after.electronicsSensitivity)[0], 0.0);
  EXPECT_EQ(independentParameters(after).size(), 6U + 1U + 3U + 1U + 1U);
  AxisChain noOffset = before;
  noOffset.offsetT.reset();
  noOffset.electronicsT.reset();
  EXPECT_EQ(independentParameters(noOffset).size(), 6U + 4U + 2U) << "their constants stay free";
}

TEST(JointFit, leavesSmallerPeaksInVerificationThanStepByStep) {
  const auto joint = fitJointly(exampleParts(), stepwise(), {}, "campaign.csv");
  ASSERT_TRUE(joint) << joint.error().message();
  EXPECT_TRUE(joint->converged());
  const auto before = verificationPeaks(exampleParts(), stepwise());
  const auto after = verificationPeaks(exampleParts(), joint->chain);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const JointAxisReport& report = joint->axes[axis];
    EXPECT_LT(after[axis], 0.8 * before[axis]);
    EXPECT_LT(report.peakAfterT, report.peakBeforeT);
    EXPECT_LT(report.costAfter, report.costBefore);
  }
  // 12,888 rows come down to this, and nothing of them is lost but the parts of a plateau that stand over.
  EXPECT_LT(joint->axes[0].points, 600U);
  EXPECT_GE(joint->axes[0].rows, 480U + 500U + 1440U + 400U + 640U + 540U);
}

TEST(JointFit, theSingleRowsSayTheSameAsTheirMeans) {
  // One point a row instead of one for all rows of half a degree.
  FitPoints means = fitPoints(exampleParts(), stepwise());
  const auto together = fitJointly(means, stepwise(), {.weights = JointWeights::Noise}, "campaign.csv");
  ASSERT_TRUE(together);
  const StepRows& rows = exampleParts().of(CampaignStep::Sensitivity, Axis::X);
  std::erase_if(means.axes[0], [](const FitPoint& point) { return point.step == CampaignStep::Sensitivity; });
  const Eigen::VectorXd probeC = probeTemperatureC(stepwise(), rows);
  const std::size_t run = means.axes[0].back().run;
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    FitPoint point;
    point.step = CampaignStep::Sensitivity;
    point.rawT = rows.rawT(i, 0);
    point.probeC = probeC[i];
    point.targetT = rows.referenceT[i];
    point.rows = 1;
    point.run = run + 1 + static_cast<std::size_t>(i) / 240;
    means.axes[0].push_back(point);
  }
  const auto apart = fitJointly(means, stepwise(), {.weights = JointWeights::Noise}, "campaign.csv");
  ASSERT_TRUE(apart);
  for (const double raw : {-2.0, -0.7, 0.4, 1.8}) {
    EXPECT_NEAR(axisStages(together->chain.axes[0], raw, 6.0, 4.0).electronicsSensitivityT,
                axisStages(apart->chain.axes[0], raw, 6.0, 4.0).electronicsSensitivityT, 2e-6);
  }
}

TEST(JointFit, blocksThatAreOffStayOff) {
  CorrectionChain chain = stepwise();
  chain.axes[2].electronicsSensitivity.reset();
  const auto joint = fitJointly(exampleParts(), chain, {}, "campaign.csv");
  ASSERT_TRUE(joint);
  EXPECT_FALSE(joint->chain.axes[2].electronicsSensitivity);
  EXPECT_TRUE(joint->chain.axes[1].electronicsSensitivity);
}

TEST(JointFit, calibrateFieldReportsBothMethods) {
  const auto joint = calibrateField(exampleCampaign(), {.method = FitMethod::Joint}, {});
  const auto alone = calibrateField(exampleCampaign(), {}, {});
  ASSERT_TRUE(joint && alone);
  ASSERT_TRUE(joint->joint);
  EXPECT_FALSE(alone->joint);
  EXPECT_EQ(joint->result.method, FitMethod::Joint);
  EXPECT_EQ(joint->joint->stepwiseChain.axes[0].nonlinearity, alone->result.chain.axes[0].nonlinearity);
  for (const VerificationRow& row : joint->verification.rows) {
    for (const VerificationRow& other : joint->joint->stepwiseVerification.rows) {
      if (row.axis == other.axis && row.state == other.state && row.state >= VerifiedState::Calibrated) {
        EXPECT_LT(row.ofFullScale.peak, other.ofFullScale.peak);
        EXPECT_LT(row.ofFullScale.peak, 0.0105) << "percent; step by step up to 0.013";
      }
    }
  }
}

TEST(ClosestFit, followsTheInstrumentToItsNoise) {
  const FitPoints points = fitPoints(exampleParts(), stepwise());
  const auto closest = fitClosely(points, stepwise(), "campaign.csv");
  ASSERT_TRUE(closest) << closest.error().message();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Not 1: in this campaign the electronics' sensitivity is no line over the field, by up to 1e-5 T.
    EXPECT_LT(closest->axes[axis].excess, 2.2);
    EXPECT_LT(closest->axes[axis].peakAfterT, 2e-5) << "with order 5 it is 1.5e-4";
    EXPECT_GE(closest->chain.axes[axis].nonlinearity.size(), 12U);
    EXPECT_NEAR((*closest->chain.axisMatrix)(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(axis)), 1.0,
                5e-6);
  }
}

TEST(JointFit, refusals) {
  CorrectionChain noCurve = stepwise();
  noCurve.axes[1].nonlinearity.clear();
  EXPECT_THAT(fitJointly(exampleParts(), noCurve, {}, "c.csv").error().message(),
              ::testing::HasSubstr("the nonlinearity of axis y is off"));
  const auto nothing = fitJointly(FitPoints{}, stepwise(), {}, "campaign.csv");
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().message(),
            "campaign.csv: axis x has 0 points for the 12 coefficients of a joint fit; record "
            "more fields and temperatures, or fit step by step");
  FitPoints points = fitPoints(exampleParts(), stepwise());
  for (FitPoint& point : points.axes[1]) {
    point.probeC = 0.0; // a temperature that never moves
  }
  const auto flat = fitJointly(points, stepwise(), {}, "campaign.csv");
  ASSERT_FALSE(flat);
  EXPECT_THAT(flat.error().message(), ::testing::HasSubstr("axis y do not determine all coefficients"));
}

} // namespace
} // namespace straightedge::field
