#include "devices/instruments/field_instruments.h"
#include "devices/instruments/json_place.h"
#include "devices/instruments/profile.h"
#include "devices/instruments/profile_files.h"
#include "devices/instruments/profile_instrument.h"
#include "tests/devices/instruments/scripted_dialogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <unistd.h>

namespace straightedge::devices {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

TEST(JsonPlace, LinesOfValues) {
  const std::string text = "\n{ \"a\": 1,\n  \"b{\\\"\": [\n    \"x]\",\n    { \"c\":\n 2, \"d\": [] },\n 3\n] }\n";
  const auto line = [&](const std::vector<std::string>& path) { return lineInJson(text, path); };
  EXPECT_EQ(line({}), 2);
  EXPECT_EQ(line({"a"}), 2);
  EXPECT_EQ(line({"b{\\\""}), 3);
  EXPECT_EQ(line({"b{\\\"", "0"}), 4);
  EXPECT_EQ(line({"b{\\\"", "1"}), 5);
  EXPECT_EQ(line({"b{\\\"", "1", "c"}), 6);
  EXPECT_EQ(line({"b{\\\"", "1", "d"}), 6);
  EXPECT_EQ(line({"b{\\\"", "2"}), 7);
  EXPECT_EQ(line({"b{\\\"", "3"}), 3) << "the list, where the item is missing";
  EXPECT_EQ(line({"none"}), 2);
}

/// A small profile, with `replace`d text.
std::string profileText(const std::string& replaced = "", const std::string& with = "") {
  std::string text = R"({
  "format": "straightedge-instrument",
  "version": 1,
  "name": "Tesla meter",
  "transports": [
    { "kind": "serial", "baud": 19200, "parity": "even", "data_bits": 7 },
    { "kind": "usbtmc", "vendor_id": "1bfa", "product_id": "0498" }
  ],
  "command_end": "\r",
  "reply_end": "\r\n",
  "identification": { "command": "ID", "contains": "TM-1" },
  "set_up": ["UNIT mT"],
  "readings": [
    {
      "role": "field-reference",
      "command": "B?",
      "no_reading": "OVER",
      "regex": "B=([-+0-9.eE]+|nan)mT",
      "columns": { "unit": "mT", "least": -2, "most": 2 }
    },
    {
      "role": "temperature",
      "set_up": "SENSOR T",
      "command": "T?",
      "columns": { "field": 2, "unit": "K" }
    }
  ]
}
)";
  if (!replaced.empty()) {
    const std::size_t at = text.find(replaced);
    EXPECT_NE(at, std::string::npos) << replaced;
    text.replace(at, replaced.size(), with);
  }
  return text;
}

TEST(Profile, IsReadWhole) {
  const auto profile = parseProfile(profileText(), "/home/a/tesla_meter.json");
  ASSERT_TRUE(profile) << problemOf(profile);
  EXPECT_EQ(profile->id, "tesla_meter");
  EXPECT_EQ(profile->name, "Tesla meter");
  EXPECT_TRUE(profile->notYetTried) << "unless the file says otherwise";
  EXPECT_EQ(profile->connections, (std::vector{Connection::Serial, Connection::Usbtmc}));
  ASSERT_TRUE(profile->serial);
  EXPECT_EQ(profile->serial->baud, 19200);
  EXPECT_EQ(profile->serial->dataBits, 7);
  EXPECT_EQ(profile->serial->parity, Parity::Even);
  ASSERT_EQ(profile->usb.size(), 1U);
  EXPECT_EQ(profile->usb[0], (UsbIds{0x1bfa, 0x0498}));
  EXPECT_EQ(rolesOf(*profile), (std::vector{InstrumentRole::FieldReference, InstrumentRole::Temperature}));
  EXPECT_TRUE(identifies(*profile, "ACME TM-1 v3"));
  EXPECT_FALSE(identifies(*profile, "ACME TM-2 v3"));
}

