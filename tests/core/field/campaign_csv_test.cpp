#include "core/base/sha256.h"
#include "core/field/campaign_csv.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/field/example_campaign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace straightedge::field {
namespace {

const std::string header =
    "step,axis,orientation,reference_T,reference_locked,chamber_C,pt100_ohm,electronics_C,raw_x_T,raw_y_T,raw_z_T\n";

Result<Campaign> parse(const std::string& text) { return parseCampaignCsv(text, "c.csv", "c.csv"); }

TEST(CampaignCsv, ReadsTheExample) {
  const Campaign& campaign = exampleCampaign();
  ASSERT_EQ(campaign.rows.size(), 12888U);
  EXPECT_EQ(campaign.name, "campaign.csv");
  EXPECT_EQ(campaign.sha256, "89c78fbad13735311cdaf9052550bba387b5770bdd040b833fc31eb8f3139655");
  const CampaignRow& first = campaign.rows.front();
  EXPECT_EQ(first.step, CampaignStep::Nonlinearity);
  EXPECT_EQ(first.axis, Axis::X);
  EXPECT_EQ(first.referenceT, -1.9999985);
  EXPECT_TRUE(first.locked);
  EXPECT_TRUE(std::isnan(first.chamberC));
  EXPECT_EQ(first.rawT[2], -0.0152684);
  EXPECT_EQ(first.line, 2);
  EXPECT_FALSE(campaign.rows[22].locked);
}

TEST(CampaignCsv, WhatIsWrittenReadsBack) {
  const std::string text = campaignCsv(exampleCampaign());
  const auto read = parse(text);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(campaignCsv(*read), text);
  EXPECT_EQ(text.substr(0, header.size()), header);
}

TEST(CampaignCsv, TimesAreWrittenWhereThereAreAny) {
  Campaign campaign = *parse(header + "offset,,,,,,109.2,,1e-5,0,0\n");
  campaign.rows[0].timeS = 2.5;
  const std::string text = campaignCsv(campaign);
  EXPECT_EQ(text.substr(header.size() - 1), ",time_s\noffset,,,,0,,109.2,,1e-05,0,0,2.5\n");
  EXPECT_EQ(parse(text)->rows[0].timeS, 2.5);
}

TEST(CampaignCsv, OtherPeoplesFiles) {
  const auto read =
      parse("\xEF\xBB\xBF# exported\r\nRAW_X_T;Raw_Y_T;raw_z_t;remark;STEP;Axis;Reference_T;reference_locked\r\n"
            "-1,5;0;0;good;Nonlinearity;X;-1,45;true\r\n"
            "\r\n# pause\r\n0,1;0;0;;nonlinearity;x;;0\r\n");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->rows.size(), 2U);
  EXPECT_EQ(read->rows[0].rawT[0], -1.5);
  EXPECT_EQ(read->rows[0].referenceT, -1.45);
  EXPECT_TRUE(read->rows[0].locked);
  EXPECT_FALSE(read->rows[1].locked);
  EXPECT_EQ(read->rows[1].line, 6);
}

TEST(CampaignCsv, WithoutALockColumnAReferenceCountsAsLocked) {
  const auto read = parse("step,axis,reference_T,raw_x_T,raw_y_T,raw_z_T\nnonlinearity,x,1,1,0,0\n");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(read->rows[0].locked);
}

struct BadFile {
  std::string name, text, message;
};
void PrintTo(const BadFile& bad, std::ostream* out) { *out << bad.name; }

