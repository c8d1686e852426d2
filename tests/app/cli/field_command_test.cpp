#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace straightedge {
namespace {

using ::testing::HasSubstr;
using testing::runCli;
using testing::TemporaryFolder;

const std::string example = STRAIGHTEDGE_TEST_DATA "/field/campaign.csv";

/// Fitted once: the file that the other commands take.
const std::string& exampleCalibration() {
  static const TemporaryFolder folder;
  static const std::string path = [] {
    const auto run = runCli({"field", "fit", example, "--out", folder.path(), "--serial", "SN 7"});
    EXPECT_EQ(run.code, 0) << run.err;
    return folder.file("calibration.json");
  }();
  return path;
}

TEST(FieldFitCommand, WritesTheCalibrationAndPrintsTheStages) {
  const TemporaryFolder folder;
  const auto run = runCli({"field", "fit", example, "--out", folder.file("new/out"), "--order", "3", "--full-scale",
                           "2.5", "--reference-temperature", "23", "--serial", "SN 7", "--device-model", "MFC"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.listing("new/out"), "calibration.json coefficients.csv nonlinearity-orders.csv verification.csv");
  EXPECT_THAT(run.out, HasSubstr("campaign.csv: 12888 rows, full scale 2.50 T"));
  EXPECT_THAT(run.out, HasSubstr("electronics-sensitivity"));
  EXPECT_THAT(run.out, HasSubstr("Verification, percent of full scale:"));
  const auto json = nlohmann::json::parse(folder.read("new/out/calibration.json"));
  EXPECT_EQ(json["kind"], "field");
  EXPECT_EQ(json["device"]["serial"], "SN 7");
  EXPECT_EQ(json["full_scale_T"], 2.5);
  EXPECT_EQ(json["reference_temperature_C"], 23.0);
  EXPECT_EQ(json["axes"]["z"]["nonlinearity"].size(), 4U);
  EXPECT_EQ(json["nonlinearity_orders"].size(), 21U);
  EXPECT_EQ(json["verification"].size(), 6U);
}

TEST(FieldFitCommand, JointAndStepwiseAreBothReported) {
  const TemporaryFolder folder;
  const auto run = runCli({"field", "fit", example, "--out", folder.path(), "--method", "joint"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("all blocks fitted together"));
  EXPECT_THAT(run.out, HasSubstr("The same fitted step by step:"));
  const auto json = nlohmann::json::parse(folder.read("calibration.json"));
  EXPECT_EQ(json["method"], "joint");
  EXPECT_FALSE(json["verification_stepwise"].empty());
}

TEST(FieldFitCommand, MissingStepsAreWarnedOf) {
  const TemporaryFolder folder;
  std::string campaign = "step,axis,reference_T,reference_locked,raw_x_T,raw_y_T,raw_z_T\n";
  for (int i = -5; i <= 5; ++i) {
    for (const char* axis : {"x", "y", "z"}) {
      campaign += "nonlinearity," + std::string(axis) + "," + std::to_string(0.4 * i) + ",1";
      for (const char* other : {"x", "y", "z"}) {
        campaign += "," + std::to_string(axis == std::string(other) ? 0.39 * i : 0.0);
      }
      campaign += "\n";
    }
  }
  const auto run = runCli({"field", "fit", "-", "--out", folder.path()}, campaign);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("straightedge-cli: warning: The block axis-matrix is off: the campaign has no rows of "
                                 "the step orientation."));
  const auto json = nlohmann::json::parse(folder.read("calibration.json"));
  EXPECT_TRUE(json["axes"]["x"]["offset_T"].is_null());
  EXPECT_TRUE(json["axis_matrix"].is_null());
  EXPECT_TRUE(json["verification"].empty());
}

TEST(FieldFitCommand, RefusesInOneLine) {
  const TemporaryFolder folder;
  folder.write("bad.csv", "step,raw_x_T,raw_y_T,raw_z_T\noffset,1,0,0\n");
  const auto run = runCli({"field", "fit", folder.file("bad.csv"), "--out", folder.file("out")});
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err, "straightedge-cli: " + folder.file("bad.csv") +
                         ":2: the column \"pt100_ohm\" is missing, which rows of the step offset need; add it, or "
                         "remove the rows of that step\n");
  EXPECT_EQ(folder.listing(), "bad.csv");
  EXPECT_EQ(runCli({"field", "fit", example, "--out", folder.path(), "--order", "8"}).code, 2);
  EXPECT_EQ(runCli({"field", "fit", example, "--out", folder.path(), "--full-scale", "-1"}).code, 2);
  EXPECT_EQ(runCli({"field", "fit", example, "--out", folder.path(), "--method", "magic"}).code, 2);
  EXPECT_EQ(runCli({"field"}).code, 2);
}

TEST(FieldVerifyCommand, PassesAndFails) {
  const auto pass = runCli({"field", "verify", exampleCalibration(), example, "--limit", "0.014"});
  EXPECT_EQ(pass.code, 0) << pass.err;
  EXPECT_THAT(pass.out, HasSubstr("PASS: largest error 0.01298 % of full scale on axis z over 1800 points"));
  const auto fail = runCli({"field", "verify", exampleCalibration(), example, "--limit", "0.012"});
  EXPECT_EQ(fail.code, 1);
  EXPECT_THAT(fail.out, HasSubstr("FAIL"));
}

TEST(FieldVerifyCommand, GivesJson) {
  const auto run =
      runCli({"field", "verify", exampleCalibration(), example, "--limit", "0.02", "--json", "--of", "reading"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["met"], true);
  EXPECT_EQ(json["percent_of"], "reading");
  EXPECT_NEAR(json["peak_percent"].get<double>(), 0.012977438874956443, 1e-9);
  EXPECT_EQ(json["points"], 1800);
  EXPECT_EQ(json["device"]["serial"], "SN 7");
}

TEST(FieldVerifyCommand, RefusesWhatItCannotVerify) {
  const auto nothing = runCli({"field", "verify", exampleCalibration(), "-", "--limit", "1"},
                              "step,axis,reference_T,raw_x_T,raw_y_T,raw_z_T\nnonlinearity,x,1,1,0,0\n");
  EXPECT_EQ(nothing.code, 3);
  EXPECT_EQ(nothing.err, "straightedge-cli: standard input: the campaign has no rows of the step verification; record "
                         "known fields at various temperatures in this step\n");
  EXPECT_EQ(runCli({"field", "verify", exampleCalibration(), example, "--limit", "0"}).code, 2);
  EXPECT_EQ(runCli({"field", "verify", exampleCalibration(), example}).code, 2);
  EXPECT_EQ(runCli({"field", "verify", example, example, "--limit", "1"}).code, 3);
}

TEST(FieldExport, JsonIsTheSameFileAndCsvATablePerBlock) {
  const TemporaryFolder folder;
  ASSERT_EQ(runCli({"export", exampleCalibration(), "--format", "csv", "--out", folder.file("tables")}).code, 0);
  EXPECT_EQ(folder.listing("tables"), "axis-matrix.csv electronics-sensitivity.csv electronics.csv "
                                      "nonlinearity-orders.csv nonlinearity.csv offset.csv pt100.csv sensitivity.csv "
                                      "verification.csv");
  const auto one = runCli({"export", exampleCalibration(), "--format", "csv", "--out", "-"});
  EXPECT_THAT(one.out, HasSubstr("block,axis,name,power,value,unit\nprobe-temperature,,intercept_C,0,-279.07"));
  ASSERT_EQ(runCli({"export", exampleCalibration(), "--format", "json", "--out", folder.file("c.json")}).code, 0);
  EXPECT_THAT(folder.read("c.json"), HasSubstr("\"kind\": \"field\""));
  const auto model = runCli({"export", exampleCalibration(), "--model", "linear:8", "--format", "csv", "--out", "-"});
  EXPECT_EQ(model.code, 2);
  EXPECT_THAT(model.err, HasSubstr("a field calibration has no models; leave out --model"));
}

} // namespace
} // namespace straightedge
