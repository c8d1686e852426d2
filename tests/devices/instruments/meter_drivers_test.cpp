#include "devices/instruments/ascii_board.h"
#include "devices/instruments/instrument_table.h"
#include "devices/instruments/scpi_multimeter.h"
#include "tests/devices/instruments/scripted_dialogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace straightedge::devices {
namespace {

using testing::HasSubstr;

TEST(ScpiReplies, IdentityErrorsAndNumbers) {
  const auto identity = parseIdentity("HEWLETT-PACKARD,34401A,0,11-5-2\n");
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->model, "HEWLETT-PACKARD 34401A");
  EXPECT_EQ(identity->serial, "");
  EXPECT_EQ(identity->firmware, "11-5-2");
  EXPECT_EQ(parseIdentity("A,B,C,D,E")->firmware, "D,E");
  EXPECT_FALSE(parseIdentity("hello"));
  EXPECT_FALSE(parseIdentity(""));
  EXPECT_FALSE(parseIdentity("maker,"));
  EXPECT_EQ(parseScpiError("+0,\"No error\"")->code, 0);
  EXPECT_EQ(parseScpiError("-113,\"Undefined header\"\n")->text, "Undefined header");
  EXPECT_EQ(parseScpiError("0")->code, 0);
  EXPECT_FALSE(parseScpiError("none"));
  EXPECT_FALSE(parseScpiError(""));
  EXPECT_DOUBLE_EQ(parseScpiNumber("+1.04567890E+02\r\n").value(), 104.567890);
  EXPECT_FALSE(parseScpiNumber("nan"));
  EXPECT_FALSE(parseScpiNumber("1,2"));
  EXPECT_TRUE(isScpiOverload(parseScpiNumber("+9.90000000E+37").value()));
  EXPECT_TRUE(isScpiOverload(-9.9e37));
}

TEST(ScpiMultimeter, ReadsAPt100OverRs232) {
  auto line = script({"x",
                      "> :SYST:REM\\n",
                      "> *CLS\\n",
                      "> *IDN?\\n",
                      "< HEWLETT-PACKARD,34401A,0,11-5-2\\r\\n",
                      "> CONF:FRES 1000\\n",
                      "> FRES:NPLC 10\\n",
                      "> TRIG:SOUR IMM\\n",
                      "> SAMP:COUN 1\\n",
                      "> SYST:ERR?\\n",
                      "< +0,\"No error\"\\r\\n",
                      "> READ?\\n",
                      "< +1.07793500E+02\\r\\n",
                      "> READ?\\n",
                      "< +9.90000000E+37\\r\\n",
                      "> READ?\\n",
                      "< +1.0779\\n",
                      "> READ?\\n",
                      "< 1.07,1.08\\r\\n",
                      "x",
                      "> READ?\\n",
                      "!< gone"});
  SteppingClock clock;
  auto made = ScpiMultimeter::make(line, clock, {{"range", "1000"}});
  ASSERT_TRUE(made) << problemOf(made);
  const auto prepared = (*made)->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  EXPECT_EQ((*made)->angleSensor(), nullptr);
  ResistanceMeter* meter = (*made)->resistanceMeter();
  ASSERT_NE(meter, nullptr);
  EXPECT_DOUBLE_EQ(meter->readOhm().value().value, 107.7935);
  EXPECT_THAT(problemOf(meter->readOhm()), HasSubstr("overloaded"));
  EXPECT_DOUBLE_EQ(meter->readOhm().value().value, 1.0779);
  EXPECT_THAT(problemOf(meter->readOhm()), HasSubstr("'1.07,1.08'"));
  EXPECT_FALSE(meter->readOhm());
  EXPECT_EQ((*made)->lastFault(), TransportFault::Gone);
  expectPlayed(line);
}

TEST(ScpiMultimeter, ReadsAnAnalogueSensorOverUsb) {
  auto line = script({"x", "> *CLS\\n", "> *IDN?\\n", "< Agilent Technologies,34410A,MY1,2.35\\n", "> CONF:VOLT:DC\\n",
                      "> VOLT:DC:NPLC 1\\n", "> TRIG:SOUR IMM\\n", "> SAMP:COUN 1\\n", "> SYST:ERR?\\n",
                      "< +0,\"No error\"\\n", "> READ?\\n", "< +1.25E+00\\n", "> READ?\\n", "< -1.0E-02\\n"},
                     true);
  SteppingClock clock;
  auto made = ScpiMultimeter::make(line, clock, {{"function", "volt"}, {"power_line_cycles", "1"}});
  ASSERT_TRUE(made) << problemOf(made);
  const auto prepared = (*made)->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  EXPECT_EQ((*made)->resistanceMeter(), nullptr);
  EXPECT_DOUBLE_EQ((*made)->angleSensor()->readDeg().value().value, 90.0);
  EXPECT_NEAR((*made)->angleSensor()->readDeg().value().value, 359.28, 1e-12);
  expectPlayed(line);
}

