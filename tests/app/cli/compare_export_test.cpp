#include "core/export/tables.h"
#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace straightedge {
namespace {

using ::testing::HasSubstr;
using testing::runCli;
using ::testing::StartsWith;
using testing::TemporaryFolder;

const std::string sideShaft = STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv";

TEST(CompareCommand, WritesEverySizeAndRecommends) {
  const TemporaryFolder folder;
  const auto run = runCli({"angle", "compare", sideShaft, "--out", folder.path(), "--target-error", "0.5"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("harmonic:4 meets 0.5"));
  EXPECT_EQ(folder.listing(), "comparison.csv");
  const auto comparison = exporting::comparisonFromCsv(folder.read("comparison.csv"), "comparison.csv");
  ASSERT_TRUE(comparison) << comparison.error().message();
  std::size_t minimax = 0;
  for (const auto& row : comparison->rows) {
    EXPECT_EQ(row.maxErrorFineDeg.has_value(), row.storageEntries > 256) << row.name.text();
    minimax += row.name.method == angle::FitMethod::Minimax ? 1U : 0U;
  }
  // harmonics 0 to 16; four methods of 2 to 1024; minimax 2 to 64, 128, 256, 512, 1024
  EXPECT_EQ(comparison->rows.size(), 17U + 4U * 1023U + 63U + 4U);
  EXPECT_EQ(minimax, 67U);
}

class ExportCommand : public ::testing::Test {
protected:
  void SetUp() override { ASSERT_EQ(runCli({"angle", "fit", sideShaft, "--out", folder.file("c")}).code, 0); }
  TemporaryFolder folder;
};

TEST_F(ExportCommand, OneTableToStandardOutput) {
  const auto run =
      runCli({"export", folder.file("c/calibration.json"), "--model", "linear:32", "--format", "csv", "--out", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, folder.read("c/linear-32.csv"));
}

TEST_F(ExportCommand, AllTablesIntoAFolder) {
  const auto run = runCli({"export", folder.file("c/calibration.json"), "--format", "csv", "--out", folder.file("t")});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.listing("t"), "harmonic-4.csv linear-32.csv lut-64.csv");
  EXPECT_EQ(folder.read("t/lut-64.csv"), folder.read("c/lut-64.csv"));
}

TEST_F(ExportCommand, JsonIsTheSameToTheByte) {
  const auto run =
      runCli({"export", "-", "--format", "json", "--out", folder.file("copy.json")}, folder.read("c/calibration.json"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.read("copy.json"), folder.read("c/calibration.json"));
}

TEST_F(ExportCommand, AFieldCalibrationThatLacksSomethingIsNamed) {
  const std::string text = R"({"format": "straightedge-calibration", "version": 1, "kind": "field"})";
  const auto exported = runCli({"export", "-", "--format", "json", "--out", "-"}, text);
  EXPECT_EQ(exported.code, 3);
  EXPECT_EQ(exported.err, "straightedge-cli: standard input: full_scale_T is missing; write the file anew with "
                          "straightedge-cli field fit\n");
}

TEST_F(ExportCommand, FieldCalibrationsAreForTheFieldCommands) {
  const std::string text = R"({"format": "straightedge-calibration", "version": 1, "kind": "field"})";
  const auto run =
      runCli({"angle", "verify", "-", STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv", "--limit", "1"}, text);
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err, "straightedge-cli: standard input: this is a field calibration, an angle calibration is needed; "
                     "use the field commands or name another file\n");
}

} // namespace
} // namespace straightedge
