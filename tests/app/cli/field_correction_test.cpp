// `field apply` without its command line: the stream, its columns and its refusals.
#include "app/cli/apply_stream.h"
#include "app/cli/field_correction.h"
#include "core/base/number_text.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/field/sample_chain.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace straightedge::cli {
namespace {

using testing::sampleChain;
using testing::TemporaryFolder;

const std::string header = "pt100_ohm,electronics_C,raw_x_T,raw_y_T,raw_z_T";

class FieldCorrectionStream : public ::testing::Test {
protected:
  Result<ApplyReport> run(const std::string& readings, const field::CorrectionChain& chain = sampleChain()) {
    const auto applied = field::AppliedChain::prepare(chain);
    return applyToReadings(folder.write("r.csv", readings), folder.file("out.csv"), fieldCorrection(chain, *applied),
                           2);
  }
  std::string corrected(const std::string& readings, const field::CorrectionChain& chain = sampleChain()) {
    const auto report = run(readings, chain);
    EXPECT_TRUE(report) << report.error().message();
    return folder.read("out.csv");
  }
  std::string refused(const std::string& readings, const field::CorrectionChain& chain = sampleChain()) {
    std::filesystem::remove(folder.file("out.csv"));
    const auto report = run(readings, chain);
    EXPECT_FALSE(report);
    EXPECT_EQ(folder.listing(), "r.csv") << "nothing half-written";
    std::string message = report ? "" : report.error().message();
    const std::string path = folder.path() + "/";
    if (const auto at = message.find(path); at != std::string::npos) {
      message.erase(at, path.size());
    }
    return message;
  }
  /// ",x,y,z" as the stream writes it.
  static std::string cells(const field::Reading& reading, const field::CorrectionChain& chain = sampleChain()) {
    const auto applied = field::AppliedChain::prepare(chain);
    std::array<double, 5> r = {reading.pt100Ohm, reading.electronicsC, reading.rawT[0], reading.rawT[1],
                               reading.rawT[2]};
    const auto one = [&r](std::size_t k) { return std::span<double>(r).subspan(k, 1); };
    applied->correct({one(0), one(1), {one(2), one(3), one(4)}}, {{one(2), one(3), one(4)}});
    return "," + formatDouble(r[2]) + "," + formatDouble(r[3]) + "," + formatDouble(r[4]);
  }
  TemporaryFolder folder;
};

TEST_F(FieldCorrectionStream, addsThreeColumnsAndPassesTheRestThrough) {
  const std::string first = cells({109.25, 24.5, {1.5, -0.25, 0.125}});
  EXPECT_EQ(corrected("# kept\r\nid," + header +
                      ",note\r\n7,109.25,24.5,1.5,-0.25,0.125,\"a, b\"\r\n\r\n,,,,,,\r\n"
                      "8, 109.25 ,24.5,1.5,-0.25,0.125,"),
            "# kept\r\nid," + header + ",note,x_T,y_T,z_T\r\n7,109.25,24.5,1.5,-0.25,0.125,\"a, b\"" + first +
                "\r\n\r\n,,,,,,,,,\r\n8, 109.25 ,24.5,1.5,-0.25,0.125," + first);
}

TEST_F(FieldCorrectionStream, columnsInAnyOrderAndCaseWithDecimalComma) {
  std::string expected = cells({109.25, 24.5, {1.5, -0.25, 0.125}});
  for (char& c : expected) {
    c = c == ',' ? ';' : c == '.' ? ',' : c;
  }
  EXPECT_EQ(corrected("raw_Z_t;raw_x_T;Electronics_C;raw_y_T;pt100_ohm\n0,125;1,5;24,5;-0,25;109,25\n"),
            "raw_Z_t;raw_x_T;Electronics_C;raw_y_T;pt100_ohm;x_T;y_T;z_T\n0,125;1,5;24,5;-0,25;109,25" + expected +
                "\n");
}

TEST_F(FieldCorrectionStream, withoutAHeaderTheFiveColumnsOfAReading) {
  const std::string row = "109.25,24.5,1.5,-0.25,0.125";
  EXPECT_EQ(corrected(row + "\n" + row + "\n"), row + cells({109.25, 24.5, {1.5, -0.25, 0.125}}) + "\n" + row +
                                                    cells({109.25, 24.5, {1.5, -0.25, 0.125}}) + "\n");
  EXPECT_EQ(refused("24.5,1.5,-0.25,0.125\n"),
            "r.csv: there is no header, and 4 columns instead of 5; name the columns: "
            "pt100_ohm,electronics_C,raw_x_T,raw_y_T,raw_z_T");
}

TEST_F(FieldCorrectionStream, aMissingColumnIsToldWithTheBlockThatNeedsIt) {
  field::CorrectionChain chain = sampleChain();
  chain.axes[0].offsetT.reset();
  chain.axes[0].sensitivitySlope.reset();
  EXPECT_EQ(refused("electronics_C,raw_x_T,raw_y_T,raw_z_T\n24,1,1,1\n", chain),
            "r.csv: there is no column pt100_ohm, which the offset over temperature of axis y needs; add it, or apply "
            "a calibration fitted without that step");
  chain.axes[1].offsetT.reset();
  EXPECT_THAT(refused("electronics_C,raw_x_T,raw_y_T,raw_z_T\n24,1,1,1\n", chain),
              ::testing::HasSubstr("which the sensitivity over temperature of axis y needs"));
  EXPECT_THAT(refused("pt100_ohm,raw_x_T,raw_y_T,raw_z_T\n109,1,1,1\n"),
              ::testing::HasSubstr("electronics_C, which the offset over electronics temperature of axis x needs"));
  EXPECT_EQ(refused("pt100_ohm,electronics_C,raw_x_T,raw_y_T,z\n109,24,1,1,1\n"),
            "r.csv: there is no column raw_z_T, which every correction needs; name the columns of the raw readings "
            "raw_x_T, raw_y_T and raw_z_T");
}

TEST_F(FieldCorrectionStream, aTemperatureThatNoBlockNeedsMayBeMissing) {
  field::CorrectionChain chain;
  EXPECT_EQ(corrected("raw_x_T,raw_y_T,raw_z_T\n1.5,-0.25,0.125\n", chain),
            "raw_x_T,raw_y_T,raw_z_T,x_T,y_T,z_T\n1.5,-0.25,0.125,1.5,-0.25,0.125\n");
}

TEST_F(FieldCorrectionStream, rowsThatCannotBeCorrected) {
  EXPECT_EQ(refused(header + "\n109,24,1,1,1\n109,,1,1,1\n"),
            "r.csv:3: the electronics_C is \"\", which is no number; correct it or remove the row");
  EXPECT_EQ(refused(header + "\n109,24,1,nan,1\n"), "r.csv:2: the raw_y_T is nan; correct it or remove the row");
  EXPECT_EQ(refused(header + ",x_T\n109,24,1,1,1,1\n"),
            "r.csv: there is a column x_T already; rename it or apply to the raw readings");
  std::string readings = header + "\n";
  for (int i = 0; i < 300; ++i) { // beyond the rows that the layout is found in
    readings += "109,24,1,1,1\n";
  }
  EXPECT_EQ(refused(readings + "109,24,1,1\n"),
            "r.csv:302: the row has 4 columns instead of 5; check the row and the separator");
}

/// Most numbers are plain digits and are read by a shorter way; the others come to the same.
TEST_F(FieldCorrectionStream, aNumberIsTheSameHoweverItIsWritten) {
  const std::string added = cells({109.25, 24.5, {1.5, -0.25, 0.125}});
  std::string readings = "note," + header + ",id\n";
  std::string expected = "note," + header + ",id,x_T,y_T,z_T\n";
  for (const std::string row : {
           "a,109.25,24.5,1.5,-0.25,0.125,7",
           "a,+109.25, 24.5,1.5\t,-25e-2,12.5e-2,7",
           "a,\"109.25\",24.5,\" 1.5\",-0.25,.125,7",
           "\"a, b\",109.25,24.5,1.5,-0.25,0.125,7",
           "a,109.25,24.5,1.5,-0.25,0.125,\"7, 8\"",
           "a,109.2500000000000000000000,00024.5,1.50,-0.2500000000000000000,0.125,7",
           "a,109.25,24.5,1.5,-0.25,0.125000000000000000001,7",
           "a,109.25,24.5,1.5,-0.25,0.125,",
           ",109.25,24.5,1.5,-0.25,0.125,7",
       }) {
    readings += row + "\n";
    expected += row + added + "\n";
  }
  EXPECT_EQ(corrected(readings), expected);
  readings = header + "\n";
  for (int i = 0; i < 300; ++i) { // beyond the rows that the layout is found in
    readings += "109.25,24.5,1.5,-0.25,0.125\n";
  }
  EXPECT_EQ(refused(readings + "109.25,24.5,1.5,-0.25,0.125,7\n"),
            "r.csv:302: the row has 6 columns instead of 5; check the row and the separator");
  EXPECT_EQ(refused(readings + "109.25,24.5,1.5,-0.25,0.1.25\n"),
            "r.csv:302: the raw_z_T is \"0.1.25\", which is no number; correct it or remove the row");
}

/// Lines are worked on some hundreds at a time: what stands between the rows changes nothing.
TEST_F(FieldCorrectionStream, rowsAmongOtherLinesKeepTheirCells) {
  std::string readings = header + "\n";
  std::string expected = header + ",x_T,y_T,z_T\n";
  constexpr int rows = 1700;
  for (int i = 0; i < rows; ++i) {
    const double x = 0.001 * i;
    const std::string row = "109.25,24.5," + formatDouble(x) + ",-0.25,0.125";
    const std::string between = i % 7 == 0 ? "# pause\n" : i % 11 == 0 ? "\n" : "";
    readings += between + row + "\n" + (i % 13 == 0 ? ",,,,\n" : "");
    expected += between + row + cells({109.25, 24.5, {x, -0.25, 0.125}}) + "\n" + (i % 13 == 0 ? ",,,,,,,\n" : "");
  }
  EXPECT_TRUE(corrected(readings) == expected);
  const auto lines = std::ranges::count(readings, '\n');
  EXPECT_EQ(refused(readings + "109.25,24.5,inf,0,0\n"),
            "r.csv:" + std::to_string(lines + 1) + ": the raw_x_T is inf; correct it or remove the row");
}

/// More than one block of 256 KiB: every row once, in order.
TEST_F(FieldCorrectionStream, aLongTableKeepsItsOrder) {
  const testing::SampleReadings r = testing::sampleReadings(20'000);
  std::string readings = header + "\n";
  std::string expected = header + ",x_T,y_T,z_T\n";
  for (std::size_t i = 0; i < r.x.size(); ++i) {
    const std::string row = formatDouble(r.pt100Ohm[i]) + "," + formatDouble(r.electronicsC[i]) + "," +
                            formatDouble(r.x[i]) + "," + formatDouble(r.y[i]) + "," + formatDouble(r.z[i]);
    readings += row + "\n";
    expected += row + cells({r.pt100Ohm[i], r.electronicsC[i], {r.x[i], r.y[i], r.z[i]}}) + "\n";
  }
  const auto report = run(readings);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rows, r.x.size());
  EXPECT_EQ(report->bytesRead, readings.size());
  EXPECT_TRUE(folder.read("out.csv") == expected);
}

} // namespace
} // namespace straightedge::cli
