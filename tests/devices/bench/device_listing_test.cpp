// What is plugged in, matched with what is known; and the udev rules against the same table.
#include "devices/bench/device_listing.h"
#include "tests/core/base/temporary_folder.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace straightedge::devices {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

bool everything(const std::string& /*path*/) { return true; }
bool nothing(const std::string& /*path*/) { return false; }

UsbDevice meter() {
  return {.vendorId = 0x1bfa, .productId = 0x0498, .manufacturer = "Metrolab", .product = "THM1176", .serial = "0123"};
}

UsbDevice multimeter() {
  UsbDevice device{.vendorId = 0x2a8d, .productId = 0x1301, .manufacturer = "Keysight", .product = "34461A"};
  device.interfaces.push_back({.classCode = 0xFE,
                               .subclass = 3,
                               .protocol = 1,
                               .endpoints = {{0x01, UsbEndpointType::Bulk, 512}, {0x82, UsbEndpointType::Bulk, 512}}});
  return device;
}

std::vector<ListedDevice> matched(const std::vector<UsbDevice>& usb, const std::vector<SerialPortInfo>& ports = {}) {
  return matchDevices(usb, ports, readProfiles(""), everything);
}

TEST(DeviceListing, OwnIdsNameTheInstrument) {
  const auto list = matched({meter()});
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].instrument, "metrolab-thm1176");
  EXPECT_EQ(list[0].serial, "0123");
  EXPECT_EQ(list[0].name, "Metrolab THM1176");
  EXPECT_THAT(list[0].roles, ElementsAre(InstrumentRole::FieldProbe));
  EXPECT_THAT(list[0].candidates, IsEmpty());
}

TEST(DeviceListing, AModelInTheUsbNameIsEnoughOnUsbtmc) {
  EXPECT_EQ(matched({multimeter()})[0].instrument, "scpi-multimeter");
  auto other = multimeter();
  other.product = "Another meter";
  const auto list = matched({other});
  EXPECT_EQ(list[0].instrument, "");
  EXPECT_THAT(list[0].candidates, Contains("scpi-multimeter"));
}

TEST(DeviceListing, BehindAnAdapterNothingIsClaimed) {
  const SerialPortInfo port{"/dev/ttyUSB0", "FT232R", 0x0403, 0x6001, "FT-1", "FT232R"};
  const auto list = matched({{.vendorId = 0x0403, .productId = 0x6001, .serial = "FT-1"}}, {port});
  ASSERT_EQ(list.size(), 1U) << "device and tty are one";
  EXPECT_EQ(list[0].instrument, "");
  EXPECT_THAT(list[0].candidates, Contains("usdigital-qsb"));
  EXPECT_THAT(list[0].roles, Contains(InstrumentRole::AngleReference));
  ASSERT_TRUE(list[0].port);
  EXPECT_EQ(list[0].port->path, "/dev/ttyUSB0");
}

TEST(DeviceListing, APortWithoutUsbCanHaveAnyInstrumentWithoutIds) {
  const auto list = matched({}, {{"/dev/ttyS0", "ttyS0", {}, {}, "", ""}});
  ASSERT_EQ(list.size(), 1U);
  EXPECT_FALSE(list[0].ids);
  EXPECT_THAT(list[0].candidates, Contains("metrolab-pt2025"));
  EXPECT_THAT(list[0].candidates, ::testing::Not(Contains("usdigital-qsb")));
}

TEST(DeviceListing, TheTtysRightsCountBesideTheUsbNodes) {
  UsbDevice denied{.vendorId = 0x0403, .productId = 0x6001, .serial = "FT-1"};
  denied.problem = "access to the USB device is denied";
  denied.remedy = "run: installer/run --udev, then plug the device in again";
  const SerialPortInfo port{"/dev/ttyUSB0", "FT232R", 0x0403, 0x6001, "FT-1", ""};
  EXPECT_EQ(matchDevices({denied}, {port}, {}, everything)[0].problem, "");
  EXPECT_THAT(matchDevices({denied}, {port}, {}, nothing)[0].remedy, HasSubstr("installer/run --udev"));
  const auto alone = matchDevices({}, {{"/dev/ttyS0", "", {}, {}, "", ""}}, {}, nothing);
  EXPECT_THAT(alone[0].problem, HasSubstr("/dev/ttyS0"));
  EXPECT_THAT(alone[0].remedy, HasSubstr("dialout"));
}

TEST(DeviceListing, OtherDevicesAreListedWithoutUse) {
  const auto list = matched({{.vendorId = 0x046d, .productId = 0xc31c, .product = "Keyboard"}});
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].instrument, "");
  EXPECT_THAT(list[0].roles, IsEmpty());
  EXPECT_THAT(list[0].candidates, IsEmpty());
}

std::string rulesText() {
  std::ifstream file(STRAIGHTEDGE_TEST_DATA "/../../installer/linux/70-straightedge.rules", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(UdevRules, NameEveryUsbIdOfTheInstrumentTable) {
  const std::string rules = rulesText();
  ASSERT_THAT(rules, HasSubstr("uaccess"));
  for (const KnownInstrument& known : knownInstruments()) {
    for (const UsbIds& ids : known.usb) {
      EXPECT_THAT(rules, HasSubstr("ATTR{idVendor}==\"" + hexId(ids.vendor) + "\", ATTR{idProduct}==\"" +
                                   hexId(ids.product) + "\", TAG+=\"uaccess\""))
          << known.id;
      EXPECT_THAT(rules, HasSubstr("# " + std::string(known.id)));
    }
  }
  EXPECT_THAT(rules, HasSubstr("*:fe03??:*")); // USBTMC
}

TEST(UdevRules, AreInstalledByTheCommandThatTheRemediesName) {
  const straightedge::testing::TemporaryFolder folder;
  const std::string command = "DESTDIR=" + folder.path() +
                              " bash " STRAIGHTEDGE_TEST_DATA "/../../installer/run --udev > " + folder.file("said");
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(folder.read("etc/udev/rules.d/70-straightedge.rules"), rulesText());
  EXPECT_THAT(folder.read("said"), HasSubstr("70-straightedge.rules"));
}

} // namespace
} // namespace straightedge::devices
