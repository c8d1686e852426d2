#include "devices/instruments/dtm151.h"
#include "devices/instruments/pt2025.h"
#include "devices/instruments/thm1176.h"
#include "tests/devices/instruments/scripted_dialogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace straightedge::devices {
namespace {

using testing::HasSubstr;

const std::string measure =
    "> :FETC:ARR:X? 1,5;:FETC:ARR:Y? 1,5;:FETC:ARR:Z? 1,5;:FETC:TIMESTAMP?;:FETC:TEMPERATURE?;*STB?\\n";

const std::vector<std::string> thmSetUp = {"x",
                                           "> :ABOR\\n",
                                           "> *CLS\\n",
                                           "> *IDN?\\n",
                                           "< Metrolab Technology SA,THM1176-MF,0123,el-A1-K1-B1\\n",
                                           "> :SENS:FLUX:RANG:AUTO OFF\\n",
                                           "> :SENS:FLUX:RANG:UPP 0.3 T\\n",
                                           "> :FORM:DATA ASCII\\n",
                                           "> :AVER:COUN 100\\n",
                                           "> :TRIG:SOUR IMM\\n",
                                           "> :TRIG:COUN 1\\n",
                                           "> :SYST:ERR?\\n",
                                           "< 0,\"No error\"\\n"};

ReplayTransport thmAfterSetUp(const std::vector<std::string>& more) { return script(thmSetUp, true, more); }

TEST(Thm1176Reply, OneReplyIsReadWhole) {
  const auto reply = parseThm1176Reply("0.012345 T;-0.250000 T; 1.5 MT;0x0000000012345678;23456;0\n");
  ASSERT_TRUE(reply);
  EXPECT_DOUBLE_EQ(reply->fieldT[0], 0.012345);
  EXPECT_DOUBLE_EQ(reply->fieldT[1], -0.25);
  EXPECT_DOUBLE_EQ(reply->fieldT[2], 0.0015);
  EXPECT_FALSE(reply->overload);
  EXPECT_EQ(reply->stampNs, 0x12345678U);
  EXPECT_EQ(reply->temperature, 23456);
  EXPECT_EQ(reply->status, 0);
  EXPECT_TRUE(parseThm1176Reply("9.9E37 T;0 T;0 T;0x1;0;0")->overload);
  for (const char* bad :
       {"", "0.1 T", "0.1 T;0.2 T;0.3 T;0x1;2", "0.1 T;0.2 T;0.3 T;0x1;2;0;0", "0.1 G;0.2 T;0.3 T;0x1;2;0",
        "0.1;0.2 T;0.3 T;0x1;2;0", "nan T;0.2 T;0.3 T;0x1;2;0", "0.1 T;0.2 T;0.3 T;17;2;0", "0.1 T;0.2 T;0.3 T;0x;2;0",
        "0.1 T;0.2 T;0.3 T;0x1;2;256", "0.1 T;;0.3 T;0x1;2;0", "0.1 T,0.2 T;0.2 T;0.3 T;0x1;2;0"}) {
    EXPECT_FALSE(parseThm1176Reply(bad)) << bad;
  }
}

TEST(Thm1176, ReadsAllAxesAtOnce) {
  auto line = thmAfterSetUp({"> :INIT\\n", measure, "< 0.012345 T;-0.250000 T;0.3 T;0x0000000012345678;23456;0\\n"});
  SteppingClock clock;
  auto made = Thm1176::make(line, clock, {{"range", "0.3"}});
  ASSERT_TRUE(made) << problemOf(made);
  const auto prepared = (*made)->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  EXPECT_EQ((*made)->identity().model, "Metrolab Technology SA THM1176-MF");
  EXPECT_EQ((*made)->identity().serial, "0123");
  const auto reading = (*made)->fieldProbe()->readT();
  ASSERT_TRUE(reading) << problemOf(reading);
  EXPECT_EQ(reading->rawT, (std::array{0.012345, -0.25, 0.3}));
  EXPECT_FALSE(reading->overRange);
  EXPECT_FALSE(reading->electronicsC) << "counts are no degrees";
  expectPlayed(line);
}

TEST(Thm1176, ItsTemperatureNeedsASlope) {
  auto line = thmAfterSetUp({"> :INIT\\n", measure, "< 0 T;0 T;0 T;0x1;2000;0\\n"});
  SteppingClock clock;
  Thm1176 probe(line, clock, {.rangeT = 0.3, .averages = 100, .celsiusPerCount = 0.0125, .celsiusAtZero = -1.0});
  ASSERT_TRUE(probe.prepare());
  EXPECT_DOUBLE_EQ(probe.readT().value().electronicsC.value(), 24.0);
}

TEST(Thm1176, BeyondTheRangeIsSaid) {
  auto line = thmAfterSetUp({"> :INIT\\n", measure, "< 0.35 T;0 T;0 T;0x1;2;0\\n", "> :INIT\\n", measure,
                             "< 0.31 T;0 T;0 T;0x1;2;0\\n", "> :INIT\\n", measure, "< 0 T;9.9E37 T;0 T;0x1;2;0\\n"});
  SteppingClock clock;
  Thm1176 probe(line, clock, {.rangeT = 0.3, .averages = 100, .celsiusPerCount = {}});
  ASSERT_TRUE(probe.prepare());
  EXPECT_TRUE(probe.readT().value().overRange);
  EXPECT_FALSE(probe.readT().value().overRange);
  EXPECT_TRUE(probe.readT().value().overRange);
}

TEST(Thm1176, ItsErrorQueueIsHeard) {
  auto line = thmAfterSetUp({"> :INIT\\n", measure, "< 0 T;0 T;0 T;0x1;2;4\\n", "> :SYST:ERR?\\n",
                             "< -221,\"Settings conflict\"\\n", "> :SYST:ERR?\\n", "< 0,\"No error\"\\n",
                             // an error in place of the reading
                             "> :INIT\\n", measure, "< \\n", "> :SYST:ERR?\\n", "< -230,\"Data corrupt or stale\"\\n",
                             "> :SYST:ERR?\\n", "< 0,\"No error\"\\n",
                             // garbage, and the queue knows nothing of it
                             "> :INIT\\n", measure, "< \\xFF\\x00garbage\\n", "> :SYST:ERR?\\n", "< 0,\\n",
                             // a time-out: cleared before the next command
                             "x", "> :INIT\\n", measure, "!< timed-out", "x", "> :INIT\\n", measure,
                             "< 0.1 T;0 T;0 T;0x1;2;0\\n"});
  SteppingClock clock;
  Thm1176 probe(line, clock, {.rangeT = 0.3, .averages = 100, .celsiusPerCount = {}});
  ASSERT_TRUE(probe.prepare());
  EXPECT_THAT(problemOf(probe.readT()), HasSubstr("-221 (Settings conflict)"));
  EXPECT_THAT(problemOf(probe.readT()), HasSubstr("-230 (Data corrupt or stale)"));
  EXPECT_THAT(problemOf(probe.readT()), HasSubstr("'\\xFF\\x00garbage'"));
  EXPECT_FALSE(probe.lastFault());
  EXPECT_THAT(problemOf(probe.readT()), HasSubstr("nothing came"));
  EXPECT_EQ(probe.lastFault(), TransportFault::TimedOut);
  EXPECT_DOUBLE_EQ(probe.readT().value().rawT[0], 0.1);
  expectPlayed(line);
}

TEST(Thm1176, AnotherInstrumentIsRefused) {
  auto line = script({"x", "> :ABOR\\n", "> *CLS\\n", "> *IDN?\\n", "< HEWLETT-PACKARD,34401A,0,11-5-2\\n"}, true);
  SteppingClock clock;
  Thm1176 probe(line, clock, {});
  EXPECT_THAT(problemOf(probe.prepare()), HasSubstr("instead of a THM1176"));
}

TEST(Pt2025Reply, RealReadings) {
  const auto megahertz = parsePt2025Reading("N44.914011F\r\n");
  ASSERT_TRUE(megahertz);
  EXPECT_EQ(megahertz->state, NmrState::NoSignal);
  EXPECT_DOUBLE_EQ(megahertz->value, 44.914011);
  EXPECT_FALSE(megahertz->tesla);
  const auto tesla = parsePt2025Reading("L1.0536470T\r\n");
  ASSERT_TRUE(tesla);
  EXPECT_EQ(tesla->state, NmrState::Locked);
  EXPECT_DOUBLE_EQ(tesla->value, 1.0536470);
  EXPECT_TRUE(tesla->tesla);
  for (const char* bad :
       {"", "L", "LT", "1.0536470T", "L1.0536470", "L-1.05T", "Lnan.T", "L1.0e5T", "S03F", "X1.05T", "L1.05 T"}) {
    EXPECT_FALSE(parsePt2025Reading(bad)) << bad;
  }
  EXPECT_EQ(parsePt2025Status("S03\r\n"), 3U);
  EXPECT_EQ(parsePt2025Status("S7FF"), 0x7FFU);
  for (const char* bad : {"", "S", "S0", "S1.05T", "S0G", "L03", "S12345"}) {
    EXPECT_FALSE(parsePt2025Status(bad)) << bad;
  }
}

const std::vector<std::string> ptSetUp = {"x", "> R", "> D1", "> PA", "> F1", "> A1", "> V0"};

ReplayTransport ptAfterSetUp(const std::vector<std::string>& more) { return script(ptSetUp, false, more); }

TEST(Pt2025, OnlyLockedReadingsHaveAValue) {
  auto line = ptAfterSetUp({"> S1", "< S23\\r\\n", "> \\x05", "< L1.0536470T\\r\\n", "> \\x05", "< N1.0536470T\\r\\n",
                            "> \\x05", "< S1.0536470T\\r\\n", "> \\x05", "< W1.0536470T\\r\\n"});
  SteppingClock clock;
  auto made = Pt2025::make(line, clock, {});
  ASSERT_TRUE(made) << problemOf(made);
  const auto prepared = (*made)->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  EXPECT_GT(clock.sleptS, 6 * 0.05 - 1e-9) << "it loses commands that follow faster";
  FieldReference* reference = (*made)->fieldReference();
  EXPECT_FALSE(reference->knowsSign());
  const auto locked = reference->readT();
  ASSERT_TRUE(locked) << problemOf(locked);
  EXPECT_TRUE(locked->locked);
  EXPECT_DOUBLE_EQ(locked->fieldT.value(), 1.053647);
  for (int i = 0; i < 3; ++i) {
    const auto reading = reference->readT();
    ASSERT_TRUE(reading) << problemOf(reading);
    EXPECT_FALSE(reading->locked);
    EXPECT_FALSE(reading->fieldT);
  }
  expectPlayed(line);
}

TEST(Pt2025, AStatusQueryMayBeAnsweredByAField) {
  auto line = ptAfterSetUp({"> S1", "< N44.914011F\\r\\n", "> S1", "< N44.914011F\\r\\n", "> S1", "< S03\\r\\n"});
  SteppingClock clock;
  Pt2025 nmr(line, clock, {});
  const auto prepared = nmr.prepare();
  EXPECT_TRUE(prepared) << problemOf(prepared);
  expectPlayed(line);
}

TEST(Pt2025, WhatItReportsIsTold) {
  SteppingClock clock;
  auto broken = ptAfterSetUp({"> S1", "< S08\\r\\n"});
  EXPECT_THAT(problemOf(Pt2025(broken, clock, {}).prepare()), HasSubstr("hardware error"));
  auto confused = ptAfterSetUp({"> S1", "< S04\\r\\n"});
  EXPECT_THAT(problemOf(Pt2025(confused, clock, {}).prepare()), HasSubstr("did not understand"));
  auto other = ptAfterSetUp({"> S1", "< +0,\"No error\"\\r\\n"});
  EXPECT_THAT(problemOf(Pt2025(other, clock, {}).prepare()), HasSubstr("'S1'"));
}

TEST(Pt2025, MegahertzAreNotTakenForTesla) {
  auto line = ptAfterSetUp({"> S1",
                            "< S03\\r\\n",
                            "> \\x05",
                            "< L44.914011F\\r\\n",
                            "> D1",
                            "> \\x05",
                            "< L1.0536470T\\r\\n",
                            "> \\x05",
                            "< L44.914011F\\r\\n",
                            "> D1",
                            "> \\x05",
                            "< L44.914011F\\r\\n",
                            "> \\x05",
                            "< L1.05",
                            "!< timed-out",
                            "x",
                            "> \\x05",
                            "< 36470T\\r\\n",
                            "x",
                            "> \\x05",
                            "< L1.0536470T\\r\\n"});
  SteppingClock clock;
  Pt2025 nmr(line, clock, {});
  ASSERT_TRUE(nmr.prepare());
  EXPECT_DOUBLE_EQ(nmr.readT().value().fieldT.value(), 1.053647);
  EXPECT_THAT(problemOf(nmr.readT()), HasSubstr("shows MHz"));
  EXPECT_THAT(problemOf(nmr.readT()), HasSubstr("nothing came"));
  EXPECT_THAT(problemOf(nmr.readT()), HasSubstr("'36470T'")) << "half a reading is none";
  EXPECT_DOUBLE_EQ(nmr.readT().value().fieldT.value(), 1.053647);
  expectPlayed(line);
}

TEST(Pt2025, TheSearchNeedsItsStart) {
  auto line = script({"x", "> R", "> D1", "> PC", "> F0", "> A0", "> V1", "> H0120\\r\\n", "> S1", "< S03\\r\\n"});
  SteppingClock clock;
  auto made = Pt2025::make(line, clock,
                           {{"probe", "C"},
                            {"mode", "manual"},
                            {"field_sense", "negative"},
                            {"coarse", "120"},
                            {"search", "yes"},
                            {"display", "fast"}});
  ASSERT_TRUE(made) << problemOf(made);
  const auto prepared = (*made)->prepare();
  EXPECT_TRUE(prepared) << problemOf(prepared);
  expectPlayed(line);
  EXPECT_THAT(problemOf(Pt2025::make(line, clock, {{"search", "yes"}})), HasSubstr("search"));
}

TEST(Dtm151Reply, NumbersAndErrors) {
  EXPECT_DOUBLE_EQ(parseDtm151Number(" 1.2345T\r")->value, 1.2345);
  EXPECT_EQ(parseDtm151Number(" 1.2345T\r")->unit, "T");
  EXPECT_DOUBLE_EQ(parseDtm151Number(" -3.4E-02")->value, -0.034);
  EXPECT_EQ(parseDtm151Number(" 0.5 kG")->unit, "kG");
  EXPECT_EQ(parseDtm151Number(" OVER RANGE\r").error(), "OVER RANGE");
  EXPECT_EQ(parseDtm151Number(" NO TEMPERATURE PROBE\r").error(), "NO TEMPERATURE PROBE");
  for (const char* bad : {"", " ", "T", "nan", "infT", "1.2X", "1.2 3T", "hello"}) {
    const auto number = parseDtm151Number(bad);
    ASSERT_FALSE(number) << bad;
    EXPECT_EQ(number.error(), "") << bad;
  }
}

const std::vector<std::string> dtmSetUp = {"> SE0\\r", "> SM0\\r", "x",       "> SU1\\r",   "> GD\\r", "> GC\\r",
                                           "> R2\\r",  "> D1\\r",  "> IR\\r", "< \\n 2\\r", "> IG\\r", "< \\x20DC\\r"};

ReplayTransport dtmAfterSetUp(const std::vector<std::string>& more) { return script(dtmSetUp, false, more); }

TEST(Dtm151, ReadsWithSignAndUnit) {
  auto line = dtmAfterSetUp({"> F\\r", "<  1.2345T\\r", "> F\\r", "<  -250G\\r", "> F\\r", "<  OVER RANGE\\r", "> F\\r",
                             "<  1.2345\\r", "x", "> F\\r", "<  NO PROBE\\r", "> T\\r", "<  23.5C\\r", "> T\\r",
                             "<  NO TEMPERATURE PROBE\\r"});
  SteppingClock clock;
  auto made = Dtm151::make(line, clock, {{"range", "1.2"}});
  ASSERT_TRUE(made) << problemOf(made);
  const auto prepared = (*made)->prepare();
  ASSERT_TRUE(prepared) << problemOf(prepared);
  FieldReference* reference = (*made)->fieldReference();
  EXPECT_TRUE(reference->knowsSign());
  EXPECT_DOUBLE_EQ(reference->readT().value().fieldT.value(), 1.2345);
  EXPECT_DOUBLE_EQ(reference->readT().value().fieldT.value(), -0.025);
  const auto over = reference->readT();
  ASSERT_TRUE(over);
  EXPECT_FALSE(over->locked);
  EXPECT_FALSE(over->fieldT);
  EXPECT_THAT(problemOf(reference->readT()), HasSubstr("T, G or kG")) << "gauss or tesla: a factor of 10,000";
  EXPECT_THAT(problemOf(reference->readT()), HasSubstr("NO PROBE"));
  EXPECT_DOUBLE_EQ((*made)->thermometer()->readC().value().value, 23.5);
  EXPECT_THAT(problemOf((*made)->thermometer()->readC()), HasSubstr("NO TEMPERATURE PROBE"));
  expectPlayed(line);
}

TEST(Dtm151, ASetterThatFailedIsNoticed) {
  auto line = script({"> SE0\\r", "> SM0\\r", "x", "> SU1\\r", "> GD\\r", "> GC\\r", "> R3\\r", "> D1\\r", "> IR\\r",
                      "<  FIXED RANGE PROBE\\r"});
  SteppingClock clock;
  Dtm151 meter(line, clock, {});
  EXPECT_THAT(problemOf(meter.prepare()), HasSubstr("FIXED RANGE PROBE"));
}

} // namespace
} // namespace straightedge::devices
