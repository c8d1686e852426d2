// Bench files, and opening what they name.
#include "devices/bench/opened_bench.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace straightedge::devices {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char* const deskBench = R"({
  "format": "straightedge-bench", "version": 1, "name": "desk",
  "pairing": { "rule": "interpolate", "max_age_s": 0.05 },
  "instruments": [
    { "instrument": "usdigital-qsb", "roles": ["angle-reference"], "serial": "FT-1",
      "settings": { "counts_per_turn": 3600 }, "latency_s": 0.001 },
    { "instrument": "ascii-board", "roles": ["angle-sensor"], "port": "/dev/ttyS9", "baud": 9600 } ] })";

TEST(SavedBench, IsReadAndWrittenBack) {
  const auto bench = benchFromJson(deskBench, "desk.json");
  ASSERT_TRUE(bench) << bench.error().message();
  EXPECT_EQ(bench->name, "desk");
  EXPECT_EQ(bench->pairing.kind, PairingKind::Interpolate);
  EXPECT_EQ(bench->pairing.maxAgeS, 0.05);
  ASSERT_EQ(bench->instruments.size(), 2U);
  EXPECT_EQ(bench->instruments[0].settings.at("counts_per_turn"), "3600");
  EXPECT_EQ(bench->instruments[0].latencyS, 0.001);
  EXPECT_THAT(bench->instruments[0].roles, ElementsAre(InstrumentRole::AngleReference));
  EXPECT_EQ(bench->instruments[1].baud, 9600);
  EXPECT_EQ(bench->filling(InstrumentRole::AngleSensor), &bench->instruments[1]);
  EXPECT_EQ(bench->filling(InstrumentRole::FieldProbe), nullptr);
  const auto again = benchFromJson(benchToJson(*bench), "again");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(*again, *bench);
}

std::string problemOf(std::string_view from, std::string_view to) {
  std::string text = deskBench;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const auto bench = benchFromJson(text, "desk.json");
  return bench ? "" : bench.error().message();
}

TEST(SavedBench, WhatIsWrongIsToldWithItsLine) {
  EXPECT_THAT(problemOf("\"angle-sensor\"", "\"angle-reference\""), HasSubstr("desk.json:7: "));
  EXPECT_THAT(problemOf("\"angle-sensor\"", "\"angle-reference\""), HasSubstr("a second time"));
  EXPECT_THAT(problemOf("angle-sensor", "anglesensor"), HasSubstr("'anglesensor' and no role"));
  EXPECT_THAT(problemOf("\"serial\": \"FT-1\",", ""), HasSubstr("neither serial nor port"));
  EXPECT_THAT(problemOf("interpolate", "guess"), HasSubstr("as-read or interpolate"));
  EXPECT_THAT(problemOf("0.001", "-1"), HasSubstr("desk.json:6: "));
  EXPECT_THAT(problemOf("straightedge-bench", "bench"), HasSubstr("straightedge-bench, version 1"));
  EXPECT_THAT(problemOf("\"baud\"", "\"boud\""), HasSubstr("boud"));
  EXPECT_THAT(problemOf("} ] }", "} ]"), HasSubstr("desk.json:7: this is no JSON"));
  EXPECT_EQ(problemOf("0.001", "0.002"), "");
}

TEST(SavedBench, LivesInTheUsersFolder) {
  const straightedge::testing::TemporaryFolder folder;
  ::setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
  const auto file = saveBench(*benchFromJson(deskBench, "desk.json"));
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(*file, folder.path() + "/straightedge/benches/desk.json");
  const auto found = readBench("desk");
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_EQ(found->name, "desk");
  EXPECT_TRUE(readBench(*file));
  const auto missing = readBench("bank");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::Instrument);
  EXPECT_THAT(missing.error().message(), HasSubstr("--bench simulated"));
}

TEST(OpenedBench, NamesTheInstrumentThatIsNotThere) {
  auto saved = *benchFromJson(deskBench, "desk.json");
  const auto nothing = [] { return Result<std::vector<ListedDevice>>{}; };
  const auto opened = OpenedBench::open(saved, {}, nothing);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().kind, ErrorKind::Instrument);
  EXPECT_THAT(opened.error().message(), HasSubstr("US Digital QSB encoder reader, serial FT-1: "));
  EXPECT_THAT(opened.error().message(), HasSubstr("not plugged in"));
}

TEST(OpenedBench, RefusesTwoWithOneSerialNumberAndRolesThatCannotBeFilled) {
  auto saved = *benchFromJson(deskBench, "desk.json");
  const auto twice = [] {
    ListedDevice one;
    one.serial = "FT-1";
    return Result<std::vector<ListedDevice>>{{one, one}};
  };
  EXPECT_THAT(OpenedBench::open(saved, {}, twice).error().message(), HasSubstr("two devices with this serial number"));
  saved.instruments[0].roles = {InstrumentRole::FieldProbe};
  EXPECT_THAT(OpenedBench::open(saved, {}, twice).error().message(), HasSubstr("cannot fill the role field-probe"));
  saved.instruments[0].instrument = "nothing-known";
  EXPECT_THAT(OpenedBench::open(saved, {}, twice).error().message(), HasSubstr("no instrument 'nothing-known'"));
}

} // namespace
} // namespace straightedge::devices
