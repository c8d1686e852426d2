// The real straightedge-cli on emulated instruments.
#include "tests/app/cli/child_process.h"
#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace straightedge::fakes {
namespace {

using straightedge::testing::runCli;
using ::testing::HasSubstr;

TEST(DevicesCommand, ListsWhatIsPluggedInWithItsUse) {
  EmulatedUsb bus;
  const auto said = runCli({"devices", "--json"});
  ASSERT_EQ(said.code, 0) << said.err;
  const auto before = nlohmann::json::parse(said.out).size(); // ports of this machine
  bus.plug(std::make_shared<UsbTmcDevice>());
  bus.plug(std::make_shared<FtdiDevice>(), {.heldByAnotherProgram = true});
  const auto list = nlohmann::json::parse(runCli({"devices", "--json"}).out);
  ASSERT_EQ(list.size(), before + 2);
  EXPECT_EQ(list[0].at("vendor_id"), "1bfa");
  EXPECT_EQ(list[0].at("product_id"), "0498");
  EXPECT_EQ(list[0].at("serial"), "0123456");
  EXPECT_EQ(list[0].at("name"), "Metrolab Technology SA THM1176");
  EXPECT_EQ(list[0].at("instrument"), "metrolab-thm1176");
  EXPECT_EQ(list[0].at("roles"), nlohmann::json::array({"field-probe"}));
  EXPECT_TRUE(list[0].at("problem").is_null());
  EXPECT_TRUE(list[0].at("remedy").is_null());
  EXPECT_TRUE(list[1].at("instrument").is_null());
  EXPECT_THAT(list[1].at("problem").get<std::string>(), HasSubstr("another program"));
  EXPECT_THAT(list[1].at("remedy").get<std::string>(), HasSubstr("close the program"));
  const auto table = runCli({"devices"});
  EXPECT_EQ(table.code, 0);
  EXPECT_THAT(table.out, HasSubstr("metrolab-thm1176"));
  EXPECT_THAT(table.out, HasSubstr("cannot be opened"));
}

TEST(DevicesCommand, NothingPluggedInIsSaidAndIsNoError) {
  const EmulatedUsb bus;
  const auto said = runCli({"devices"});
  EXPECT_EQ(said.code, 0) << said.err;
  if (nlohmann::json::parse(runCli({"devices", "--json"}).out).empty()) { // this machine has no serial port
    EXPECT_THAT(said.out, HasSubstr("Nothing is plugged in"));
    EXPECT_THAT(said.out, HasSubstr("--bench simulated"));
  }
}

} // namespace
} // namespace straightedge::fakes
