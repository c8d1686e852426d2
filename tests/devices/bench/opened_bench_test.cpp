// A saved bench opened on emulated instruments: what is said with them is heard, also after a replug.
#include "devices/bench/opened_bench.h"
#include "tests/fakes/usb/emulated_usb.h"
#include "tests/fakes/usb/thm1176.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <gmock/gmock.h>

namespace straightedge::fakes {
namespace {

std::shared_ptr<UsbTmcDevice> teslameter() {
  auto device = std::make_shared<UsbTmcDevice>();
  device->onMessage(thm1176Answers());
  return device;
}

devices::SavedBench teslameterBench() {
  return {.name = "desk",
          .instruments = {{.instrument = "metrolab-thm1176",
                           .roles = {devices::InstrumentRole::FieldProbe},
                           .serial = "0123456",
                           .port = {},
                           .settings = {},
                           .baud = {}}}};
}

TEST(OpenedBench, EveryExchangeIsHeardAlsoAfterAReplug) {
  EmulatedUsb bus;
  auto plug = bus.plug(teslameter());
  std::vector<std::string> replies; // "CONNECTION INSTRUMENT TRANSPORT: BYTES"
  const auto bench =
      devices::OpenedBench::open(teslameterBench(), {}, {}, [&replies](const devices::BenchExchange& heard) {
        if (heard.entry.mark == devices::DialogueMark::Received) {
          replies.push_back(std::to_string(heard.connection) + " " + heard.wanted.serial + " " +
                            heard.transport.name() + ": " + heard.entry.bytes);
        }
      });
  ASSERT_TRUE(bench) << bench.error().message();
  devices::FieldProbe* probe = (*bench)->fieldBench()->probe;
  ASSERT_TRUE(probe->readT());
  const std::string where = " 0123456 USBTMC 1bfa:0498 serial 0123456: ";
  const auto said = [&where](const std::string& connection) {
    return std::vector{connection + where + "Metrolab Technology SA,THM1176-MF,0123456,el-A1-K1\n",
                       connection + where + "0,\"No error\"\n", connection + where + "0.25 T;-0.5 T;1 T;0x0;100;0\n"};
  };
  EXPECT_EQ(replies, said("1"));
  bus.unplug(plug);
  EXPECT_FALSE(probe->readT());
  replies.clear();
  bus.plug(teslameter(), {.port = "7"});
  EXPECT_EQ((*bench)->restore(), true);
  ASSERT_TRUE(probe->readT());
  EXPECT_EQ(replies, said("2"));
}

} // namespace
} // namespace straightedge::fakes
