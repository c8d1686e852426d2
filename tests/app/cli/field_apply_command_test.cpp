#include "core/export/field_calibration_json.h"
#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/field/sample_chain.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace straightedge {
namespace {

using testing::runCli;
using testing::TemporaryFolder;

const std::string header = "pt100_ohm,electronics_C,raw_x_T,raw_y_T,raw_z_T";

class FieldApplyCommand : public ::testing::Test {
protected:
  void SetUp() override {
    field::FieldCalibration calibration;
    calibration.created = "2026-07-11T12:00:00Z";
    calibration.software = "straightedge test";
    calibration.chain = testing::sampleChain();
    folder.write("calibration.json", exporting::fieldCalibrationToJson(calibration));
  }
  TemporaryFolder folder;
};

TEST_F(FieldApplyCommand, addsTheFieldToReadingsFromStandardInput) {
  const auto run = runCli({"field", "apply", folder.file("calibration.json"), "-"},
                          header + ",note\n109.25,24.5,1.5,-0.25,0.125,a\n");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, ::testing::StartsWith(header + ",note,x_T,y_T,z_T\n109.25,24.5,1.5,-0.25,0.125,a,"));
  const auto applied = field::AppliedChain::prepare(testing::sampleChain());
  const Eigen::Vector3d field = applied->correct({109.25, 24.5, {1.5, -0.25, 0.125}});
  const std::string cells = run.out.substr(run.out.rfind(",a,") + 3);
  EXPECT_NEAR(std::stod(cells), field.x(), 2e-15);
}

TEST_F(FieldApplyCommand, writesAFileWholeOrNotAtAll) {
  folder.write("r.csv", header + "\n109,24,1,1,1\n109,24,1,1\n");
  const auto run = runCli(
      {"field", "apply", folder.file("calibration.json"), folder.file("r.csv"), "--out", folder.file("out.csv")});
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err, "straightedge-cli: " + folder.file("r.csv") +
                         ":3: the row has 4 columns instead of 5; check the row and the separator\n");
  EXPECT_FALSE(std::filesystem::exists(folder.file("out.csv")));
}

TEST_F(FieldApplyCommand, refusals) {
  EXPECT_EQ(runCli({"field", "apply", "-", "-"}).code, 2);
  EXPECT_EQ(runCli({"field", "apply", folder.file("calibration.json")}).code, 2);
  const auto missing = runCli({"field", "apply", folder.file("none.json"), "-"}, header + "\n109,24,1,1,1\n");
  EXPECT_EQ(missing.code, 3);
  const auto column =
      runCli({"field", "apply", folder.file("calibration.json"), "-"}, "raw_x_T,raw_y_T,raw_z_T\n1,1,1\n");
  EXPECT_EQ(column.code, 3);
  EXPECT_THAT(column.err, ::testing::HasSubstr("pt100_ohm, which the offset over temperature of axis x needs"));
}

} // namespace
} // namespace straightedge
