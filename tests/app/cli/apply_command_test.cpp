#include "core/angle/model.h"
#include "core/base/number_text.h"
#include "core/export/calibration_json.h"
#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace straightedge {
namespace {

using testing::runCli;
using testing::TemporaryFolder;

const std::string sideShaft = STRAIGHTEDGE_TEST_DATA "/angle/side_shaft_32.csv";

class ApplyCommand : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_EQ(runCli({"angle", "fit", sideShaft, "--out", folder.path()}).code, 0);
    calibration = folder.file("calibration.json");
    read = exporting::readCalibration(calibration);
    ASSERT_TRUE(read);
  }
  std::string corrected(double sensorDeg, std::size_t model = 0) const {
    return formatDouble(angle::correctedDeg(read->models[model], read->direction, sensorDeg));
  }
  std::string withComma(std::string text) const {
    text.replace(text.find('.'), 1, ",");
    return text;
  }
  std::string apply(const std::string& readings) const {
    const auto run = runCli({"angle", "apply", calibration, "-"}, readings);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  }
  void expectRefused(const std::string& readings, const std::string& line) const {
    folder.write("r.csv", readings);
    const auto run = runCli({"angle", "apply", calibration, folder.file("r.csv"), "--out", folder.file("out.csv")});
    EXPECT_EQ(run.code, 3);
    EXPECT_EQ(run.err, "straightedge-cli: " + folder.file("r.csv") + line + "\n");
    EXPECT_FALSE(std::filesystem::exists(folder.file("out.csv")));
  }
  TemporaryFolder folder;
  std::string calibration;
  Result<angle::AngleCalibration> read;
};

TEST_F(ApplyCommand, AddsAColumnAndPassesTheRestThrough) {
  EXPECT_EQ(apply("# kept\r\n\r\nid , sensor_deg,\"note, long\"\r\n 1,10.50,\"a,\"\"b\"\"\"\r\n2, 360 ,\r\n"),
            "# kept\r\n\r\nid , sensor_deg,\"note, long\",corrected_deg\r\n 1,10.50,\"a,\"\"b\"\"\"," +
                corrected(10.5) + "\r\n2, 360 ,," + corrected(0.0) + "\r\n");
}

TEST_F(ApplyCommand, RespectsSeparatorDecimalMarkAndByteOrderMark) {
  EXPECT_EQ(apply("\xEF\xBB\xBF"
                  "t;Measured Angle [degree]\n1;10,5\n2;20,25"),
            "\xEF\xBB\xBF"
            "t;Measured Angle [degree];corrected_deg\n1;10,5;" +
                withComma(corrected(10.5)) + "\n2;20,25;" + withComma(corrected(20.25)));
  EXPECT_EQ(apply("10.5\n20.25\n"), "10.5," + corrected(10.5) + "\n20.25," + corrected(20.25) + "\n");
  EXPECT_EQ(apply("name\tvalue\na\t10.5\n"), "name\tvalue\tcorrected_deg\na\t10.5\t" + corrected(10.5) + "\n");
}

TEST_F(ApplyCommand, TheModelMayBeChosen) {
  const auto run = runCli({"angle", "apply", calibration, "-", "--model", "lut:64", "--out", "-"}, "sensor_deg\n45\n");
  EXPECT_EQ(run.out, "sensor_deg,corrected_deg\n45," + corrected(45.0, 2) + "\n");
}

/// Many blocks of 256 KiB: every row once, in order, whatever thread it went through.
TEST_F(ApplyCommand, ALongTableKeepsItsOrder) {
  std::string readings = "row,sensor_deg\n";
  constexpr int rows = 200'000;
  for (int i = 0; i < rows; ++i) {
    readings += std::to_string(i) + "," + formatDouble(0.0018 * i) + "\n";
  }
  folder.write("long.csv", readings);
  ASSERT_EQ(runCli({"angle", "apply", calibration, folder.file("long.csv"), "--out", folder.file("out.csv")}).code, 0);
  std::istringstream out(folder.read("out.csv"));
  std::string line;
  std::getline(out, line);
  EXPECT_EQ(line, "row,sensor_deg,corrected_deg");
  int row = 0;
  for (; std::getline(out, line); ++row) {
    const double sensor = 0.0018 * row;
    ASSERT_EQ(line, std::to_string(row) + "," + formatDouble(sensor) + "," + corrected(sensor));
  }
  EXPECT_EQ(row, rows);
}

TEST_F(ApplyCommand, RefusesBadRowsWithTheirLine) {
  expectRefused("sensor_deg\n10\nabc\n",
                ":3: the sensor angle is \"abc\", which is no number; correct it or remove the row");
  expectRefused("sensor_deg\n10\n\n# x\n361\n",
                ":5: the sensor angle 361 lies outside 0 to 360°; correct it or remove the row");
  expectRefused("sensor_deg\nnan\n", ":2: the sensor angle nan lies outside 0 to 360°; correct it or remove the row");
  expectRefused("a,sensor_deg\n1,10\n1\n", ":3: the row has 1 column instead of 2; check the row and the separator");
  std::string late = "a,sensor_deg\n";
  constexpr int goodRows = 100'000;
  for (int i = 0; i < goodRows; ++i) {
    late += "1,10.5\n";
  }
  expectRefused(late + "1,10.5,3\n1,x\n", ":" + std::to_string(goodRows + 2) +
                                              ": the row has 3 columns instead of 2; check the row and the separator");
}

TEST_F(ApplyCommand, RefusesTablesWithoutReadings) {
  expectRefused("", ": the file is empty; record or export the data again");
  expectRefused("sensor_deg\n", ": the file holds a header but no data; record or export the data again");
  expectRefused("a,b\n1,2\n",
                ": there is no column sensor_deg and 2 columns of numbers; name the column of readings sensor_deg");
  expectRefused("sensor_deg,corrected_deg\n1,2\n",
                ": there is a column corrected_deg already; rename it or apply to the raw readings");
  expectRefused("sensor_deg\r1\r2\r", ": the lines end with CR alone; save the file with LF or CRLF");
}

} // namespace
} // namespace straightedge
