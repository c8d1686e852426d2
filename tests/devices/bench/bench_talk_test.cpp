// An opened bench as a window uses it: a live reading of each role, and commands of a person in between.
#include "devices/bench/opened_bench.h"
#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"
#include "tests/fakes/usb/thm1176.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <gmock/gmock.h>

namespace straightedge::fakes {
namespace {

using devices::InstrumentRole;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

devices::BenchInstrument instrument(const std::string& id, InstrumentRole role, const std::string& serial) {
  devices::BenchInstrument one;
  one.instrument = id;
  one.roles = {role};
  one.serial = serial;
  return one;
}

std::shared_ptr<UsbTmcDevice> talkingTeslameter() {
  auto device = std::make_shared<UsbTmcDevice>();
  device->onMessage(thm1176Answers());
  return device;
}

std::shared_ptr<CdcAcmDevice> printingBoard() {
  auto device = std::make_shared<CdcAcmDevice>();
  device->generate([next = std::chrono::steady_clock::now()]() mutable -> std::string {
    const auto now = std::chrono::steady_clock::now();
    if (now < next) {
      return {};
    }
    next = now + std::chrono::milliseconds(2);
    return "45.25\r\n";
  });
  return device;
}

std::unique_ptr<devices::OpenedBench> opened(const std::vector<devices::BenchInstrument>& instruments) {
  auto bench = devices::OpenedBench::open({.name = "desk", .instruments = instruments}, {});
  EXPECT_TRUE(bench) << bench.error().message();
  return bench ? *std::move(bench) : nullptr;
}

TEST(BenchTalk, EachRoleIsReadInItsUnit) {
  EmulatedUsb bus;
  bus.plug(talkingTeslameter());
  bus.plug(printingBoard());
  const auto bench = opened({instrument("metrolab-thm1176", InstrumentRole::FieldProbe, "0123456"),
                             instrument("ascii-board", InstrumentRole::AngleSensor, "ACM-1")});
  ASSERT_NE(bench, nullptr);
  const auto field = bench->readRole(InstrumentRole::FieldProbe);
  ASSERT_TRUE(field) << field.error().message();
  EXPECT_THAT(field->values, ElementsAre(0.25, -0.5, 1.0));
  const auto angle = bench->readRole(InstrumentRole::AngleSensor);
  ASSERT_TRUE(angle) << angle.error().message();
  EXPECT_THAT(angle->values, ElementsAre(45.25));
  const auto none = bench->readRole(InstrumentRole::FieldReference);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().what, "no instrument of the bench fills the role field-reference");
}

TEST(BenchTalk, ARoleThatTheSettingsDoNotGiveIsSaid) {
  EmulatedUsb bus;
  bus.plug(printingBoard());
  devices::BenchInstrument board = instrument("ascii-board", InstrumentRole::AngleSensor, "ACM-1");
  board.roles.push_back(InstrumentRole::Temperature); // and no column for it
  const auto bench = opened({board});
  ASSERT_NE(bench, nullptr);
  const auto temperature = bench->readRole(InstrumentRole::Temperature);
  ASSERT_FALSE(temperature);
  EXPECT_EQ(temperature.error().what, "ascii-board does not fill the role temperature with its settings");
}

TEST(BenchTalk, ACommandIsAnsweredAndReadingsGoOn) {
  EmulatedUsb bus;
  const auto meter = talkingTeslameter();
  const auto plug = bus.plug(meter);
  const auto bench = opened({instrument("metrolab-thm1176", InstrumentRole::FieldProbe, "0123456")});
  ASSERT_NE(bench, nullptr);
  EXPECT_EQ(bench->instrumentName(0), "Metrolab THM1176 / TFM1186 three-axis teslameter, serial 0123456");
  EXPECT_EQ(bench->say(0, "*IDN?\n"), "Metrolab Technology SA,THM1176-MF,0123456,el-A1-K1\n");
  EXPECT_EQ(bench->say(0, "*CLS\n"), ""); // not a query: nothing is asked for
  EXPECT_TRUE(bench->readRole(InstrumentRole::FieldProbe));
  EXPECT_THAT(meter->violations(), IsEmpty());
  bus.unplug(plug);
  const auto gone = bench->say(0, "*IDN?\n");
  ASSERT_FALSE(gone);
  EXPECT_THAT(gone.error().message(), HasSubstr("0123456"));
  EXPECT_EQ(bench->restore(), false);
}

TEST(BenchTalk, AnAnswerOnALineEndsWithItsLine) {
  EmulatedUsb bus;
  auto device = std::make_shared<FtdiDevice>();
  device->onLine("\r\n", [](const std::string& line) -> std::string {
    const std::string kind = line.starts_with('W') ? "w " : "r ";
    return line == "silence"
               ? ""
               : kind + line.substr(1, 2) + (line == "R14" ? " 12345009" : " 00000000") + " 00000001 !\r\n";
  });
  bus.plug(device);
  devices::BenchInstrument encoder = instrument("usdigital-qsb", InstrumentRole::AngleReference, "FT-1");
  encoder.settings["counts_per_turn"] = "3600";
  const auto bench = opened({encoder});
  ASSERT_NE(bench, nullptr);
  EXPECT_EQ(bench->say(0, "R14\r\n"), "r 14 12345009 00000001 !\r\n");
  EXPECT_EQ(bench->say(0, "silence\r\n"), ""); // no answer is no error
  const auto angle = bench->readRole(InstrumentRole::AngleReference);
  ASSERT_TRUE(angle) << angle.error().message();
  EXPECT_THAT(angle->values, ElementsAre(0.0));
}

} // namespace
} // namespace straightedge::fakes