const std::string good = header + "offset,,,,,,109.2,,1e-5,0,0\n";
const std::vector<BadFile> badFiles = {
    {"NoHeader", "1,2,3\n4,5,6\n",
     "c.csv:1: the campaign has no header; name the columns in the first line: step,axis,…"},
    {"NoStep", "axis,raw_x_T,raw_y_T,raw_z_T\nx,1,0,0\n",
     "c.csv: the column \"step\" is missing; add it, or name a campaign file"},
    {"NoRawZ", "step,raw_x_T,raw_y_T\noffset,1,0\n",
     "c.csv: the column \"raw_z_T\" is missing; add it, or name a campaign file"},
    {"TwoColumns", "step,raw_x_T,raw_x_T,raw_y_T,raw_z_T\noffset,1,1,0,0\n",
     "c.csv: there are two columns \"raw_x_T\"; remove one of them"},
    {"Pt100ColumnMissing", "step,raw_x_T,raw_y_T,raw_z_T\noffset,1,0,0\n",
     "c.csv:2: the column \"pt100_ohm\" is missing, which rows of the step offset need; add it, or remove the rows of "
     "that step"},
    {"UnknownStep", good + "rest,,,,,,109.2,,1e-5,0,0\n",
     "c.csv:3: step holds \"rest\"; write one of nonlinearity, probe-temperature, offset, sensitivity, electronics, "
     "electronics-sensitivity, orientation, verification"},
    {"UnknownAxis", good + "nonlinearity,w,,1,1,,109.2,,1e-5,0,0\n", "c.csv:3: axis holds \"w\"; write x, y or z"},
    {"AxisEmpty", good + "nonlinearity,,,1,1,,109.2,,1e-5,0,0\n",
     "c.csv:3: axis is empty, which a row of the step nonlinearity needs; fill it in or remove the row"},
    {"UnknownOrientation", good + "orientation,,up,1,1,,109.2,,1e-5,0,0\n",
     "c.csv:3: orientation holds \"up\"; write +x, -x, +y, -y, +z or -z"},
    {"LockedWithoutReference", good + "nonlinearity,x,,,1,,109.2,,1e-5,0,0\n",
     "c.csv:3: reference_T is empty, which a row of the step nonlinearity needs; fill it in or remove the row"},
    {"LockWord", good + "nonlinearity,x,,1,maybe,,109.2,,1e-5,0,0\n",
     "c.csv:3: reference_locked holds \"maybe\"; write 1 for a locked reference and 0 for one that is not"},
    {"NaN", good + "offset,,,,,,109.2,,nan,0,0\n",
     "c.csv:3: raw_x_T holds \"nan\"; write a finite number, or remove the row"},
    {"Infinite", good + "offset,,,,,,inf,,0,0,0\n",
     "c.csv:3: pt100_ohm holds \"inf\"; write a finite number, or remove the row"},
    {"Text", good + "offset,,,,,,109.2,,0,0,high\n",
     "c.csv:3: raw_z_T holds \"high\"; write a finite number, or remove the row"},
    {"RawEmpty", good + "offset,,,,,,109.2,,0,,0\n",
     "c.csv:3: raw_y_T is empty, which a row of the step offset needs; fill it in or remove the row"},
    {"ChamberEmpty", good + "probe-temperature,,,,,,109.2,,0,0,0\n",
     "c.csv:3: chamber_C is empty, which a row of the step probe-temperature needs; fill it in or remove the row"},
    {"MilliTesla", good + "nonlinearity,x,,1500,1,,109.2,,1.5,0,0\n",
     "c.csv:3: reference_T is 1500 T; give fields in tesla"},
    {"NegativeResistance", good + "offset,,,,,,-5,,0,0,0\n",
     "c.csv:3: pt100_ohm holds \"-5\"; give the resistance in ohms, or leave the cell empty"},
    {"Short", good + "offset,,,\n", "c.csv:3: the row has 4 columns instead of 11; check the row and the separator"},
};

/// Rows that fill several of the blocks that a file is read by.
std::string manyRows(const std::string& first, const std::string& row, int count) {
  std::string text = first;
  for (int i = 0; i < count; ++i) {
    text += row;
  }
  return text;
}

/// The campaign in `text`, read from a file and from memory alike.
Result<Campaign> readBoth(const std::string& text) {
  const testing::TemporaryFolder folder;
  auto fromFile = readCampaignCsv(folder.write("c.csv", text));
  const auto fromMemory = parse(text);
  EXPECT_EQ(fromFile.has_value(), fromMemory.has_value());
  if (fromFile && fromMemory) {
    EXPECT_EQ(fromFile->name, "c.csv");
    EXPECT_EQ(fromFile->sha256, fromMemory->sha256);
    EXPECT_TRUE(campaignCsv(*fromFile) == campaignCsv(*fromMemory)); // megabytes: not shown
  } else if (!fromFile && !fromMemory) {
    EXPECT_EQ(fromFile.error().message(), folder.path() + "/" + fromMemory.error().message());
  }
  return fromMemory;
}

