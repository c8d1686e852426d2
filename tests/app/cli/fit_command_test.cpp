#include "core/export/calibration_json.h"
#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace straightedge {
namespace {

using ::testing::HasSubstr;
using testing::runCli;
using testing::TemporaryFolder;

const std::string sideShaft = STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv";

nlohmann::json expectedFigures() {
  std::ifstream file(STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32_expected.json");
  return nlohmann::json::parse(file);
}

TEST(FitCommand, GivesTheKnownFiguresOfTheSideShaft) {
  const TemporaryFolder folder;
  const auto run = runCli({"angle", "fit", sideShaft, "--out", folder.file("new/out"), "--serial", "SN 7",
                           "--device-model", "MX", "--operator", "A. B.", "--reference-uncertainty", "0.002",
                           "--reference-due", "2027-01-31", "--ambient", "23.5"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.listing("new/out"), "calibration.json harmonic-4.csv linear-32.csv lut-64.csv");
  EXPECT_THAT(run.out, HasSubstr("Leave-one-out error"));
  EXPECT_THAT(run.out, HasSubstr("harmonic:4"));

  const auto expected = expectedFigures();
  const double tolerance = expected["tolerance_deg"];
  const auto calibration = exporting::readCalibration(folder.file("new/out/calibration.json"));
  ASSERT_TRUE(calibration) << calibration.error().message();
  EXPECT_EQ(calibration->traceability.deviceSerial, "SN 7");
  EXPECT_EQ(calibration->traceability.ambientC, 23.5);
  EXPECT_EQ(calibration->traceability.reference.uncertainty, 0.002);
  ASSERT_EQ(calibration->models.size(), 3U);
  const auto& harmonics = std::get<angle::HarmonicModel>(calibration->models[0].body);
  EXPECT_NEAR(harmonics.offsetDeg, expected["harmonics"]["offset_deg"].get<double>(), tolerance);
  ASSERT_EQ(harmonics.terms.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& term = expected["harmonics"]["terms"][i];
    EXPECT_EQ(harmonics.terms[i].order, term["order"].get<int>());
    EXPECT_NEAR(harmonics.terms[i].amplitudeDeg, term["amplitude_deg"].get<double>(), tolerance);
    EXPECT_NEAR(harmonics.terms[i].phaseRad, term["phase_rad"].get<double>(), tolerance);
  }
  const auto& linear = std::get<angle::LinearModel>(calibration->models[1].body).valuesDeg;
  const auto& table = std::get<angle::LookupTableModel>(calibration->models[2].body).valuesDeg;
  for (int i = 0; i < 32; ++i) {
    EXPECT_NEAR(linear[i], expected["linear_32_deg"][static_cast<std::size_t>(i)].get<double>(), tolerance);
  }
  for (int i = 0; i < 64; ++i) {
    EXPECT_NEAR(table[i], expected["lut_64_deg"][static_cast<std::size_t>(i)].get<double>(), tolerance);
  }
  for (const auto& model : calibration->models) {
    const auto& errors = expected["errors"][model.name.text()];
    EXPECT_NEAR(model.errors.maxCurveDeg, errors["max_curve_deg"].get<double>(), tolerance);
    EXPECT_NEAR(model.errors.rmsCurveDeg, errors["rms_curve_deg"].get<double>(), tolerance);
    EXPECT_NEAR(model.errors.maxPointsDeg, errors["max_points_deg"].get<double>(), tolerance);
    EXPECT_NEAR(model.errors.rmsPointsDeg, errors["rms_points_deg"].get<double>(), tolerance);
  }
}

TEST(FitCommand, ModelsAreThoseAskedFor) {
  const TemporaryFolder folder;
  const auto run = runCli(
      {"angle", "fit", sideShaft, "--out", folder.path(), "--model", "linear:16@minimax/12", "--model", "harmonic:2"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.listing(), "calibration.json harmonic-2.csv linear-16-minimax-12bit.csv");
}

TEST(FitCommand, ReadsStandardInputAndWarnsOnStandardError) {
  const TemporaryFolder folder;
  std::string sweep;
  for (int i = 0; i < 12; ++i) {
    sweep += std::to_string(30 * i) + ";" + std::to_string(30 * i) + ",25\n";
  }
  const auto run = runCli({"angle", "fit", "-", "--out", folder.path(), "--model", "harmonic:1"}, sweep);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("straightedge-cli: warning: "));
  EXPECT_THAT(run.out, HasSubstr("standard input: 12 points"));
}

TEST(FitCommand, RunsAreEqualToTheByteWithTheSameClock) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) {
    ASSERT_EQ(runCli({"angle", "fit", sideShaft, "--out", folder.file(name)}, "",
                     STRAIGHTEDGE_BINARY_DIR "/straightedge-cli", {"SOURCE_DATE_EPOCH=0"})
                  .code,
              0);
  }
  EXPECT_EQ(folder.read("a/calibration.json"), folder.read("b/calibration.json"));
  EXPECT_THAT(folder.read("a/calibration.json"), HasSubstr("1970-01-01T00:00:00Z"));
}

TEST(FitCommand, WithoutTheDesktopApplicationPlotsSaySo) {
  const TemporaryFolder folder;
  const std::string alone = folder.file("straightedge-cli");
  std::filesystem::copy_file(STRAIGHTEDGE_BINARY_DIR "/straightedge-cli", alone);
  const auto run = runCli({"angle", "fit", sideShaft, "--out", folder.file("out"), "--plots", "--model", "harmonic:4"},
                          "", alone, {"PATH=" + folder.path()});
  EXPECT_EQ(run.code, 5);
  EXPECT_EQ(run.err, "straightedge-cli: the program straightedge, which draws plots and reports, is neither beside "
                     "straightedge-cli nor on PATH; install the desktop application, or leave out --plots and "
                     "--report\n");
  EXPECT_EQ(folder.listing("out"), "calibration.json harmonic-4.csv");
}

/// A stand-in for the desktop application that notes how it was called.
std::string withStandIn(const TemporaryFolder& folder, const std::string& script) {
  const std::string program = folder.file("straightedge-cli");
  std::filesystem::copy_file(STRAIGHTEDGE_BINARY_DIR "/straightedge-cli", program);
  folder.write("straightedge", "#!/bin/sh\n" + script + "\n");
  std::filesystem::permissions(folder.file("straightedge"), std::filesystem::perms::owner_all);
  return program;
}

TEST(FitCommand, PlotsAndReportComeFromTheDesktopApplicationWithoutDisplay) {
  const TemporaryFolder folder;
  const std::string program =
      withStandIn(folder, "echo \"$QT_QPA_PLATFORM $@\" > " + folder.file("called") + "; echo drawn");
  const auto run = runCli({"angle", "fit", sideShaft, "--out", folder.file("out"), "--plots", "--report"}, "", program);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.read("called"), "offscreen --render " + folder.file("out") + "/calibration.json --out " +
                                       folder.file("out") + " --plots --report --sweep " + sideShaft + "\n");
}

TEST(FitCommand, FailedDrawingIsOneLine) {
  const TemporaryFolder folder;
  const std::string program = withStandIn(folder, "echo; echo no font >&2; echo more >&2; exit 3");
  const auto run = runCli({"angle", "fit", sideShaft, "--out", folder.file("out"), "--report", "--model", "harmonic:4"},
                          "", program);
  EXPECT_EQ(run.code, 5);
  EXPECT_EQ(run.err, "straightedge-cli: " + folder.file("straightedge") +
                         ": drawing plots or the report ended with code 3 (no font); everything else is "
                         "written; try straightedge --render by hand\n");
}

} // namespace
} // namespace straightedge
