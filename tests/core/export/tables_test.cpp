#include "core/export/tables.h"

#include <gtest/gtest.h>

namespace straightedge::exporting {
namespace {

using namespace angle;

TEST(ModelTable, LinearHasARowPerValue) {
  Model model;
  model.name = {ModelKind::Linear, 4, FitMethod::LeastSquares, std::nullopt};
  model.body = LinearModel{Eigen::Vector4d(0.1, -1.5, 2.0, 1.0 / 3.0)};
  EXPECT_EQ(modelTableFileName(model), "linear-4.csv");
  EXPECT_EQ(modelTableCsv(model), "reading_deg,correction_deg\n0,0.1\n90,-1.5\n180,2\n270,0.3333333333333333\n");
}

TEST(ModelTable, LookupTableHasBinsAndStoredIntegers) {
  Model model;
  model.name = {ModelKind::LookupTable, 2, FitMethod::MidRange, 8};
  model.body = LookupTableModel{Eigen::Vector2d(-1.0, 1.0)};
  model.stored = StoredIntegers{8, 0.5, 0.0, std::nullopt, {-2, 2}};
  EXPECT_EQ(modelTableCsv(model), "from_deg,to_deg,correction_deg,stored\n0,180,-1,-2\n180,360,1,2\n");
}

TEST(ModelTable, HarmonicsKeepTheOffsetAsOrderZero) {
  Model model;
  model.name = {ModelKind::Harmonic, 2, FitMethod::ByAmplitude, 8};
  model.body = HarmonicModel{-90.25, {{2, 5.0, 0.5}, {1, 2.5, -0.5}}};
  EXPECT_EQ(modelTableCsv(model), "order,amplitude_deg,phase_rad\n0,-90.25,0\n2,5,0.5\n1,2.5,-0.5\n");
  model.stored = StoredIntegers{8, 2.5, -90.25, 0.5, {2, 1, 1, -1}};
  EXPECT_EQ(modelTableCsv(model), "order,amplitude_deg,phase_rad,stored_amplitude,stored_phase\n"
                                  "0,-90.25,0,,\n2,5,0.5,2,1\n1,2.5,-0.5,1,-1\n");
}

Comparison sample() {
  Comparison comparison;
  comparison.rows = {
      {{ModelKind::Harmonic, 0, FitMethod::ByAmplitude, std::nullopt}, 1, 4, 13.6, 1.0 / 3.0, std::nullopt},
      {{ModelKind::Linear, 512, FitMethod::OnCurve, std::nullopt}, 512, 2048, 0.01, 0.002, 0.02},
      {{ModelKind::LookupTable, 64, FitMethod::Mean, std::nullopt}, 64, 256, 1.2, 0.3, std::nullopt}};
  return comparison;
}

TEST(ComparisonCsv, HasThePublishedColumns) {
  EXPECT_EQ(comparisonCsv(sample()), "model,method,size,storage_entries,bytes,max_error_deg,rms_error_deg,"
                                     "max_error_65536_deg\nharmonic,amplitude,0,1,4,13.6,0.3333333333333333,\n"
                                     "linear,on-curve,512,512,2048,0.01,0.002,0.02\nlut,mean,64,64,256,1.2,0.3,\n");
}

TEST(ComparisonCsv, ReadsBackEqual) {
  const auto read = comparisonFromCsv(comparisonCsv(sample()), "comparison.csv");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->rows.size(), 3U);
  EXPECT_EQ(comparisonCsv(*read), comparisonCsv(sample()));
  EXPECT_EQ(read->rows[0].name, sample().rows[0].name);
  EXPECT_EQ(read->rows[0].rmsErrorDeg, 1.0 / 3.0);
  EXPECT_EQ(read->rows[1].maxErrorFineDeg, 0.02);
}

TEST(ComparisonCsv, RefusesWithThePlace) {
  const auto message = [](std::string text) { return comparisonFromCsv(std::move(text), "c.csv").error().message(); };
  EXPECT_EQ(message("model,method\nlinear,mean\n"),
            "c.csv: there is no column size; write the file anew with straightedge-cli angle compare");
  std::string text = comparisonCsv(sample());
  text.replace(text.find("on-curve"), 8, "by-magic");
  EXPECT_EQ(message(text).substr(0, 8), "c.csv:3:");
  text = comparisonCsv(sample());
  text.replace(text.find("0.02\n"), 4, "abcd");
  EXPECT_EQ(message(text), "c.csv:3: column \"max_error_65536_deg\" holds \"abcd\", which is no number; correct it or "
                           "remove the row");
}

} // namespace
} // namespace straightedge::exporting