TEST(ScpiMultimeter, ASettingThatItRefusesIsTold) {
  auto line = script({"x", "> *CLS\\n", "> *IDN?\\n", "< HEWLETT-PACKARD,34401A,0,11-5-2\\n", "> CONF:FRES\\n",
                      "> FRES:NPLC 10\\n", "> TRIG:SOUR IMM\\n", "> SAMP:COUN 1\\n", "> SYST:ERR?\\n",
                      "< -113,\"Undefined header\"\\n", "> SYST:ERR?\\n", "< +0,\"No error\"\\n"},
                     true);
  SteppingClock clock;
  auto made = ScpiMultimeter::make(line, clock, {});
  ASSERT_TRUE(made);
  EXPECT_THAT(problemOf((*made)->prepare()), HasSubstr("-113 (Undefined header)"));
  EXPECT_FALSE((*made)->lastFault());
}

TEST(AsciiBoard, AReadingBeganAfterItWasAskedFor) {
  auto line = script(
      {"x", "< 7.5\\nAS5600 ready\\n", "< 12.5\\n", "x", "< 0.25\\n13", "< 0.25\\n", "x", "< 5\\nnan\\n", "< -10\\n"});
  SteppingClock clock;
  auto made = AsciiBoard::make(line, clock, {});
  ASSERT_TRUE(made) << problemOf(made);
  const auto prepared = (*made)->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  AngleSensor* sensor = (*made)->angleSensor();
  EXPECT_DOUBLE_EQ(sensor->readDeg().value().value, 130.25) << "0.25 is the rest of a line that began before";
  EXPECT_DOUBLE_EQ(sensor->readDeg().value().value, 350.0);
  EXPECT_EQ((*made)->thermometer(), nullptr);
  expectPlayed(line);
}

TEST(AsciiBoard, GarbageIsNoReadingAndSaysWhatItWas) {
  auto line = script({"x", "< ?\\n\\xFE\\xFF\\n\\x00\\n", "!< timed-out", "x", "!< timed-out", "x", "!< gone"});
  SteppingClock clock;
  auto made = AsciiBoard::make(line, clock, {});
  ASSERT_TRUE(made);
  EXPECT_THAT(problemOf((*made)->prepare()), HasSubstr("no reading came within 2"));
  EXPECT_FALSE((*made)->lastFault());
  EXPECT_THAT(problemOf((*made)->prepare()), HasSubstr("nothing came"));
  EXPECT_EQ((*made)->lastFault(), TransportFault::TimedOut);
  EXPECT_FALSE((*made)->prepare());
  EXPECT_EQ((*made)->lastFault(), TransportFault::Gone);
  expectPlayed(line);
}

TEST(AsciiBoard, ColumnsUnitsAndTurns) {
  auto line = script({"x", "< \\n0.5\\t4095\\t21.5\\n", "x", "< \\n0.5\\t1\\t21.5\\n", "x", "< \\n0.5\\t1\\t21.5\\n"});
  SteppingClock clock;
  auto made = AsciiBoard::make(line, clock,
                               {{"separator", "tab"},
                                {"column", "2"},
                                {"unit", "count"},
                                {"counts_per_turn", "4096"},
                                {"temperature_column", "3"}});
  ASSERT_TRUE(made) << problemOf(made);
  AngleReference* reference = (*made)->angleReference();
  EXPECT_DOUBLE_EQ(reference->readDeg().value().value, 4095 * 360.0 / 4096);
  EXPECT_DOUBLE_EQ(reference->readDeg().value().value, 4097 * 360.0 / 4096);
  EXPECT_DOUBLE_EQ((*made)->thermometer()->readC().value().value, 21.5);
  expectPlayed(line);
  EXPECT_THAT(problemOf(AsciiBoard::make(line, clock, {{"unit", "count"}})), HasSubstr("counts_per_turn"));
}

