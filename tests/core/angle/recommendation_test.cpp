#include "core/angle/comparison.h"
#include "tests/core/angle/model_curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace straightedge::angle {
namespace {

ComparisonRow row(const char* text, double maxError, std::optional<double> fine = {}) {
  const ModelName name = *parseModelName(text);
  return {name, name.storageEntries(), name.storageBytes(), maxError, maxError / 3.0, fine};
}

std::vector<std::string> names(const std::vector<ComparisonRow>& rows) {
  std::vector<std::string> texts;
  for (const ComparisonRow& each : rows) {
    texts.push_back(each.name.text());
  }
  return texts;
}

Comparison some() {
  return {{row("harmonic:3", 0.8), row("harmonic:4", 0.4), row("linear:16", 0.6), row("linear:17", 0.45),
           row("linear:17/8", 0.47), row("linear:15@minimax", 0.46), row("lut:64", 1.1), row("lut:147@midrange", 0.48),
           row("lut:300", 0.3, 0.35)}};
}

TEST(Recommendation, leastStorageThatMeetsTheTarget) {
  const Recommendation found = recommendForTarget(some(), 0.5);
  ASSERT_TRUE(found.choice);
  EXPECT_EQ(found.choice->name.text(), "harmonic:4");
  EXPECT_THAT(names(found.runnersUp), testing::ElementsAre("linear:15@minimax", "lut:147@midrange"));
  EXPECT_EQ(found.sentence, "harmonic:4 meets 0.5° with 9 entries (36 bytes), 0.400° maximum error; runners-up: "
                            "linear:15@minimax with 15 entries (60 bytes), 0.460°, lut:147@midrange with 147 entries "
                            "(588 bytes), 0.480°.");
}

TEST(Recommendation, ofEqualEntriesTheFewerBytesAndThenTheSmallerError) {
  const Comparison equals{{row("linear:17", 0.2), row("linear:17/12", 0.3), row("linear:17/8", 0.4)}};
  EXPECT_EQ(recommendForTarget(equals, 0.5).choice->name.text(), "linear:17/8");
  EXPECT_EQ(recommendForTarget(equals, 0.35).choice->name.text(), "linear:17/12");
  const Comparison twins{{row("linear:17@on-curve", 0.3), row("linear:17", 0.2)}};
  EXPECT_EQ(recommendForTarget(twins, 0.5).choice->name.text(), "linear:17");
}

TEST(Recommendation, oneRunnerUpOrNone) {
  EXPECT_THAT(recommendForTarget(some(), 0.401).sentence,
              testing::EndsWith("; runner-up: lut:300 with 300 entries (1200 bytes), 0.350°."));
  const Comparison one{{row("linear:17", 0.2)}};
  EXPECT_EQ(recommendForTarget(one, 0.25).sentence,
            "linear:17 meets 0.25° with 17 entries (68 bytes), 0.200° maximum error.");
}

TEST(Recommendation, digitsOfARoundingErrorAreNotShown) {
  const Comparison exact{{row("harmonic:8", 4.26e-14), row("linear:64", 0.02)}};
  EXPECT_THAT(recommendForBudget(exact, 64).sentence, testing::HasSubstr("less than 0.000001° maximum error"));
}

TEST(Recommendation, theFineGridCountsWhereItIsKnown) {
  EXPECT_FALSE(recommendForTarget(some(), 0.32).choice); // lut:300 reaches 0.3° only on the coarse grid
  EXPECT_TRUE(recommendForTarget(some(), 0.35).choice);
}

TEST(Recommendation, saysWhatIsReachableWhenNothingMeetsTheTarget) {
  const Recommendation found = recommendForTarget(some(), 0.01);
  EXPECT_FALSE(found.choice);
  EXPECT_TRUE(found.runnersUp.empty());
  EXPECT_EQ(
      found.sentence,
      "No model meets 0.01°; the most accurate is lut:300 with 300 entries (1200 bytes) and 0.350° maximum error.");
  EXPECT_EQ(recommendForTarget({}, 0.01).sentence, "No model meets 0.01°.");
}

TEST(Recommendation, leastErrorWithinTheBudget) {
  const Recommendation found = recommendForBudget(some(), 64);
  ASSERT_TRUE(found.choice);
  EXPECT_EQ(found.choice->name.text(), "harmonic:4");
  EXPECT_THAT(names(found.runnersUp), testing::ElementsAre("linear:17", "lut:64"));
  EXPECT_EQ(found.sentence,
            "harmonic:4 is the most accurate within 64 entries: 0.400° maximum error with 9 entries (36 "
            "bytes); runners-up: linear:17 with 17 entries (68 bytes), 0.450°, lut:64 with 64 entries "
            "(256 bytes), 1.10°.");
  EXPECT_EQ(recommendForBudget(some(), 8).choice->name.text(), "harmonic:3");
}

TEST(Recommendation, saysWhatTheSmallestNeedsWhenNothingFits) {
  const Recommendation found = recommendForBudget(some(), 1);
  EXPECT_FALSE(found.choice);
  EXPECT_EQ(found.sentence, "No model fits into 1 entry; the smallest is harmonic:3 with 7 entries (28 bytes).");
}

TEST(Recommendation, entriesNeededForTheSideShaftSweep) {
  // Table of an independent study of the same sweep: entries of each method for a maximum error.
  const Comparison quick = compareQuick(studiedCurve());
  const auto entriesOf = [&quick](FitMethod method, double target) {
    Comparison only;
    for (const ComparisonRow& each : quick.rows) {
      if (each.name.method == method) {
        only.rows.push_back(each);
      }
    }
    const Recommendation found = recommendForTarget(only, target);
    return found.choice ? found.choice->storageEntries : 0;
  };
  const std::vector<double> targets = {2.0, 1.0, 0.5, 0.2, 0.1};
  const std::map<FitMethod, std::vector<int>> expected = {{FitMethod::LeastSquares, {7, 11, 17, 27, 41}},
                                                          {FitMethod::OnCurve, {9, 14, 21, 37, 55}},
                                                          {FitMethod::ByAmplitude, {5, 7, 9, 13, 25}},
                                                          {FitMethod::Mean, {36, 74, 147, 363, 683}},
                                                          {FitMethod::MidRange, {34, 72, 147, 363, 683}}};
  for (const auto& [method, entries] : expected) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      EXPECT_EQ(entriesOf(method, targets[i]), entries[i]) << methodText(method) << " at " << targets[i];
    }
  }
}

} // namespace
} // namespace straightedge::angle