TEST(Profile, AReferenceSaysWhetherItKeepsItsZero) {
  const auto incrementOf = [](const std::string& key) {
    const auto profile = parseProfile(R"({"format": "straightedge-instrument", "version": 1, "name": "encoder",
      "transports": [{"kind": "serial"}], "readings": [{"role": "angle-reference", "columns": {"field": 1})" +
                                          key + "}]}",
                                      "encoder.json");
    EXPECT_TRUE(profile) << problemOf(profile);
    auto line = script({"x"});
    SteppingClock clock;
    return makeProfileInstrument(line, clock, *profile)->angleReference()->incrementDeg();
  };
  EXPECT_EQ(incrementOf(""), 0.0) << "where the file does not say it is lost with the power";
  EXPECT_EQ(incrementOf(R"(, "keeps_zero": false)"), 0.0);
  EXPECT_EQ(incrementOf(R"(, "keeps_zero": true)"), std::nullopt);
}

TEST(Profile, WhichTemperatureItIsIsTheBenchsToSay) {
  EXPECT_THAT(problemOf(parseProfile(profileText("\"temperature\"", "\"chamber-temperature\""), "a.json")),
              HasSubstr("is no role"));
}

TEST(Profile, WhatIsWrongIsToldWithItsLine) {
  struct Case {
    const char* replaced;
    const char* with;
    int line;
    const char* what;
  };
  for (const Case& bad : {
           Case{"\"name\"", "\"nmae\"", 4, "nmae is no key"},
           Case{"straightedge-instrument", "other", 2, "format is not straightedge-instrument"},
           Case{"\"version\": 1", "\"version\": 2", 3, "version is no number from 1 to 1"},
           Case{"\"Tesla meter\"", "\"\"", 4, "name is empty"},
           Case{"\"Tesla meter\"", "7", 4, "name is no text"},
           Case{"19200", "\"19200\"", 6, "transports.0.baud is no number from 50"},
           Case{"19200", "19200.5", 6, "transports.0.baud is no whole number"},
           Case{"\"even\"", "\"eaven\"", 6, "transports.0.parity"},
           Case{"\"usbtmc\"", "\"gpib\"", 7, "transports.1.kind is neither"},
           Case{"\"1bfa\"", "\"0x1b\"", 7, "transports.1.vendor_id is not four"},
           Case{", \"product_id\": \"0498\"", "", 7, "transports.1 has only one of"},
           Case{"\"\\r\\n\"", "\"\"", 10, "reply_end is empty"},
           Case{", \"contains\": \"TM-1\"", "", 11, "identification.contains is missing"},
           Case{"\"field-reference\"", "\"fieldreference\"", 15, "readings.0.role is no role"},
           Case{"\"temperature\"", "\"field-reference\"", 25, "readings.1.columns.unit"},
           Case{"\"role\": \"field-reference\"", "\"role\": \"temperature\"", 19, "readings.0.columns.unit"},
           Case{"([-+0-9.eE]+|nan)", "([", 18, "readings.0.regex is no regular expression"},
           Case{"([-+0-9.eE]+|nan)", "(a)(b)", 18, "readings.0.regex has 2 groups for 1 columns"},
           Case{"([-+0-9.eE]+|nan)", "(a)\\\\1", 18, "readings.0.regex is no regular expression"},
           Case{"\"least\": -2", "\"least\": 3", 14, "readings.0 cannot be read: the lower limit"},
           Case{"\"unit\": \"mT\"", "\"unit\": \"ohm\"", 19, "readings.0.columns.unit is no unit of the role"},
           Case{"\"field\": 2", "\"field\": 0", 25, "readings.1.columns.field"},
           Case{"\"command\": \"B?\",", "", 18, "readings.0.regex goes with a command only"},
           Case{"\"set_up\": [\"UNIT mT\"],", "\"set_up\": [\"UNIT mT\", 5],", 12, "set_up.1 is no text"},
           Case{"\"set_up\": [\"UNIT mT\"],", "\"set_up\": [\"UNIT mT\"]", 13, "this is not JSON"},
           Case{"19200", "1e999", 0, ""},
       }) {
    const auto profile = parseProfile(profileText(bad.replaced, bad.with), "p.json");
    ASSERT_FALSE(profile) << bad.with;
    EXPECT_EQ(profile.error().kind, ErrorKind::Input);
    EXPECT_FALSE(profile.error().remedy.empty());
    EXPECT_THAT(profile.error().what, HasSubstr(bad.what)) << bad.with;
    EXPECT_EQ(profile.error().where, bad.line == 0 ? "p.json" : "p.json:" + std::to_string(bad.line))
        << profile.error().message();
  }
  EXPECT_EQ(parseProfile("", "p.json").error().where, "p.json:1");
  EXPECT_EQ(parseProfile("[]", "p.json").error().where, "p.json:1");
}

TEST(Profile, DrivesTheInstrument) {
  const auto profile = parseProfile(profileText(), "p.json");
  ASSERT_TRUE(profile);
  auto line = script({"x",
                      "> ID\\r",
                      "< ACME,TM-1,007,v3\\r\\n",
                      "> UNIT mT\\r",
                      "> B?\\r",
                      "< B=-250.5mT\\r\\n",
                      "> SENSOR T\\r",
                      "> T?\\r",
                      "< 1,300.15\\r\\n",
                      "> T?\\r",
                      "< 1,301.15\\r\\n",
                      "> B?\\r",
                      "< OVER\\r\\n",
                      "> B?\\r",
                      "< B=nanmT\\r\\n",
                      "x",
                      "> B?\\r",
                      "< B=2500mT\\r\\n",
                      "x",
                      "> B?\\r",
                      "!< timed-out",
                      "x",
                      "> B?\\r",
                      "< B=100mT\\r\\n",
                      "> SENSOR T\\r",
                      "> T?\\r",
                      "< 1\\r\\n"});
  SteppingClock clock;
  const auto made = makeProfileInstrument(line, clock, *profile);
  const auto prepared = made->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  EXPECT_EQ(made->identity().serial, "007");
  EXPECT_EQ(made->angleSensor(), nullptr);
  EXPECT_EQ(made->angleReadings(InstrumentRole::AngleSensor), nullptr);
  EXPECT_EQ(made->resistanceMeter(), nullptr);
  FieldReference* reference = made->fieldReference();
  Thermometer* thermometer = made->thermometer();
  ASSERT_NE(reference, nullptr);
  ASSERT_NE(thermometer, nullptr);
  EXPECT_DOUBLE_EQ(reference->readT().value().fieldT.value(), -0.2505);
  EXPECT_NEAR(thermometer->readC().value().value, 27.0, 1e-9);
  EXPECT_NEAR(thermometer->readC().value().value, 28.0, 1e-9) << "set up once, not for every reading";
  const auto over = reference->readT();
  ASSERT_TRUE(over) << problemOf(over);
  EXPECT_FALSE(over->locked);
  EXPECT_FALSE(over->fieldT);
  EXPECT_THAT(problemOf(reference->readT()), HasSubstr("not a finite number"));
  EXPECT_THAT(problemOf(reference->readT()), HasSubstr("out of its limits"));
  EXPECT_FALSE(reference->readT());
  EXPECT_EQ(made->lastFault(), TransportFault::TimedOut);
  EXPECT_DOUBLE_EQ(reference->readT().value().fieldT.value(), 0.1);
  EXPECT_THAT(problemOf(thermometer->readC()), HasSubstr("field 2"));
  expectPlayed(line);
}

TEST(Profile, ATimeOutMayHaveBeenAPowerCycleSoItIsSetUpAgain) {
  const auto profile = parseProfile(profileText(), "p.json");
  ASSERT_TRUE(profile);
  auto line = script({"> SENSOR T\\r", "> T?\\r", "!< timed-out", "x", "> SENSOR T\\r", "> T?\\r", "< 1,300.15\\r\\n"});
  SteppingClock clock;
  const auto made = makeProfileInstrument(line, clock, *profile);
  EXPECT_FALSE(made->thermometer()->readC());
  EXPECT_NEAR(made->thermometer()->readC().value().value, 27.0, 1e-9);
  expectPlayed(line);
}

TEST(Profile, ThePt100ThatIsShipped) {
  const ProfileSet set = readProfiles("");
  const Profile* profile = findProfile(set, "scpi_multimeter_pt100");
  ASSERT_NE(profile, nullptr);
  auto line = script({"x", "> *IDN?\\n", "< HEWLETT-PACKARD,34401A,0,11-5-2\\n", "> *CLS\\n", "> CONF:FRES 1000\\n",
                      "> FRES:NPLC 10\\n", "> TRIG:SOUR IMM\\n", "> SYST:ERR?\\n", "< +0,\"No error\"\\n", "> READ?\\n",
                      "< +1.07793500E+02\\n", "> READ?\\n", "< +9.90000000E+37\\n"},
                     true);
  SteppingClock clock;
  const auto made = makeProfileInstrument(line, clock, *profile);
  const auto prepared = made->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  EXPECT_DOUBLE_EQ(made->resistanceMeter()->readOhm().value().value, 107.7935);
  EXPECT_THAT(problemOf(made->resistanceMeter()->readOhm()), HasSubstr("no reading"));
  expectPlayed(line);
}

TEST(Profile, TheBoardsThatAreShipped) {
  const ProfileSet set = readProfiles("");
  SteppingClock clock;
  auto columns = script({"x", "x", "< up\\n0.52\\t187.25\\t3\\n", "x", "< 7\\t3\\n0.52\\t-90\\t3\\n", "x",
                         "< \\n0.5\\t1\\t1\\n0.5\\t2\\t1\\n", "!< timed-out"});
  const auto board = makeProfileInstrument(columns, clock, *findProfile(set, "ascii_board_columns"));
  const auto prepared = board->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  EXPECT_DOUBLE_EQ(board->angleSensor()->readDeg().value().value, 270.0);
  ASSERT_NE(board->angleReadings(InstrumentRole::AngleSensor), nullptr);
  ASSERT_TRUE(board->angleReadings(InstrumentRole::AngleSensor)->start());
  EXPECT_EQ(board->angleReadings(InstrumentRole::AngleSensor)->read().value().readings.size(), 2U);
  expectPlayed(columns);

  auto labels = script({"x", "< 0.1\\nangle (normalized): 0.25\\tangle (rad): 1.5707963267948966\\n"});
  const auto labelled = makeProfileInstrument(labels, clock, *findProfile(set, "ascii_board_labels"));
  EXPECT_DOUBLE_EQ(labelled->angleSensor()->readDeg().value().value, 90.0);
  expectPlayed(labels);
}

TEST(Profile, SensorAndReferenceInTheSameLinesStreamTogether) {
  Profile profile;
  profile.name = "Board of both";
  ProfileReading sensor;
  sensor.format.columns = {{.quantity = "sensor", .index = 2, .label = {}, .unit = {}}};
  ProfileReading reference = sensor;
  reference.role = InstrumentRole::AngleReference;
  reference.format.columns = {{.quantity = "encoder", .index = 1, .label = {}, .unit = {}, .scale = 0.5}};
  profile.readings = {sensor, reference};
  SteppingClock clock;
  auto line = script({"x", "< 1\\n700,359\\n10,-1\\n", "!< timed-out"});
  const auto board = makeProfileInstrument(line, clock, profile);
  AngleStream* stream = board->angleStream();
  ASSERT_NE(stream, nullptr);
  ASSERT_TRUE(stream->start({}));
  const auto block = stream->read();
  ASSERT_TRUE(block) << problemOf(block);
  ASSERT_EQ(block->samples.size(), 2U);
  EXPECT_DOUBLE_EQ(block->samples[0].encoderDeg, 350.0);
  EXPECT_DOUBLE_EQ(block->samples[1].encoderDeg, 365.0) << "unwrapped";
  EXPECT_DOUBLE_EQ(block->samples[1].sensorDeg, 359.0);
  expectPlayed(line);
  EXPECT_NE(board->angleReadings(InstrumentRole::AngleReference), nullptr);

  profile.readings[1].format.prefix = "E";
  auto other = script({"x"});
  EXPECT_EQ(makeProfileInstrument(other, clock, profile)->angleStream(), nullptr) << "lines of two kinds";
}

TEST(Profile, TheSchemaHasTheReadersKeys) {
  std::ifstream file(STRAIGHTEDGE_TEST_DATA "/../../resources/instruments/instrument.schema.json");
  const auto schema = nlohmann::json::parse(file);
  for (const ProfileKeys& object : profileKeys()) {
    std::vector<std::string> inSchema;
    for (const auto& [key, value] : schema.at("$defs").at(std::string(object.object)).at("properties").items()) {
      inSchema.push_back(key);
    }
    EXPECT_THAT(inSchema, testing::UnorderedElementsAreArray(object.keys)) << object.object;
  }
}

TEST(ProfileFiles, EveryShippedFileIsBuiltInAndGood) {
  const ProfileSet set = readProfiles("");
  for (const Error& problem : set.problems) {
    ADD_FAILURE() << problem.message();
  }
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(STRAIGHTEDGE_TEST_DATA "/../../resources/instruments")) {
    if (entry.path().filename() == "instrument.schema.json") {
      continue;
    }
    ++files;
    EXPECT_NE(findProfile(set, entry.path().stem().string()), nullptr)
        << entry.path() << " is not listed in devices/CMakeLists.txt";
  }
  EXPECT_EQ(set.profiles.size(), files);
  EXPECT_GE(files, 4U);
}

