// `field apply` without its command line: the stream, its columns and its refusals.
#include "app/cli/apply_stream.h"
#include "app/cli/field_correction.h"
#include "core/base/number_text.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/field/sample_chain.h"

#include <gmock/gmock.h>

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
