// Every row of the published table of exit codes that this program can reach without instruments, each with its line on
// standard error.
#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace straightedge {
namespace {

using ::testing::HasSubstr;
using testing::runCli;
using ::testing::StartsWith;
using testing::TemporaryFolder;

const std::string sideShaft = STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv";

class ExitCode : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_EQ(runCli({"angle", "fit", sideShaft, "--out", folder.path()}).code, 0);
    calibration = folder.file("calibration.json");
  }
  void expectLine(const std::vector<std::string>& arguments, int code, const std::string& line,
                  const std::string& input = {}) const {
    const auto run = runCli(arguments, input);
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_EQ(run.err, "straightedge-cli: " + line + "\n");
  }
  TemporaryFolder folder;
  std::string calibration;
};

TEST_F(ExitCode, ZeroForHelpAndVersion) {
  const auto version = runCli({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out, "straightedge-cli " STRAIGHTEDGE_VERSION "\n");
  for (const std::vector<std::string>& command : {std::vector<std::string>{"--help"},
                                                  {"angle", "--help"},
                                                  {"angle", "fit", "--help"},
                                                  {"angle", "batch", "-h"}}) {
    const auto help = runCli(command);
    EXPECT_EQ(help.code, 0);
    EXPECT_THAT(help.out, HasSubstr("Usage"));
    EXPECT_EQ(help.err, "");
  }
}

TEST_F(ExitCode, ZeroOrOneForVerify) {
  const auto passed = runCli({"angle", "verify", calibration, sideShaft, "--limit", "0.4"});
  EXPECT_EQ(passed.code, 0) << passed.err;
  EXPECT_THAT(passed.out, StartsWith("PASS: harmonic:4 over 32 points: 0.3914° maximum error"));
  const auto failed = runCli({"angle", "verify", calibration, sideShaft, "--limit", "0.39"});
  EXPECT_EQ(failed.code, 1);
  EXPECT_THAT(failed.out, StartsWith("FAIL: "));
  EXPECT_EQ(failed.err, "");
  EXPECT_EQ(runCli({"angle", "verify", calibration, sideShaft, "--limit", "0.39", "--model", "linear:32"}).code, 0);
}

TEST_F(ExitCode, VerifyPrintsOneJsonObject) {
  const auto run = runCli({"angle", "verify", calibration, "-", "--limit", "0.39", "--json"},
                          "encoder_deg,sensor_deg\n0,266.31\n11.25,278.61\n");
  EXPECT_THAT(run.out, StartsWith("{\n"));
  EXPECT_THAT(run.out, HasSubstr("\"met\": "));
  EXPECT_THAT(run.out, HasSubstr("\"limit_deg\": 0.39"));
  EXPECT_THAT(run.out, HasSubstr("\"points\": 2"));
}

TEST_F(ExitCode, TwoForWrongUsage) {
  const std::string fit = "; see straightedge-cli angle fit --help";
  expectLine({}, 2, "a subcommand is required; see straightedge-cli --help");
  expectLine({"angle", "fit", sideShaft}, 2, "--out is required" + fit);
  expectLine({"angle", "fit", "--out", folder.path()}, 2, "SWEEP.csv is required" + fit);
  expectLine({"angle", "fit", sideShaft, "--out", "x", "--frobnicate"}, 2,
             "the following argument was not expected: --frobnicate" + fit);
  expectLine({"angle", "fit", sideShaft, "--out", "x", "--model", "linear:1"}, 2,
             "model 'linear:1': size 1 is out of range; use 2 to 1024");
  expectLine({"angle", "fit", sideShaft, "--out", "x", "--model", "lut:64", "--model", "lut:64@mean"}, 2,
             "--model lut:64 is given twice; name each model once");
  expectLine({"angle", "fit", sideShaft, "--out", "x", "--ambient", "warm"}, 2,
             "--ambient warm is no number; write it as in --ambient 23.5");
  expectLine({"angle", "fit", sideShaft, "--out", "x", "--reference-due", "2027-02-30"}, 2,
             "--reference-due 2027-02-30 is no date; write it as in --reference-due 2027-01-31");
  expectLine({"angle", "verify", calibration, sideShaft, "--limit", "-1"}, 2,
             "--limit -1 is out of range; give a value from 1e-09 to 180.0");
  expectLine({"angle", "verify", calibration, sideShaft, "--limit", "0.5", "--model", "linear:33"}, 2,
             calibration +
                 ": there is no model linear:33 in the calibration; choose one of harmonic:4, linear:32, lut:64");
  expectLine({"angle", "compare", sideShaft, "--out", "x", "--bits", "7"}, 2,
             "--bits 7 is out of range; give a whole number from 8 to 16");
  expectLine({"angle", "batch", folder.path(), "--out", "x", "--jobs", "0"}, 2,
             "--jobs 0 is out of range; give a whole number from 1 to 1024");
  expectLine({"export", calibration, "--format", "csv", "--out", "-"}, 2,
             "--out - cannot take 3 tables; choose one with --model, or name a folder");
}

TEST_F(ExitCode, ThreeForInputThatIsRejected) {
  const std::string out = folder.file("out");
  const std::string bad = folder.write("bad.csv", "encoder_deg,sensor_deg\n0,1\n10,abc\n");
  expectLine({"angle", "fit", bad, "--out", out}, 3,
             bad + ":3: column \"sensor_deg\" holds \"abc\", which is no number; correct it or remove the row");
  expectLine({"angle", "fit", folder.file("none.csv"), "--out", out}, 3,
             folder.file("none.csv") + ": the file does not exist; check the name and the folder");
  expectLine({"angle", "compare", folder.path(), "--out", out}, 3,
             folder.path() + ": this is a folder, not a file; name a file inside it");
  expectLine({"angle", "fit", "-", "--out", out}, 3,
             "standard input: the file is empty; record or export the data again");
  const std::string nan = folder.write("nan.csv", "0,1\n10,nan\n20,3\n");
  const auto run = runCli({"angle", "fit", nan, "--out", out});
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, StartsWith("straightedge-cli: " + nan + ":2: ")) << "the path as given, not only the name";
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  expectLine({"angle", "apply", sideShaft, sideShaft}, 3,
             sideShaft + ":1: this is not JSON at column 1; write the file anew with straightedge-cli angle fit");
  EXPECT_FALSE(std::filesystem::exists(out)) << "rejected input leaves no folder behind";
}

TEST_F(ExitCode, FiveForOutputThatCannotBeWritten) {
  const std::string file = folder.write("file", "");
  expectLine({"angle", "fit", sideShaft, "--out", file, "--model", "harmonic:4"}, 5,
             file + ": there is a file of this name, a folder is needed; choose another name");
  expectLine({"angle", "apply", calibration, sideShaft, "--out", "/dev/full"}, 5,
             "/dev/full: the disk is full; free some space or write to another folder");
  expectLine({"export", calibration, "--format", "json", "--out", folder.file("no/x.json")}, 5,
             folder.file("no/x.json") + ": the folder does not exist; create it or choose another one");
}

} // namespace
} // namespace straightedge
