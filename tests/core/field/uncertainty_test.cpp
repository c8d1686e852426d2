#include "core/export/field_calibration_json.h"
#include "core/field/field_fit.h"
#include "core/field/uncertainty.h"
#include "tests/core/field/example_campaign.h"
#include "tests/core/field/stepwise_chain.h"

#include <gmock/gmock.h>

#include <cmath>

namespace straightedge::field {
namespace {

TEST(HalfWidth95, isTheQuantileOfAFoldedNormal) {
  EXPECT_NEAR(halfWidth95(0.0, 1.0), 1.959963985, 1e-8);
  EXPECT_NEAR(halfWidth95(0.0, 3e-6), 5.879891954e-6, 1e-13);
  EXPECT_EQ(halfWidth95(-2e-5, 0.0), 2e-5);
  EXPECT_NEAR(halfWidth95(10.0, 1.0), 11.644853627, 1e-8);
  for (const double mean : {0.0, 0.2, 1.0, 2.5, 3.9, 4.1}) {
    const double half = halfWidth95(-mean, 1.0);
    const double inside = 0.5 * (std::erf((half - mean) / std::sqrt(2.0)) + std::erf((half + mean) / std::sqrt(2.0)));
    EXPECT_NEAR(inside, 0.95, 1e-10) << mean;
  }
}

class ExampleUncertainty : public ::testing::Test {
protected:
  static const FieldUncertainty& uncertainty() {
    static const FieldUncertainty one =
        *FieldUncertainty::of(exampleParts(), testing::stepwiseChain(exampleParts()), {}, "campaign.csv");
    return one;
  }
};

TEST_F(ExampleUncertainty, noiseIsThatOfTheRows) {
  for (const double sigma : uncertainty().noise().rawT) {
    EXPECT_GT(sigma, 3e-6);
    EXPECT_LT(sigma, 7e-6);
  }
  EXPECT_NEAR(uncertainty().noise().electronicsStepC, 0.0625, 1e-9);
  EXPECT_GE(uncertainty().noise().electronicsC, 0.0625 / std::sqrt(12.0));
}

TEST_F(ExampleUncertainty, readingsForFieldsComeBack) {
  const Eigen::Vector3d fieldT(1.2, -0.7, 0.4);
  const ReadingUncertainty u = uncertainty().at(uncertainty().readingFor(fieldT, 29.0, 21.0));
  EXPECT_LT((u.fieldT - u.residualT - fieldT).norm(), 1e-11);
  EXPECT_GT(u.residualT.norm(), 1e-6) << "the chain itself cannot follow";
}

TEST_F(ExampleUncertainty, everyContributionGrowsWhereItShould) {
  const auto at = [](double x, double probeC, double electronicsC) {
    return uncertainty().at(uncertainty().readingFor({x, 0.0, 0.0}, probeC, electronicsC));
  };
  EXPECT_GT(at(1.8, 24.0, 24.0).probeTemperatureT.x(), 5.0 * at(0.1, 24.0, 24.0).probeTemperatureT.x());
  EXPECT_GT(at(0.0, 24.0, 40.0).coefficientsT.x(), at(0.0, 24.0, 24.0).coefficientsT.x());
  EXPECT_GT(at(0.0, 45.0, 24.0).coefficientsT.x(), at(0.0, 24.0, 24.0).coefficientsT.x());
  EXPECT_NEAR(at(2.0, 24.0, 24.0).referenceT.x(), 2.0 * 2.9e-6, 1e-8);
  const ReadingUncertainty u = at(1.0, 30.0, 20.0);
  EXPECT_NEAR(u.combinedT.x(),
              std::sqrt(std::pow(u.repeatabilityT.x(), 2) + std::pow(u.probeTemperatureT.x(), 2) +
                        std::pow(u.electronicsTemperatureT.x(), 2) + std::pow(u.coefficientsT.x(), 2) +
                        std::pow(u.modelT.x(), 2) + std::pow(u.referenceT.x(), 2)),
              1e-12);
  EXPECT_EQ(u.expandedT.x(), halfWidth95(u.residualT.x(), u.combinedT.x()));
}

/// Of the verification, which no coefficient was fitted to.
TEST_F(ExampleUncertainty, holdsInTheVerification) {
  int within = 0;
  int all = 0;
  for (const Axis axis : allAxes) {
    const StepRows& rows = exampleParts().of(CampaignStep::Verification, axis);
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      const ReadingUncertainty u = uncertainty().at(
          {rows.pt100Ohm[i], rows.electronicsC[i], {rows.rawT(i, 0), rows.rawT(i, 1), rows.rawT(i, 2)}});
      const auto along = static_cast<Eigen::Index>(indexOf(axis));
      within += std::abs(u.fieldT[along] - rows.referenceT[i]) <= u.expandedT[along] ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(within, 0.93 * all);
}

TEST(UncertaintySummary, saysWhereItIsLargestAndWhatItIsMadeOf) {
  auto run = calibrateField(exampleCampaign(), {.method = FitMethod::Joint}, {});
  ASSERT_TRUE(run);
  run->result.traceability.reference.uncertainty = 20e-6;
  const auto summary = uncertaintyOf(*run);
  ASSERT_TRUE(summary) << summary.error().message();
  EXPECT_EQ(summary->referenceRelative, 5e-6);
  EXPECT_EQ(summary->shares.size(), 7U);
  EXPECT_EQ(summary->grid.size(), 3U * 5U * 17U);
  EXPECT_GT(summary->largestT, 1e-4);
  EXPECT_LT(summary->largestT, 3e-4) << "0.015 % of full scale";
  EXPECT_LT(summary->medianT, summary->largestT);
  for (const UncertaintyAt& at : summary->grid) {
    EXPECT_LE(at.expandedT, summary->largestT);
    EXPECT_GT(at.expandedT, 5e-6) << "a single reading's noise alone";
  }
  run->result.uncertainty = *summary;
  const auto read = exporting::fieldCalibrationFromJson(exporting::fieldCalibrationToJson(run->result), "c.json");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_TRUE(read->uncertainty);
  EXPECT_EQ(read->uncertainty->largestT, summary->largestT);
  EXPECT_EQ(read->uncertainty->shares.back().name, "reference");
  EXPECT_EQ(read->uncertainty->grid.back().expandedT, summary->grid.back().expandedT);
}

TEST_F(ExampleUncertainty, refusals) {
  CorrectionChain chain = testing::stepwiseChain(exampleParts());
  chain.axisMatrix->setZero();
  const auto wrong = FieldUncertainty::of(exampleParts(), chain, {}, "campaign.csv");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message(), ::testing::HasSubstr("cannot be inverted"));
}

} // namespace
} // namespace straightedge::field
