#include "core/field/storage.h"
#include "tests/core/field/example_campaign.h"
#include "tests/core/field/sample_chain.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace straightedge::field {
namespace {

TEST(ChainSize, countsWhatTheFormulaNeeds) {
  // Per axis: 6 + 2 + 4 + 2 + 2 + 2 coefficients; 5 + 1 + (3 + 1) + 1 + 1 + (1 + 1) multiplications. Then the PT100's
  // line and the matrix.
  const ChainSize size = sizeOf(testing::sampleChain());
  EXPECT_EQ(size.coefficients, 3U * 18U + 2U + 9U);
  EXPECT_EQ(size.multiplications, 3U * 14U + 1U + 9U);
  CorrectionChain zeros = testing::sampleChain();
  for (AxisChain& axis : zeros.axes) {
    axis.sensitivityIntercept = std::vector<double>{0.0, 0.0};
    axis.offsetT = {{0.0, 1e-6}};
  }
  EXPECT_EQ(sizeOf(zeros).coefficients, 3U * 15U + 2U + 9U) << "coefficients that are 0 are not stored";
  EXPECT_EQ(sizeOf(zeros).multiplications, 3U * 13U + 1U + 9U);
  EXPECT_EQ(sizeOf(CorrectionChain{}).coefficients, 0U);
}

class Storage : public ::testing::Test {
protected:
  static const StorageComparison& comparison() {
    static const StorageComparison result = *compareStorage(*calibrateField(exampleCampaign(), {}, {}));
    return result;
  }
  static const StorageChoice& choice(const std::string& name) {
    const auto& choices = comparison().choices;
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const auto& one) { return one.name == name; });
    EXPECT_NE(found, choices.end()) << name;
    return found == choices.end() ? choices.front() : *found;
  }
};

TEST_F(Storage, ordersAgainstWhatTheyLeave) {
  EXPECT_EQ(comparison().measuredWith, "verification");
  EXPECT_EQ(comparison().choices.size(), 7U * 3U + 4U);
  double before = 100.0;
  for (const int order : {1, 3, 5, 7}) { // the curve is odd: even orders hardly help
    const StorageChoice& of = choice("order " + std::to_string(order) + ", slope 3");
    EXPECT_LT(of.largestPeakPercent, 0.6 * before) << of.name;
    EXPECT_EQ(of.chain.axes[0].nonlinearity.size(), static_cast<std::size_t>(order) + 1);
    EXPECT_GT(of.rmsPercent[0], 0.0);
    before = of.largestPeakPercent;
  }
  EXPECT_LT(choice("order 5, slope 3").largestPeakPercent, 0.0105);
  EXPECT_EQ(choice("order 5, slope 3").size.coefficients, choice("order 5, slope 1").size.coefficients + 6U);
  EXPECT_EQ(choice("order 5, slope 3").size.multiplications, choice("order 5, slope 1").size.multiplications + 6U);
}

TEST_F(Storage, everyBlockLeftOutCosts) {
  const double all = choice("order 5, slope 3").largestPeakPercent;
  EXPECT_GT(choice("without sensitivity").largestPeakPercent, 5.0 * all);
  EXPECT_GT(choice("without electronics sensitivity").largestPeakPercent, 1.5 * all);
  EXPECT_FALSE(choice("without electronics").chain.axes[1].electronicsT);
  EXPECT_LT(choice("without sensitivity").size.coefficients, choice("order 5, slope 3").size.coefficients);
  EXPECT_EQ(choice("without offset").size.coefficients, choice("order 5, slope 3").size.coefficients)
      << "the constant of the sensitivity's slope takes its place";
}

TEST_F(Storage, theBestOfTheirSizeAreMarked) {
  for (const StorageChoice& one : comparison().choices) {
    const bool beaten =
        std::any_of(comparison().choices.begin(), comparison().choices.end(), [&](const StorageChoice& other) {
          return other.size.coefficients <= one.size.coefficients && other.largestPeakPercent < one.largestPeakPercent;
        });
    EXPECT_EQ(one.isBest, !beaten) << one.name;
  }
}

TEST_F(Storage, canBeStopped) {
  std::stop_source source;
  source.request_stop();
  const auto run = calibrateField(exampleCampaign(), {}, {});
  const auto stopped = compareStorage(*run, {source.get_token(), {}});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
}

} // namespace
} // namespace straightedge::field
