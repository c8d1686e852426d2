#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace straightedge {
namespace {

using testing::ChildResult;
using ::testing::HasSubstr;
using testing::runCli;
using testing::TemporaryFolder;

/// A sweep with an error of one harmonic, different for every number.
std::string sweepText(int number) {
  std::string text = "encoder_deg,sensor_deg\n";
  for (int i = 0; i < 24; ++i) {
    text += std::to_string(15 * i) + "," + std::to_string(15 * i) + "." + std::to_string((7 * i + number) % 10) + "\n";
  }
  return text;
}

ChildResult batch(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"angle", "batch"});
  return runCli(arguments, "", STRAIGHTEDGE_BINARY_DIR "/straightedge-cli", {"SOURCE_DATE_EPOCH=0"});
}

TEST(BatchCommand, ResultsDoNotDependOnTheNumberOfJobs) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("in"));
  for (int i = 0; i < 40; ++i) {
    folder.write("in/s" + std::to_string(i) + ".csv", i == 7 ? "broken" : sweepText(i));
  }
  for (const char* jobs : {"1", "2", "7"}) {
    const auto run = batch({folder.file("in"), "--out", folder.file(jobs), "--jobs", jobs, "--model", "linear:8"});
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("straightedge-cli: " + folder.file("in/s7.csv") + ": "));
    EXPECT_THAT(run.err, ::testing::Not(HasSubstr("\r"))) << "progress is for terminals";
    EXPECT_THAT(run.out, HasSubstr("39 of 40 sweeps calibrated, 1 rejected"));
  }
  const std::string files = folder.listing("1");
  EXPECT_EQ(std::count(files.begin(), files.end(), ' '), 39) << "39 results and a summary";
  for (const char* jobs : {"2", "7"}) {
    ASSERT_EQ(folder.listing(jobs), files);
    for (const auto& entry : std::filesystem::directory_iterator(folder.file("1"))) {
      const std::string name = entry.path().filename().string();
      EXPECT_EQ(folder.read(std::string(jobs) + "/" + name), folder.read("1/" + name)) << name;
    }
  }
  const std::string summary = folder.read("1/summary.csv");
  EXPECT_EQ(std::count(summary.begin(), summary.end(), '\n'), 1 + 40) << "a row per input and model";
}

TEST(BatchCommand, InputsOfTheSameNameKeepApart) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b", "c"}) {
    std::filesystem::create_directory(folder.file(name));
  }
  folder.write("a/x.csv", sweepText(1));
  folder.write("b/x.csv", sweepText(2));
  folder.write("c/x-2.csv", sweepText(3));
  folder.write("list.txt", "# inputs\na/x.csv\r\n\n" + folder.file("b/x.csv") + "\nc/x-2.csv\n");
  const auto run = batch({folder.file("list.txt"), "--out", folder.file("out")});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.listing("out"), "summary.csv x-2.json x-3.json x.json");
  EXPECT_THAT(run.err, HasSubstr("straightedge-cli: warning: another input is called x: the result of " +
                                 folder.file("b/x.csv") + " is x-3.json"));
  EXPECT_THAT(folder.read("out/x-2.json"), HasSubstr("\"file\": \"x-2.csv\""));
}

TEST(BatchCommand, AFolderOfSessionsIsCalibratedToo) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("in"));
  const auto captured = runCli({"capture", "angle", "--bench", "simulated", "--session", folder.file("in/one.sedge"),
                                "--points", "32", "--seed", "3"});
  ASSERT_EQ(captured.code, 0) << captured.err;
  const auto run = batch({folder.file("in"), "--out", folder.file("out")});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.listing("out"), "one.json summary.csv");
}

TEST(BatchCommand, AFolderMayBeItsOwnOutput) {
  const TemporaryFolder folder;
  folder.write("x.CSV", sweepText(1));
  EXPECT_EQ(batch({folder.path(), "--out", folder.path()}).code, 0);
  EXPECT_EQ(batch({folder.path(), "--out", folder.path()}).code, 0) << "summary.csv is no input";
}

TEST(BatchCommand, SaysWhatIsMissing) {
  const TemporaryFolder folder;
  EXPECT_EQ(batch({folder.path(), "--out", folder.file("out")}).err,
            "straightedge-cli: " + folder.path() +
                ": the folder holds no *.csv and no *.sedge; name the folder with the sweeps\n");
  folder.write("list", "# none\n");
  EXPECT_EQ(batch({folder.file("list"), "--out", folder.file("out")}).err,
            "straightedge-cli: " + folder.file("list") + ": the list names no files; write a path in each line\n");
  folder.write("x.csv", sweepText(1));
  folder.write("file", "");
  EXPECT_EQ(batch({folder.path(), "--out", folder.file("file")}).code, 5);
}

} // namespace
} // namespace straightedge
