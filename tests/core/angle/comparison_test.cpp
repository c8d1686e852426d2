#include "core/angle/comparison.h"
#include "core/base/csv_table.h"
#include "core/base/number_text.h"
#include "tests/core/angle/model_curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

namespace straightedge::angle {
namespace {

std::map<std::string, ComparisonRow> byName(const Comparison& comparison) {
  std::map<std::string, ComparisonRow> rows;
  for (const ComparisonRow& row : comparison.rows) {
    rows.emplace(row.name.text(), row);
  }
  return rows;
}

/// The background comparison is computed once for all tests.
const Comparison& fullComparison() {
  static const Comparison comparison = *compareFully(studiedCurve(), {}, {});
  return comparison;
}

void expectSame(const std::vector<ComparisonRow>& left, const std::vector<ComparisonRow>& right) {
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    ASSERT_EQ(left[i].name, right[i].name);
    ASSERT_EQ(left[i].maxErrorDeg, right[i].maxErrorDeg) << left[i].name.text();
    ASSERT_EQ(left[i].rmsErrorDeg, right[i].rmsErrorDeg) << left[i].name.text();
    ASSERT_EQ(left[i].maxErrorFineDeg, right[i].maxErrorFineDeg) << left[i].name.text();
  }
}

TEST(Comparison, agreesWithIndependentFiguresToTheirSixDigits) {
  const auto table = CsvTable::read(angleData("side_shaft_32_storage.csv"));
  ASSERT_TRUE(table) << table.error().message();
  const auto rows = byName(fullComparison());
  const auto expectDigits = [](double actual, double expected, const std::string& of) {
    EXPECT_NEAR(actual, expected, 5.1e-6 * expected) << of;
  };
  for (std::size_t i = 0; i < table->rows(); ++i) {
    const std::string text =
        std::string(table->cell(i, 0)) + ":" + std::string(table->cell(i, 2)) + "@" + std::string(table->cell(i, 1));
    const auto name = parseModelName(text);
    ASSERT_TRUE(name) << name.error().message();
    const ComparisonRow& row = rows.at(name->text());
    EXPECT_EQ(row.storageEntries, *parseInt(table->cell(i, 3))) << text;
    expectDigits(row.maxErrorDeg, *table->number(i, 4), text);
    if (name->method == FitMethod::Minimax) {
      continue; // its maximum is unique, the polygon that attains it is not
    }
    expectDigits(row.rmsErrorDeg, *table->number(i, 6), text);
    if (row.maxErrorFineDeg) {
      expectDigits(*row.maxErrorFineDeg, *table->number(i, 5), text);
    }
  }
}

TEST(Comparison, quickHasEverySizeOfEveryMethodInOrder) {
  const Comparison quick = compareQuick(sideShaftCurve());
  ASSERT_EQ(quick.rows.size(), 17U + 4U * 1023U);
  std::size_t at = 0;
  const auto expectGroup = [&](ModelKind kind, FitMethod method, int from, int to) {
    for (int size = from; size <= to; ++size, ++at) {
      const ComparisonRow& row = quick.rows[at];
      ASSERT_EQ(row.name, (ModelName{kind, size, method, {}}));
      ASSERT_EQ(row.storageEntries, row.name.storageEntries());
      ASSERT_EQ(row.bytes, 4 * row.storageEntries);
      ASSERT_GE(row.maxErrorDeg, row.rmsErrorDeg);
      ASSERT_FALSE(row.maxErrorFineDeg);
    }
  };
  expectGroup(ModelKind::Harmonic, FitMethod::ByAmplitude, 0, 16);
  expectGroup(ModelKind::Linear, FitMethod::LeastSquares, 2, 1024);
  expectGroup(ModelKind::Linear, FitMethod::OnCurve, 2, 1024);
  expectGroup(ModelKind::LookupTable, FitMethod::Mean, 2, 1024);
  expectGroup(ModelKind::LookupTable, FitMethod::MidRange, 2, 1024);
}

TEST(Comparison, rowsAreWhatSingleFitsSay) {
  for (const std::optional<int> bits : {std::optional<int>(), std::optional<int>(10)}) {
    const auto rows = byName(compareQuick(sideShaftCurve(), {bits}));
    for (const char* text : {"harmonic:0", "harmonic:9", "linear:2", "linear:63", "linear:1024", "linear:100@on-curve",
                             "lut:3", "lut:1000", "lut:64@midrange"}) {
      ModelName name = *parseModelName(text);
      name.bits = bits;
      const auto model = fitModel(sideShaftCurve(), name);
      ASSERT_TRUE(model);
      EXPECT_NEAR(rows.at(name.text()).maxErrorDeg, model->errors.maxCurveDeg, 1e-12) << name.text();
      EXPECT_NEAR(rows.at(name.text()).rmsErrorDeg, model->errors.rmsCurveDeg, 1e-12) << name.text();
      EXPECT_EQ(rows.at(name.text()).bytes, name.storageBytes());
    }
  }
}

TEST(Comparison, fullAddsMinimaxAndTheFineGrid) {
  const Comparison& full = fullComparison();
  std::vector<int> minimax;
  for (const ComparisonRow& row : full.rows) {
    EXPECT_EQ(row.maxErrorFineDeg.has_value(), row.name.size > 256) << row.name.text();
    if (row.maxErrorFineDeg) { // the fine grid contains the coarse one
      EXPECT_GE(*row.maxErrorFineDeg, row.maxErrorDeg - 1e-12) << row.name.text();
    }
    if (row.name.method == FitMethod::Minimax) {
      minimax.push_back(row.name.size);
    }
  }
  ASSERT_EQ(minimax.size(), 67U);
  EXPECT_EQ(minimax.front(), 2);
  EXPECT_EQ(minimax[62], 64);
  EXPECT_THAT(std::vector<int>(minimax.end() - 4, minimax.end()), testing::ElementsAre(128, 256, 512, 1024));
  std::vector<ComparisonRow> common;
  for (ComparisonRow row : full.rows) {
    row.maxErrorFineDeg.reset();
    if (row.name.method != FitMethod::Minimax) {
      common.push_back(row);
    }
  }
  expectSame(common, compareQuick(studiedCurve()).rows);
}

TEST(Comparison, storageBuysAccuracy) {
  // Not every single step does (neighbouring sizes go up and down), but doubling does here.
  const auto rows = byName(fullComparison());
  for (const FitMethod method : {FitMethod::LeastSquares, FitMethod::OnCurve, FitMethod::Minimax}) {
    for (int size = 8; size <= 512; size *= 2) {
      EXPECT_LT(rows.at(ModelName{ModelKind::Linear, 2 * size, method, {}}.text()).maxErrorDeg,
                rows.at(ModelName{ModelKind::Linear, size, method, {}}.text()).maxErrorDeg)
          << methodText(method) << " " << size;
    }
  }
}

TEST(Comparison, fewPointsResolveFewHarmonics) {
  CorrectionCurve curve = curveOfWaves(10.0, {{1, 2.0, 0.0}, {3, 0.5, 1.0}});
  curve.resolvableHarmonics = 4;
  const Comparison quick = compareQuick(curve);
  EXPECT_EQ(quick.rows.size(), 5U + 4U * 1023U);
  EXPECT_NEAR(quick.rows[0].maxErrorDeg, 2.5, 0.1);
  EXPECT_LT(quick.rows[2].maxErrorDeg, 1e-12);
}

TEST(Comparison, severalThreadsAtOnceFindTheSame) {
  const Comparison alone = compareQuick(sideShaftCurve());
  std::vector<Comparison> found(3);
  {
    std::vector<std::jthread> threads;
    for (Comparison& comparison : found) {
      threads.emplace_back([&comparison] { comparison = compareQuick(sideShaftCurve()); });
    }
  }
  for (const Comparison& comparison : found) {
    expectSame(comparison.rows, alone.rows);
  }
}

TEST(Comparison, reportsProgressAndCanBeStopped) {
  std::vector<double> reported;
  ASSERT_TRUE(compareFully(sideShaftCurve(), {8}, {{}, [&](double fraction) { reported.push_back(fraction); }}));
  EXPECT_GT(reported.size(), 50U);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_DOUBLE_EQ(reported.back(), 1.0);

  std::stop_source stop;
  double last = 0.0;
  const JobControl job{stop.get_token(), [&](double fraction) {
                         last = fraction;
                         if (fraction > 0.3) {
                           stop.request_stop();
                         }
                       }};
  const auto stopped = compareFully(sideShaftCurve(), {}, job);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
  EXPECT_LT(last, 0.35);
}

} // namespace
} // namespace straightedge::angle