class UserFolder {
public:
  UserFolder() : m_path(fs::temp_directory_path() / ("straightedge-profiles-" + std::to_string(::getpid()))) {
    fs::remove_all(m_path);
    fs::create_directories(m_path);
  }
  UserFolder(const UserFolder&) = delete;
  UserFolder& operator=(const UserFolder&) = delete;
  ~UserFolder() { fs::remove_all(m_path); }
  std::string path() const { return m_path.string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(m_path / name) << text; }

private:
  fs::path m_path;
};

TEST(ProfileFiles, TheUsersOwnAreReadAndABadOneStopsNoOther) {
  const UserFolder folder;
  folder.write("a_meter.json", profileText());
  folder.write("broken.json", profileText("19200", "\"fast\""));
  folder.write("scpi_multimeter_pt100.json", profileText("Tesla meter", "My own"));
  folder.write("instrument.schema.json", "{}");
  folder.write("notes.txt", "not a profile");
  const ProfileSet set = readProfiles(folder.path());
  ASSERT_EQ(set.problems.size(), 1U);
  EXPECT_EQ(set.problems[0].where, folder.path() + "/broken.json:6");
  EXPECT_NE(findProfile(set, "a_meter"), nullptr);
  EXPECT_EQ(findProfile(set, "scpi_multimeter_pt100")->name, "My own");
  EXPECT_EQ(findProfile(set, "broken"), nullptr);
  EXPECT_EQ(set.profiles.size(), shippedProfileTexts().size() + 1);
  EXPECT_TRUE(readProfiles(folder.path() + "/none").problems.empty());
}

} // namespace
} // namespace straightedge::devices