TEST(AsciiBoard, AsAReferenceItsZeroIsLostWithThePowerUnlessTheSettingsKnowBetter) {
  auto line = script({"x"});
  SteppingClock clock;
  EXPECT_EQ((*AsciiBoard::make(line, clock, {}))->angleReference()->incrementDeg(), 0.0) << "its step is not known";
  const auto absolute = AsciiBoard::make(line, clock, {{"keeps_zero", "yes"}});
  ASSERT_TRUE(absolute) << problemOf(absolute);
  EXPECT_FALSE((*absolute)->angleReference()->incrementDeg());
}

TEST(AsciiBoard, BothAnglesOfALineStreamTogether) {
  auto line = script({"x", "< 9\\n100,1.5\\n16380,359.5\\n", "!< timed-out", "< 3,-0.5\\nnan,4\\n40,1\\n",
                      "!< timed-out", "x", "< \\n8192,7\\n", "x", "< \\n8192,370\\n"});
  SteppingClock clock;
  auto made = AsciiBoard::make(line, clock,
                               {{"column", "2"},
                                {"reference_column", "1"},
                                {"reference_unit", "count"},
                                {"reference_counts_per_turn", "16384"}});
  ASSERT_TRUE(made) << problemOf(made);
  AngleStream* stream = (*made)->angleStream();
  ASSERT_NE(stream, nullptr);
  ASSERT_TRUE(stream->start({.rateHz = 1000.0}));
  EXPECT_FALSE((*made)->angleReference()->readDeg()) << "single readings and a stream do not go together";
  const auto first = stream->read();
  ASSERT_TRUE(first) << problemOf(first);
  ASSERT_EQ(first->samples.size(), 2U);
  EXPECT_DOUBLE_EQ(first->samples[0].encoderDeg, 100 * 360.0 / 16384);
  EXPECT_DOUBLE_EQ(first->samples[0].sensorDeg, 1.5);
  EXPECT_DOUBLE_EQ(first->samples[1].encoderDeg, -4 * 360.0 / 16384) << "unwrapped the shorter way";
  const auto second = stream->read();
  ASSERT_TRUE(second);
  ASSERT_EQ(second->samples.size(), 2U);
  EXPECT_EQ(second->rejected, 1);
  EXPECT_DOUBLE_EQ(second->samples[0].encoderDeg, 3 * 360.0 / 16384);
  EXPECT_DOUBLE_EQ(second->samples[0].sensorDeg, 359.5);
  EXPECT_LT(first->samples[1].timeS, second->samples[0].timeS);
  ASSERT_TRUE(stream->stop());
  EXPECT_DOUBLE_EQ((*made)->angleReference()->readDeg().value().value, 180.0);
  EXPECT_DOUBLE_EQ((*made)->angleSensor()->readDeg().value().value, 10.0);
  expectPlayed(line);
  EXPECT_THAT(problemOf(AsciiBoard::make(line, clock, {{"reference_label", "enc"}, {"reference_unit", "count"}})),
              HasSubstr("reference_counts_per_turn"));
  EXPECT_EQ((*AsciiBoard::make(line, clock, {}))->angleStream(), nullptr);
}

TEST(AsciiBoard, AFaultBehindReadingsIsToldAfterThem) {
  auto line = script({"x", "< \\n1.5\\n", "!< overflow", "< 2.5\\n", "!< timed-out"});
  SteppingClock clock;
  auto made = AsciiBoard::make(line, clock, {});
  ReadingStream* stream = (*made)->angleReadings(InstrumentRole::AngleSensor);
  ASSERT_TRUE(stream->start());
  EXPECT_EQ(stream->read().value().readings.size(), 1U);
  EXPECT_FALSE(stream->read());
  EXPECT_EQ((*made)->lastFault(), TransportFault::Overflow);
  EXPECT_EQ(stream->read().value().readings.size(), 1U);
}

TEST(AsciiBoard, ReadingsOfManyArrivalsAreSpreadOverTheTimeSinceTheOneBefore) {
  // At every look at the clock 1 ms passes: two at the start, one for each of three arrivals.
  auto line = script({"x", "< \\n1\\n", "< 2\\n3\\n", "< 4\\n", "!< timed-out"});
  SteppingClock clock;
  auto made = AsciiBoard::make(line, clock, {});
  ReadingStream* stream = (*made)->angleReadings(InstrumentRole::AngleSensor);
  ASSERT_TRUE(stream->start());
  const auto block = stream->read();
  ASSERT_TRUE(block);
  ASSERT_EQ(block->readings.size(), 4U);
  const double stepS = block->readings[1].timeS - block->readings[0].timeS;
  EXPECT_GT(stepS, 0.0);
  EXPECT_NEAR(block->readings[2].timeS - block->readings[1].timeS, stepS, 1e-12);
  EXPECT_NEAR(block->readings[3].timeS - block->readings[2].timeS, stepS, 1e-12);
}

