// The two places where the command line works in several threads, in this process so that TSan sees them.
#include "app/cli/angle_correction.h"
#include "app/cli/apply_stream.h"
#include "app/cli/batch_run.h"
#include "tests/core/base/temporary_folder.h"

#include <gtest/gtest.h>

namespace straightedge::cli {
namespace {

using testing::TemporaryFolder;

angle::Model shiftByHalf() {
  angle::Model model;
  model.name = {angle::ModelKind::Linear, 2, angle::FitMethod::LeastSquares, std::nullopt};
  model.body = angle::LinearModel{Eigen::Vector2d(0.5, 0.5)};
  return model;
}

TEST(ParallelWork, ApplyKeepsOrderWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  std::string readings = "sensor_deg\n";
  std::string expected = "sensor_deg,corrected_deg\n";
  constexpr int rows = 150'000;
  for (int i = 0; i < rows; ++i) {
    const std::string reading = std::to_string(i % 359);
    readings += reading + "\n";
    expected += reading + "," + reading + ".5\n";
  }
  folder.write("r.csv", readings);
  for (const unsigned threads : {1U, 3U, 8U}) {
    const auto report = applyToReadings(folder.file("r.csv"), folder.file("out.csv"),
                                        angleCorrection(shiftByHalf(), angle::SensorDirection::Increasing), threads);
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_EQ(report->rows, static_cast<std::size_t>(rows));
    EXPECT_EQ(report->bytesRead, readings.size());
    EXPECT_TRUE(folder.read("out.csv") == expected);
  }
}

TEST(ParallelWork, ABadRowEndsEveryThread) {
  const TemporaryFolder folder;
  std::string readings = "sensor_deg\n";
  for (int i = 0; i < 100'000; ++i) {
    readings += i == 70'000 || i == 90'000 ? "x\n" : "1\n";
  }
  folder.write("r.csv", readings);
  const auto report = applyToReadings(folder.file("r.csv"), folder.file("out.csv"),
                                      angleCorrection(shiftByHalf(), angle::SensorDirection::Increasing), 4);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().where, folder.file("r.csv") + ":70002") << "the first one, whichever thread was quicker";
  EXPECT_EQ(folder.listing(), "r.csv");
}

TEST(ParallelWork, BatchEndsWhereResultsCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string sweep = STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv";
  const std::vector<BatchInput> inputs(50, BatchInput{sweep, "no/such/folder.json"});
  BatchOptions options;
  options.out = folder.path();
  options.jobs = 4;
  const auto outcomes = runBatch(inputs, options, [](std::size_t, std::size_t) {});
  ASSERT_TRUE(outcomes.front().problem);
  EXPECT_EQ(outcomes.front().problem->kind, ErrorKind::Storage);
  EXPECT_FALSE(outcomes.back().problem) << "not begun any more";
}

} // namespace
} // namespace straightedge::cli
