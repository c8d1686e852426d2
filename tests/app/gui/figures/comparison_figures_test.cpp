#include "app/gui/figures/comparison_figures.h"
#include "app/gui/figures/verification_figures.h"
#include "tests/app/gui/figures/example_results.h"

#include <gtest/gtest.h>

namespace straightedge::gui {
namespace {

const PlotGuide* guideOf(const PlotSpec& spec, const QString& id) {
  for (const PlotGuide& guide : spec.guides) {
    if (guide.id == id) {
      return &guide;
    }
  }
  return nullptr;
}

TEST(ComparisonFigure, HasASeriesPerMethodWhosePointsKnowTheirRows) {
  const auto results = testing::exampleResults();
  const ComparisonFigure figure = comparisonFigure(*results->comparison, {});
  ASSERT_EQ(figure.spec.series.size(), 5);
  EXPECT_TRUE(figure.spec.y.logarithmic);
  std::size_t points = 0;
  for (int s = 0; s < figure.spec.series.size(); ++s) {
    const PlotSeries& series = figure.spec.series[s];
    const auto& rows = figure.rows[static_cast<std::size_t>(s)];
    ASSERT_EQ(static_cast<std::size_t>(series.x.size()), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const angle::ComparisonRow& row = results->comparison->rows[rows[i]];
      ASSERT_EQ(series.x[static_cast<qsizetype>(i)], row.storageEntries);
      ASSERT_EQ(series.y[static_cast<qsizetype>(i)], row.maxErrorDeg);
    }
    points += rows.size();
  }
  EXPECT_EQ(points, results->comparison->rows.size());
}

TEST(ComparisonFigure, MarksTheChosenModelOnly) {
  const auto results = testing::exampleResults();
  const ComparisonFigure figure =
      comparisonFigure(*results->comparison, {.selected = testing::valueOf(angle::parseModelName("linear:32"))});
  qsizetype marked = 0;
  for (const PlotSeries& series : figure.spec.series) {
    marked += series.emphasised.count(true);
  }
  EXPECT_EQ(marked, 1);
  EXPECT_TRUE(figure.spec.series[1].emphasised[30]); // sizes start at 2
  EXPECT_EQ(figure.spec.series[1].pointLabels[30], "32 segments");
}

TEST(ComparisonFigure, ChangesMeasures) {
  const auto results = testing::exampleResults();
  const ComparisonFigure figure = comparisonFigure(
      *results->comparison, {.error = ErrorMeasure::Rms, .storage = StorageMeasure::Bytes, .budgetEntries = 64});
  EXPECT_EQ(figure.spec.x.title, "Storage (bytes)");
  EXPECT_EQ(figure.spec.y.title, "Rms error (°)");
  const angle::ComparisonRow& row = results->comparison->rows[figure.rows[1][30]];
  EXPECT_EQ(figure.spec.series[1].x[30], row.bytes);
  EXPECT_EQ(figure.spec.series[1].y[30], row.rmsErrorDeg);
  ASSERT_NE(guideOf(figure.spec, budgetGuide), nullptr);
  EXPECT_EQ(guideOf(figure.spec, budgetGuide)->value, 256.0);
}

TEST(ComparisonFigure, HasDraggableLinesForTheDemandsAndOneForTheData) {
  const auto results = testing::exampleResults();
  const PlotSpec spec =
      comparisonFigure(*results->comparison, {.targetErrorDeg = 0.5, .budgetEntries = 64, .leaveOneOutDeg = 0.2}).spec;
  ASSERT_NE(guideOf(spec, targetGuide), nullptr);
  EXPECT_TRUE(guideOf(spec, targetGuide)->draggable);
  EXPECT_FALSE(guideOf(spec, targetGuide)->vertical);
  EXPECT_TRUE(guideOf(spec, budgetGuide)->vertical);
  ASSERT_NE(guideOf(spec, "data"), nullptr);
  EXPECT_FALSE(guideOf(spec, "data")->draggable);
}

TEST(ComparisonFigure, LetsDustNotSqueezeTheAxisAndSaysSo) {
  angle::Comparison comparison;
  for (const double error : {1.0, 0.1, 1e-13}) {
    comparison.rows.push_back({testing::valueOf(angle::parseModelName("harmonic:4")), 9, 36, error, error, {}});
  }
  const PlotSpec spec = comparisonFigure(comparison, {}).spec;
  EXPECT_GT(*spec.y.minimum, 1e-3);
  EXPECT_TRUE(spec.note.startsWith("1 models leave less"));
}

TEST(ComparisonFigure, KeepsTheTargetLineInView) {
  const auto results = testing::exampleResults();
  EXPECT_GT(*comparisonFigure(*results->comparison, {.targetErrorDeg = 90.0}).spec.y.maximum, 90.0);
  EXPECT_LT(*comparisonFigure(*results->comparison, {.targetErrorDeg = 0.0002}).spec.y.minimum, 0.0002);
}

TEST(Budget, GoesToTheAxisAndBack) {
  for (const int entries : {1, 7, 64, 1024}) {
    for (const std::optional<int> bits : {std::optional<int>{}, std::optional<int>{12}, std::optional<int>{8}}) {
      EXPECT_EQ(budgetFromAxis(budgetOnAxis(entries, StorageMeasure::Bytes, bits), StorageMeasure::Bytes, bits),
                entries);
    }
    EXPECT_EQ(budgetFromAxis(entries + 0.9, StorageMeasure::Entries, {}), entries);
  }
  EXPECT_EQ(budgetFromAxis(0.01, StorageMeasure::Entries, {}), 1);
}

TEST(BeforeAfter, GivesALargeErrorBeforeAnAxisOfItsOwn) {
  const auto results = testing::exampleResults();
  const PlotSpec spec = beforeAfterFigure(*results->verification);
  ASSERT_EQ(spec.series.size(), 2);
  EXPECT_TRUE(spec.series[0].rightAxis); // tens of degrees before, under one after
  EXPECT_FALSE(spec.series[1].rightAxis);
  ASSERT_TRUE(spec.right.has_value());
  EXPECT_EQ(spec.guides.size(), 2);
  EXPECT_EQ(spec.guides[0].value, 1.0);
  EXPECT_EQ(spec.guides[1].value, -1.0);
  angle::VerificationReport small = *results->verification;
  small.maxErrorBeforeDeg = 2.0;
  EXPECT_FALSE(beforeAfterFigure(small).right.has_value());
}

TEST(CorrectedError, ShowsWhereTheLimitIsKeptBeyondDoubt) {
  const auto results = testing::exampleResults();
  angle::VerificationReport report = *results->verification;
  report.expandedUncertaintyDeg = 0.25;
  const PlotSpec spec = correctedErrorFigure(report);
  ASSERT_EQ(spec.series.size(), 3);
  EXPECT_EQ(spec.series[1].y, QList<double>(2, report.limitDeg - 0.25));
  EXPECT_EQ(spec.series[2].y, QList<double>(2, 0.25 - report.limitDeg));
  EXPECT_GT(*spec.y.maximum, report.limitDeg);
  report.expandedUncertaintyDeg = report.limitDeg; // nothing is beyond doubt then
  EXPECT_EQ(correctedErrorFigure(report).series.size(), 1);
  report.expandedUncertaintyDeg = 0.0;
  EXPECT_EQ(correctedErrorFigure(report).series.size(), 1);
}

} // namespace
} // namespace straightedge::gui
