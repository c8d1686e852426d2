#include "devices/instruments/line_parser.h"
#include "devices/instruments/line_reader.h"

#include <gtest/gtest.h>

#include <numbers>

namespace straightedge::devices {
namespace {

using Values = std::vector<double>;

LineFormat columns(std::vector<LineColumn> list, std::string separators = ",;\t") {
  LineFormat format;
  format.separators = std::move(separators);
  format.columns = std::move(list);
  return format;
}

LineColumn column(int index) { return {.quantity = "angle", .index = index, .label = {}, .unit = {}}; }

LineColumn labelled(const char* label) { return {.quantity = "angle", .label = label, .unit = {}}; }

TEST(LineParser, LinesThatBoardsPrint) {
  struct Case {
    LineFormat format;
    const char* line;
    Values values;
  };
  LineColumn degrees = column(1);
  degrees.unit = "deg";
  LineColumn counts = column(1);
  counts.scale = 360.0 / 4096;
  LineColumn radians = labelled("angle (rad)");
  radians.scale = 180.0 / std::numbers::pi;
  LineColumn labelledDegrees = labelled("angle");
  labelledDegrees.unit = "deg";
  LineFormat comma = columns({column(1)}, ";");
  comma.decimalPoint = ',';
  LineFormat nmea = columns({column(1), column(2)}, ",");
  nmea.prefix = "$ANG,";
  for (const Case& good : {
           Case{columns({column(1)}), "123.45", {123.45}},
           Case{columns({column(1)}), "  +123.45 \r", {123.45}},
           Case{columns({column(2)}), "0.52\t187.25\t3", {187.25}}, // Techfest19 MagSensorBoard: speed, angle, turns
           Case{columns({column(2), column(1)}), "1.5 , -2e-3", {-0.002, 1.5}},
           Case{columns({column(3)}, ","), "1,,3", {3.0}},
           Case{columns({column(2)}, " "), "  7    8.5 9", {8.5}},
           Case{columns({column(2)}, " ,"), "7 , 8.5", {8.5}},
           Case{columns({column(3)}, " ,"), "7 ,, 8.5 ", {8.5}},
           Case{columns({column(3)}, " ,"), " ,7,8.5", {8.5}},
           Case{columns({degrees}), "12.5deg", {12.5}},
           Case{columns({degrees}), "12.5 deg", {12.5}},
           Case{columns({degrees}), "12.5", {12.5}},
           Case{columns({counts}), "1024", {90.0}},
           // uncertainty-cc Arduino-Rath-AS5600
           Case{columns({radians}), "angle (normalized): 0.25\tangle (rad): 1.5707963267948966", {90.0}},
           Case{columns({labelled("angle")}, " "), "t=5 angle=90.5 deg=1", {90.5}},
           Case{columns({labelledDegrees}, " "), "t=5 angle= 90.5 deg n=1", {90.5}},
           Case{columns({labelled("A:")}), "A:5.25", {5.25}},
           Case{comma, "12,5;3", {12.5}},
           Case{nmea, "$ANG,1.5,2.5", {1.5, 2.5}},
       }) {
    const auto values = parseLine(good.format, good.line);
    ASSERT_TRUE(values) << good.line << ": " << describe(values.error(), good.format);
    ASSERT_EQ(values->size(), good.values.size()) << good.line;
    for (std::size_t i = 0; i < good.values.size(); ++i) {
      EXPECT_DOUBLE_EQ((*values)[i], good.values[i]) << good.line;
    }
  }
}

TEST(LineParser, WhatIsNoReadingIsNone) {
  LineColumn limited = column(1);
  limited.least = 0.0;
  limited.most = 360.0;
  LineColumn tesla = column(1);
  tesla.unit = "T";
  tesla.unitNeeded = true;
  LineFormat three = columns({column(1)});
  three.fieldCount = 3;
  LineFormat prefixed = columns({column(1)});
  prefixed.prefix = "$ANG,";
  LineColumn huge = column(1);
  huge.scale = 1e300;
  struct Case {
    LineFormat format;
    std::string line;
    LineProblem problem;
  };
  for (const Case& bad : {
           Case{columns({column(1)}), "", LineProblem::Empty},
           Case{columns({column(1)}), " \r", LineProblem::Empty},
           Case{columns({column(1)}), "nan", LineProblem::NotFinite},
           Case{columns({column(1)}), "-inf", LineProblem::NotFinite},
           Case{columns({huge}), "1e300", LineProblem::NotFinite},
           Case{columns({column(1)}), "ovf", LineProblem::NotANumber},
           Case{columns({column(1)}), "12.5 13", LineProblem::NotANumber},
           Case{columns({column(1)}), "12.5deg", LineProblem::NotANumber},
           Case{columns({column(1)}), "0x10", LineProblem::NotANumber},
           Case{columns({column(1)}), "--5", LineProblem::NotANumber},
           Case{columns({column(2)}), "5", LineProblem::WrongFields},
           Case{columns({column(2)}), "5,", LineProblem::NotANumber},
           Case{three, "1,2", LineProblem::WrongFields},
           Case{columns({labelled("angle")}), "angel: 5", LineProblem::LabelMissing},
           Case{columns({labelled("angle")}), "angle2: 5", LineProblem::LabelMissing},
           Case{columns({labelled("angle")}), "rectangle: 5", LineProblem::LabelMissing},
           Case{columns({labelled("angle")}), "angle:", LineProblem::LabelMissing},
           Case{columns({limited}), "360.1", LineProblem::OutOfLimits},
           Case{columns({tesla}), "1.5", LineProblem::WrongUnit},
           Case{columns({tesla}), "1.5G", LineProblem::WrongUnit},
           Case{prefixed, "$TMP,23", LineProblem::WrongPrefix},
           Case{columns({column(1)}), std::string("12\0.5", 5), LineProblem::NotText},
           Case{columns({column(1)}), std::string(2000, '1'), LineProblem::TooLong},
       }) {
    const auto values = parseLine(bad.format, bad.line);
    ASSERT_FALSE(values) << bad.line << " read as " << values->front();
    EXPECT_EQ(values.error().problem, bad.problem) << bad.line << ": " << describe(values.error(), bad.format);
    EXPECT_FALSE(describe(values.error(), bad.format).empty());
  }
}

TEST(LineParser, FormatsThatMakeNoSenseAreNamed) {
  EXPECT_EQ(problemOf(columns({column(1)})), "");
  EXPECT_NE(problemOf(columns({})), "");
  EXPECT_NE(problemOf(columns({column(0)})), "");
  LineFormat ambiguous = columns({column(1)}, ",");
  ambiguous.decimalPoint = ',';
  EXPECT_NE(problemOf(ambiguous), "");
  LineColumn flat = column(1);
  flat.scale = 0.0;
  EXPECT_NE(problemOf(columns({flat})), "");
  LineColumn reversed = column(1);
  reversed.least = 360.0;
  reversed.most = 0.0;
  EXPECT_NE(problemOf(columns({reversed})), "");
}

TEST(LineReader, BannerAndPartialFirstLineAreNoReadings) {
  LineReader reader(columns({column(1)}));
  // The first line is what is left of "123.5": a number, and wrong.
  EXPECT_TRUE(reader.take("23.5\r\n").empty());
  EXPECT_TRUE(reader.take("AS5600 ready\r\nfirmware 1.2\r\n").empty());
  const auto readings = reader.take("124.5\r\nnan\r\n12");
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_EQ(readings[0], Values{124.5});
  EXPECT_EQ(reader.take("5.25\n\n garbage \n126.5\n").size(), 2U);
  EXPECT_EQ(reader.counts().readings, 3);
  EXPECT_EQ(reader.counts().banner, 3);
  EXPECT_EQ(reader.counts().rejected, 2);
  EXPECT_EQ(reader.counts().notFinite, 1);
  ASSERT_TRUE(reader.lastFault());
  EXPECT_EQ(reader.lastFault()->text, "garbage");
}

TEST(LineReader, EveryWayOfCuttingGivesTheSameReadings) {
  const std::string bytes = "x\n1.5\n2.5\r\n" + std::string(3000, '7') + "\n3.5\nnan\n4.5\n5";
  for (std::size_t size = 1; size < 40; ++size) {
    LineReader reader(columns({column(1)}));
    Values got;
    for (std::size_t at = 0; at < bytes.size(); at += size) {
      for (const Values& values : reader.take(std::string_view(bytes).substr(at, size))) {
        got.push_back(values.front());
      }
    }
    EXPECT_EQ(got, (Values{1.5, 2.5, 3.5, 4.5})) << "cut every " << size << " bytes";
    EXPECT_EQ(reader.counts().rejected, 2);
  }
}

TEST(LineReader, StartInsideLineDropsTheNextLine) {
  LineReader reader(columns({column(1)}));
  EXPECT_EQ(reader.take("\n1.5\n12").size(), 1U);
  reader.startInsideLine();
  const auto readings = reader.take("3.5\n4.5\n");
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_EQ(readings[0], Values{4.5});
}

} // namespace
} // namespace straightedge::devices