TEST(CampaignCsv, ALongFileIsReadToItsEnd) {
  // Comments, blank lines and a row without its newline among 40,000 numbered rows of two megabytes.
  std::string text = "\xEF\xBB\xBF" + header;
  for (int i = 0; i < 40'000; ++i) {
    text += i % 1000 == 0 ? "# " + std::to_string(i) + "\r\n\r\n" : "";
    text += "offset,,,,,,109.2345,,0.0001234,-0.00567,0." + std::to_string(100'000 + i) + "\r\n";
  }
  text.resize(text.size() - 2);
  const auto read = readBoth(text);
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->rows.size(), 40'000U);
  EXPECT_EQ(read->sha256, sha256Hex(text));
  for (int i = 0; i < 40'000; ++i) {
    const CampaignRow& row = read->rows[static_cast<std::size_t>(i)];
    ASSERT_DOUBLE_EQ(row.rawT[2], 0.1 + 1e-6 * i);
    ASSERT_EQ(row.line, 2 + i + 2 * (i / 1000 + 1));
  }
}

TEST(CampaignCsv, DecimalCommasMayComeLate) {
  const std::string first = "step;pt100_ohm;raw_x_T;raw_y_T;raw_z_T\n";
  const auto read = readBoth(manyRows(first, "offset;109;0;0;0\n", 20'000) + "offset;109,5;0;0;0\n");
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->rows.size(), 20'001U);
  EXPECT_EQ(read->rows.back().pt100Ohm, 109.5);
}

TEST(CampaignCsv, ALongFileMayEndItsLinesWithReturns) {
  std::string text = manyRows(header, "offset,,,,,,109.2345,,0.0001234,-0.00567,0.1\n", 40'000);
  std::ranges::replace(text, '\n', '\r');
  const auto read = readBoth(text);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->rows.size(), 40'000U);
}

TEST(CampaignCsv, AHeaderMayComeAfterALongStory) {
  const auto read = readBoth(manyRows("", "# told at length; and again, and again\n", 20'000) + header +
                             "offset,,,,,,109.2,,1e-5,0,0\n");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->rows.back().line, 20'002);
}

TEST(CampaignCsv, ALongFilesFaultsAreToldByRankAndLine) {
  const std::string row = "offset,,,,,,109.2345,,0.0001234,-0.00567,0.1\n";
  const std::string badCell = "offset,,,,,,high,,0,0,0\n";
  std::string text = manyRows(header, row, 9001) + badCell + row;
  EXPECT_EQ(readBoth(text).error().message(),
            "c.csv:9003: pt100_ohm holds \"high\"; write a finite number, or remove the row");
  text = manyRows(text, row, 9000) + "offset,,,\n";
  EXPECT_EQ(readBoth(text).error().message(),
            "c.csv:18005: the row has 4 columns instead of 11; check the row and the separator");
  text = manyRows(text, row, 9000) + std::string("\0\n", 2);
  EXPECT_EQ(readBoth(text).error().message(),
            "c.csv:27006: the file is not text: it holds the byte 0x00; name a CSV file");
}

class CampaignCsvRefuses : public ::testing::TestWithParam<BadFile> {};

TEST_P(CampaignCsvRefuses, WithTheLineAndARemedy) {
  ASSERT_TRUE(parse(good));
  const auto read = parse(GetParam().text);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::Input);
  EXPECT_EQ(read.error().message(), GetParam().message);
}
INSTANTIATE_TEST_SUITE_P(Bad, CampaignCsvRefuses, ::testing::ValuesIn(badFiles),
                         [](const auto& bad) { return bad.param.name; });

} // namespace
} // namespace straightedge::field
