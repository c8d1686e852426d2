#include "core/base/csv_table.h"
#include "core/base/csv_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

namespace straightedge {
namespace {

Result<CsvTable> parse(std::string text) { return CsvTable::parse(std::move(text), "t.csv"); }

TEST(CsvTable, ReadsEveryPublishedLayoutAlike) {
  for (const std::string text : {
           "encoder_deg,sensor_deg\n0.5,266.25\n11.25,278.5\n",
           "encoder_deg;sensor_deg\r\n0,5;266,25\r\n11,25;278,5\r\n",
           "encoder_deg\tsensor_deg\n0,5\t266,25\n11,25\t278,5",
           "encoder_deg;sensor_deg\n0.5;266.25\n11.25;278.5",
           "\xEF\xBB\xBF# made by hand\n\n  # again\nencoder_deg , sensor_deg\n 0.5 , 266.25 \n\n11.25,278.5\n",
           "\"encoder_deg\",\"sensor_deg\"\n\"0.5\",266.25\n11.25,\"278.5\"\n",
           "\"encoder_deg\";\"sensor_deg\"\n\"0,5\";\"266,25\"\n\"11,25\";\"278,5\"\n",
           "sep=;\r\nencoder_deg;sensor_deg\r\n0,5;266,25\r\n11,25;278,5\r\n",
           "encoder_deg,sensor_deg\r0.5,266.25\r11.25,278.5\r",
           "encoder_deg,sensor_deg,\n0.5,266.25,\n11.25,278.5,\n,,\n",
           "encoder_deg,sensor_deg\n0.5,266.25,,\n11.25,278.5\n",
       }) {
    const auto table = parse(text);
    ASSERT_TRUE(table) << text << table.error().message();
    EXPECT_TRUE(table->layout().hasHeader);
    EXPECT_EQ(table->title(0), "encoder_deg") << text;
    EXPECT_EQ(table->title(1), "sensor_deg") << text;
    ASSERT_EQ(table->rows(), 2U) << text;
    EXPECT_EQ(table->number(0, 0), 0.5) << text;
    EXPECT_EQ(table->number(0, 1), 266.25) << text;
    EXPECT_EQ(table->number(1, 0), 11.25) << text;
    EXPECT_EQ(table->number(1, 1), 278.5) << text;
  }
}

TEST(CsvTable, WithoutHeaderTheFirstRowIsData) {
  const auto table = parse("0,266.31\n11.25,278.61\n");
  ASSERT_TRUE(table);
  EXPECT_FALSE(table->layout().hasHeader);
  EXPECT_EQ(table->rows(), 2U);
  EXPECT_EQ(table->columnName(1), "column 2");
}

TEST(CsvTable, LinesCountCommentsAndBlankLines) {
  const auto table = parse("# one\r\n\r\na,b\r\n1,2\r\n# five\r\n3,4\r\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->where(0), "t.csv:4");
  EXPECT_EQ(table->where(1), "t.csv:6");
}

TEST(CsvTable, QuotesMayHoldSeparatorsAndQuotes) {
  const auto table = parse("\"a, \"\"b\"\"\",c\n1,\"x,y\"\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->title(0), "a, \"b\"");
  EXPECT_EQ(table->cell(0, 1), "x,y");
  EXPECT_EQ(csvCell("a, \"b\""), "\"a, \"\"b\"\"\"");
  EXPECT_EQ(csvCell("a,b", ';'), "a,b");
}

TEST(CsvTable, IntegersThenDecimalCommas) {
  const auto table = parse("a;b\n0;1\n1;2,5\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->layout().decimalPoint, ',');
  EXPECT_EQ(table->number(1, 1), 2.5);
}

TEST(CsvTable, ReadsOnWithTheSameColumnsAndLineNumbers) {
  auto table = parse("\xEF\xBB\xBF# made by hand\na;\"b \"\"c\"\"\"\n0;1\n");
  ASSERT_TRUE(table) << table.error().message();
  std::string next = "2;3\r\n\n# pause\n\"4\";5;\n";
  ASSERT_TRUE(table->readOn(next));
  EXPECT_EQ(table->title(1), "b \"c\"");
  ASSERT_EQ(table->rows(), 2U);
  EXPECT_EQ(table->number(0, 1), 3.0);
  EXPECT_EQ(table->where(0), "t.csv:4");
  EXPECT_EQ(table->cell(1, 0), "4");
  EXPECT_EQ(table->where(1), "t.csv:7");
  next = "# nothing else\n";
  ASSERT_TRUE(table->readOn(next));
  EXPECT_EQ(table->rows(), 0U);
  next = "6;7.5\n";
  ASSERT_TRUE(table->readOn(next));
  EXPECT_EQ(table->number(0, 1), 7.5);
  EXPECT_EQ(table->where(0), "t.csv:9");
}

TEST(CsvTable, DoesNotReadOnWhereTheTextIsNotWhatItSeemed) {
  for (std::string next : {"1\n", "1;2;3\n", "1;\"2\n", "1;2,5\n"}) {
    auto table = parse("a;b\n0;1\n");
    ASSERT_TRUE(table);
    EXPECT_FALSE(table->readOn(next)) << table->cell(0, 0);
  }
  auto table = parse("a;b\n0;1\n");
  std::string control("1;2\0\n", 5);
  EXPECT_FALSE(table->readOn(control));
}

struct OddFile {
  std::string name;
  std::string text;
  std::string message;
};
void PrintTo(const OddFile& file, std::ostream* out) { *out << file.name; }

class CsvTableRefuses : public testing::TestWithParam<OddFile> {};

TEST_P(CsvTableRefuses, WithOneClearMessage) {
  const auto table = parse(GetParam().text);
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().kind, ErrorKind::Input);
  EXPECT_EQ(table.error().message(), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    OddFiles, CsvTableRefuses,
    testing::Values(
        OddFile{"Empty", "", "t.csv: the file is empty; record or export the data again"},
        OddFile{"OnlyComments", "# a\n\n# b\n",
                "t.csv: the file holds nothing but comments and blank lines; record or export the data again"},
        OddFile{"OnlyHeader", "encoder_deg,sensor_deg\n",
                "t.csv: the file holds a header but no data; record or export the data again"},
        OddFile{"OnlyByteOrderMark", "\xEF\xBB\xBF",
                "t.csv: the file holds nothing but comments and blank lines; record or export the data again"},
        OddFile{"TooFew", "a,b\n1,2\n3\n",
                "t.csv:3: the row has 1 column instead of 2; check the row and the separator"},
        OddFile{"TooMany", "a,b\n1,2\n3,4,5\n",
                "t.csv:3: the row has 3 columns instead of 2; check the row; a decimal comma needs ; or tab between "
                "the columns"},
        OddFile{"Binary", std::string("a,b\n1,\x01\n", 8),
                "t.csv:2: the file is not text: it holds the byte 0x01; name a CSV file"},
        OddFile{"Utf16Marked",
                std::string("\xFF\xFE"
                            "a\0,\0b\0\n\0",
                            10),
                "t.csv: the text is UTF-16 or UTF-32; save the file as UTF-8 (in a spreadsheet: CSV UTF-8)"},
        OddFile{"Utf16Bare",
                std::string("1\0,\0"
                            "2\0\n\0"
                            "3\0,\0",
                            12),
                "t.csv: the text is UTF-16 or UTF-32; save the file as UTF-8 (in a spreadsheet: CSV UTF-8)"},
        OddFile{"Spreadsheet", std::string("PK\x03\x04\x14\x00", 6),
                "t.csv: this is a spreadsheet or an archive, not CSV text; export the table as CSV"},
        OddFile{"OpenQuote", "a,b\n\"1,2\n3,4\n",
                "t.csv:2: a quoted field does not end in this line; close the quote or remove it"},
        OddFile{"HugeLine", "a,b\n1," + std::string(longestCsvLine, '7') + "\n",
                "t.csv:2: the line is longer than 1048576 characters; name a CSV file with one reading in a line"}),
    [](const auto& param) { return param.param.name; });

TEST(CsvTable, CellsThatAreNoNumbers) {
  const auto table = parse("a;b\n1,5;2\n;abc\n2.5;3\n");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->number(1, 0).error().message(), "t.csv:3: column \"a\" is empty; fill it in or remove the row");
  EXPECT_EQ(table->number(1, 1).error().message(),
            "t.csv:3: column \"b\" holds \"abc\", which is no number; correct it or remove the row");
  EXPECT_EQ(table->number(2, 0).error().message(), "t.csv:4: column \"a\" holds \"2.5\", which is no number; the "
                                                   "file's decimal mark is a comma; use it in every row");
}

TEST(CsvTable, FilesThatCannotBeRead) {
  EXPECT_EQ(CsvTable::read("/nowhere/x.csv").error().message(),
            "/nowhere/x.csv: the file does not exist; check the name and the folder");
  const std::string folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(CsvTable::read(folder).error().message(), folder + ": this is a folder, not a file; name a file inside it");
}

} // namespace
} // namespace straightedge