TEST(AsciiBoard, AStreamLosesNothingAndCountsWhatIsNoReading) {
  auto line = script({"x", "< .5\\n1.5\\n2.5\\n3.", "!< timed-out", "< 5\\nnan\\n4.5\\n", "!< timed-out", "!< gone"});
  SteppingClock clock;
  auto made = AsciiBoard::make(line, clock, {});
  ASSERT_TRUE(made);
  ReadingStream* stream = (*made)->angleReadings(InstrumentRole::AngleSensor);
  ASSERT_TRUE(stream->start());
  EXPECT_FALSE((*made)->angleSensor()->readDeg());
  const auto first = stream->read();
  ASSERT_TRUE(first) << problemOf(first);
  ASSERT_EQ(first->readings.size(), 2U);
  EXPECT_DOUBLE_EQ(first->readings[0].value, 1.5);
  EXPECT_LT(first->readings[0].timeS, first->readings[1].timeS);
  const auto second = stream->read();
  ASSERT_TRUE(second);
  ASSERT_EQ(second->readings.size(), 2U);
  EXPECT_DOUBLE_EQ(second->readings[0].value, 3.5);
  EXPECT_DOUBLE_EQ(second->readings[1].value, 4.5);
  EXPECT_EQ(second->rejected, 1);
  EXPECT_LT(first->readings[1].timeS, second->readings[0].timeS);
  EXPECT_FALSE(stream->read());
  EXPECT_EQ((*made)->lastFault(), TransportFault::Gone);
}

TEST(InstrumentTable, EveryEntryIsWhole) {
  std::set<std::string_view> ids;
  for (const KnownInstrument& known : knownInstruments()) {
    EXPECT_TRUE(ids.insert(known.id).second) << known.id;
    EXPECT_EQ(knownInstrument(known.id), &known);
    EXPECT_FALSE(known.name.empty());
    EXPECT_FALSE(known.connections.empty());
    EXPECT_FALSE(known.roles.empty());
    ASSERT_NE(known.make, nullptr);
    ASSERT_NE(known.settings, nullptr);
    const bool serial = std::ranges::find(known.connections, Connection::Serial) != known.connections.end();
    EXPECT_EQ(serial, known.serial.has_value()) << known.id;
    for (const SettingDescription& setting : known.settings()) {
      EXPECT_FALSE(setting.label.empty()) << known.id << " " << setting.key;
      EXPECT_FALSE(setting.help.empty()) << known.id << " " << setting.key;
      if (!setting.choices.empty()) {
        EXPECT_NE(std::ranges::find(setting.choices, setting.fallback), setting.choices.end()) << setting.key;
      }
    }
    // Made with the defaults it fills its roles, or says which setting it needs.
    auto line = script({"x"});
    SteppingClock clock;
    const auto made = known.make(line, clock, {});
    EXPECT_TRUE(made || made.error().kind == ErrorKind::Usage) << known.id << ": " << problemOf(made);
  }
  EXPECT_EQ(ids.size(), 6U);
}

TEST(InstrumentTable, InstrumentsAreRecognised) {
  ASSERT_EQ(knownByUsb({0x1bfa, 0x0498}).size(), 1U);
  EXPECT_EQ(knownByUsb({0x1bfa, 0x0498})[0]->id, "metrolab-thm1176");
  EXPECT_TRUE(knownByUsb({0x0403, 0x6001})[0]->usbIdsAreAdapters);
  EXPECT_TRUE(knownByUsb({0x1234, 0x5678}).empty());
  EXPECT_EQ(knownByIdentity("HEWLETT-PACKARD,34401A,0,11-5-2")->id, "scpi-multimeter");
  EXPECT_EQ(knownByIdentity("RIGOL,DS1054Z,1,2"), nullptr);
  EXPECT_EQ(knownInstrument("none"), nullptr);
  for (const InstrumentRole role :
       {InstrumentRole::AngleSensor, InstrumentRole::AngleReference, InstrumentRole::FieldProbe,
        InstrumentRole::FieldReference, InstrumentRole::Resistance, InstrumentRole::Temperature}) {
    EXPECT_EQ(roleFromWord(roleWord(role)), role);
  }
  EXPECT_EQ(roleFromWord("stage"), std::nullopt);
}

} // namespace
} // namespace straightedge::devices
