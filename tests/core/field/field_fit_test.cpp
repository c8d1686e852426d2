// The whole fit against the figures published beside the campaign (to 1 % or 0.0003 %) and against an independent
// evaluation of every coefficient (numpy polyfit and lstsq, run by hand; the digits it printed).
#include "core/field/field_fit.h"
#include "core/field/names.h"
#include "tests/core/field/example_campaign.h"

#include <algorithm>
#include <cmath>

namespace straightedge::field {
namespace {

double tolerance(double figure) { return std::max(0.01 * std::abs(figure), 0.0003); }

const FieldRun& exampleRun() {
  static const FieldRun run = *calibrateField(exampleCampaign(), {}, {});
  return run;
}

const VerificationRow& figuresOf(const std::vector<VerificationRow>& rows, Axis axis, VerifiedState state) {
  const auto found =
      std::ranges::find_if(rows, [&](const VerificationRow& row) { return row.axis == axis && row.state == state; });
  EXPECT_NE(found, rows.end());
  return *found;
}

TEST(FieldFit, VerificationMeetsThePublishedFigures) {
  struct Expected {
    Axis axis;
    double mean, sigma, peak, withoutElectronicsSensitivity, calibrated;
  };
  for (const Expected& expected : {Expected{Axis::X, 0.0002, 1.3978, 2.1478, 0.0267, 0.0115},
                                   Expected{Axis::Y, -0.0018, 1.4165, 2.1474, 0.0260, 0.0119},
                                   Expected{Axis::Z, -0.0009, 1.3176, 2.0525, 0.0296, 0.0130}}) {
    const auto& rows = exampleRun().result.verification;
    const auto& before = figuresOf(rows, expected.axis, VerifiedState::Uncalibrated);
    EXPECT_NEAR(before.ofFullScale.mean, expected.mean, tolerance(expected.mean));
    EXPECT_NEAR(before.ofFullScale.sigma, expected.sigma, tolerance(expected.sigma));
    EXPECT_NEAR(before.ofFullScale.peak, expected.peak, tolerance(expected.peak));
    EXPECT_EQ(before.points, 600U);
    EXPECT_NEAR(figuresOf(rows, expected.axis, VerifiedState::Electronics).ofFullScale.peak,
                expected.withoutElectronicsSensitivity, tolerance(expected.withoutElectronicsSensitivity));
    EXPECT_NEAR(figuresOf(rows, expected.axis, VerifiedState::Calibrated).ofFullScale.peak, expected.calibrated,
                tolerance(expected.calibrated));
  }
}

TEST(FieldFit, EachBlockLeavesWhatAnIndependentEvaluationFindsAfterIt) {
  const std::vector<std::pair<VerifiedState, double>> peaksOfX = {{VerifiedState::Nonlinearity, 0.1165},
                                                                  {VerifiedState::Offset, 0.1224},
                                                                  {VerifiedState::Sensitivity, 0.0293},
                                                                  {VerifiedState::Electronics, 0.0267},
                                                                  {VerifiedState::ElectronicsSensitivity, 0.0115},
                                                                  {VerifiedState::AxisMatrix, 0.009872622121853691}};
  for (const auto& [state, peak] : peaksOfX) {
    EXPECT_NEAR(figuresOf(exampleRun().result.verification, Axis::X, state).ofFullScale.peak, peak, 0.00005);
  }
  const auto& calibrated = figuresOf(exampleRun().result.verification, Axis::X, VerifiedState::Calibrated);
  EXPECT_NEAR(calibrated.ofFullScale.mean, -6.776276114626074e-05, 1e-10);
  EXPECT_NEAR(calibrated.ofFullScale.sigma, 0.003894441981141256, 1e-10);
  EXPECT_NEAR(calibrated.ofFullScale.peak, 0.011529857096326257, 1e-10);
}

void expectNear(const std::vector<double>& actual, const std::vector<double>& expected, double relative) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], relative * std::abs(expected[i])) << i;
  }
}

TEST(FieldFit, CoefficientsOfAxisZ) {
  const AxisChain& z = exampleRun().result.chain.axes[2];
  constexpr double digits = 1e-7; // of numpy's print
  expectNear(z.nonlinearity,
             {-3.15948381e-05, 1.04609713e+00, 3.74510558e-05, -1.09614724e-02, -8.81881962e-06, -1.14695791e-03},
             digits);
  expectNear({z.offsetT->begin(), z.offsetT->end()}, {1.94847380e-06, 2.37906746e-05}, digits);
  expectNear(*z.sensitivitySlope, {1.92868064e-07, -2.56848807e-04, -1.09205605e-06, 2.69701691e-05}, digits);
  expectNear(*z.sensitivityIntercept, {-1.32530093e-06, -4.69757625e-06}, digits);
  expectNear({z.electronicsT->begin(), z.electronicsT->end()}, {1.22280194e-06, -9.15403966e-06}, digits);
  expectNear({z.electronicsSensitivity->begin(), z.electronicsSensitivity->end()}, {4.50863634e-07, -3.35579780e-05},
             digits);
}

TEST(FieldFit, AxisMatrixAndItsAngles) {
  const AxisMatrixReport& report = *exampleRun().reports.axisMatrix;
  Eigen::Matrix3d expected;
  expected << 0.99998343, 0.01199965, -0.00899932, -0.01500026, 0.99998281, 0.01099991, 0.00800028, -0.01299974,
      0.99998155;
  EXPECT_LT((report.matrix - expected).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_NEAR(report.angleBetweenDeg[0], 90.17754720502695, 1e-9);
  EXPECT_NEAR(report.angleBetweenDeg[1], 90.06616342020159, 1e-9);
  EXPECT_NEAR(report.angleBetweenDeg[2], 90.1214258210575, 1e-9);
  EXPECT_NEAR(report.gain[1], 1.0001558, 1e-7);
  EXPECT_NEAR(report.tiltDeg[0], 0.859, 0.001); // atan(√(0.012² + 0.009²))
  EXPECT_LT(report.conditionNumber, 1.1);
  EXPECT_TRUE(report.notes.empty());
}

TEST(FieldFit, EveryBlockSaysHowItWasMade) {
  const FieldCalibration& result = exampleRun().result;
  EXPECT_EQ(result.blocks.size(), 3U + 1U + 3U + 3U + 3U + 3U + 1U);
  for (const BlockSummary& summary : result.blocks) {
    EXPECT_FALSE(summary.how.empty());
    EXPECT_GT(summary.rowsUsed, 0U);
    EXPECT_GT(summary.residualSigma, 0.0);
  }
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front().text;
  EXPECT_EQ(result.orders.size(), 21U);
  EXPECT_EQ(result.source.points, 12888);
  EXPECT_EQ(result.orderExplanation[0].substr(0, 40), "Order 5 leaves at most 0.0104 % of full ");
}

TEST(FieldFit, OutOfReadingCountsOnlyFieldsThatAreLargeEnough) {
  const auto& row = figuresOf(exampleRun().result.verification, Axis::X, VerifiedState::Uncalibrated);
  ASSERT_TRUE(row.ofReading);
  EXPECT_GT(row.ofReading->peak, row.ofFullScale.peak);
  EXPECT_LT(row.ofReading->peak, 6.0);
}

} // namespace
} // namespace straightedge::field
