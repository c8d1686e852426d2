// CDC-ACM boards and FTDI adapters through the real libusb on an emulated bus.
#include "devices/transport/usb_serial_transport.h"
#include "tests/fakes/usb/byte_stream_devices.h"
#include "tests/fakes/usb/emulated_usb.h"

#include <gmock/gmock.h>

#include <thread>

namespace straightedge::devices {
namespace {

using fakes::ByteStreamDevice;
using fakes::CdcAcmDevice;
using fakes::EmulatedUsb;
using fakes::FtdiDevice;
using fakes::LineState;
using testing::HasSubstr;

constexpr Milliseconds generous = std::chrono::seconds(60); ///< for what has to come
constexpr Milliseconds tiny(15);                            ///< for what must not come

std::string pattern(std::size_t size) {
  std::string text(size, '\0');
  for (std::size_t i = 0; i < size; ++i) {
    text[i] = static_cast<char>(i * 31 % 256);
  }
  return text;
}

enum class Kind { CdcAcm, Ftdi };

std::shared_ptr<ByteStreamDevice> make(Kind kind) {
  if (kind == Kind::CdcAcm) {
    return std::make_shared<CdcAcmDevice>();
  }
  return std::make_shared<FtdiDevice>();
}

class UsbSerial : public testing::TestWithParam<Kind> {
protected:
  void plugIn() {
    m_device = make(GetParam());
    m_driver = GetParam() == Kind::CdcAcm ? "cdc_acm" : "ftdi_sio";
    m_plug = m_bus.plug(m_device, {.driver = m_driver});
  }
  void open(const SerialSettings& settings = {}) {
    const auto found = listUsbDevices();
    ASSERT_TRUE(found);
    ASSERT_FALSE(found->empty());
    ASSERT_TRUE(UsbSerialTransport::canOpen(found->back()));
    auto opened = UsbSerialTransport::open(found->back(), settings);
    ASSERT_TRUE(opened) << opened.error().error.message();
    m_line = std::move(*opened);
  }
  void answerLines() {
    m_device->onLine("\n", [](const std::string& line) { return line + " heard\r\n"; });
  }
  void expectTheNextQueryIsAnswered() {
    answerLines();
    ASSERT_TRUE(m_line->write("next\n", generous));
    const auto reply = m_line->readUntil("\r\n", generous);
    ASSERT_TRUE(reply) << reply.error().error.message();
    EXPECT_EQ(*reply, "next heard\r\n");
  }
  std::string readBytes(std::size_t count) {
    std::string all;
    while (all.size() < count) {
      const auto some = m_line->read(generous);
      if (!some) {
        ADD_FAILURE() << some.error().error.message();
        break;
      }
      EXPECT_FALSE(some->empty());
      all += *some;
    }
    return all;
  }
  template <typename T>
  void expectFault(const TransportResult<T>& result, TransportFault fault) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, fault) << result.error().error.message();
    EXPECT_FALSE(result.error().error.remedy.empty());
    EXPECT_THAT(result.error().error.where, HasSubstr("USB serial "));
  }

  EmulatedUsb m_bus;
  std::shared_ptr<ByteStreamDevice> m_device;
  std::string m_driver;
  EmulatedUsb::Plug m_plug = 0;
  std::unique_ptr<UsbSerialTransport> m_line;
};

TEST_P(UsbSerial, AsksAndIsAnsweredManyTimes) {
  plugIn();
  open();
  answerLines();
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(m_line->write(std::to_string(i) + "\n", generous));
    ASSERT_EQ(m_line->readUntil("\r\n", generous).value(), std::to_string(i) + " heard\r\n");
  }
}

TEST_P(UsbSerial, TheKernelsDriverIsDetachedAndGivenBack) {
  plugIn();
  open();
  EXPECT_EQ(m_bus.driver(m_plug, 0), "usbfs");
  m_line.reset();
  EXPECT_EQ(m_bus.driver(m_plug, 0), m_driver);
  EXPECT_EQ(m_bus.driver(m_plug, GetParam() == Kind::CdcAcm ? 1 : 0), m_driver);
}

TEST_P(UsbSerial, SettingsReachTheLine) {
  const std::vector<SerialSettings> all = {
      {.baud = 9600},
      {.baud = 19200, .dataBits = 8, .stopBits = 2},
      {.baud = 57600, .dataBits = 7, .parity = Parity::Odd},
      {.baud = 115200, .dataBits = 7, .parity = Parity::Even, .dtr = false},
      {.baud = 230400, .rts = false},
      {.baud = 1'000'000},
  };
  plugIn();
  for (const auto& settings : all) {
    open(settings);
    const auto line = m_device->line();
    EXPECT_NEAR(line.baud, settings.baud, 0.002 * settings.baud);
    EXPECT_EQ(line.dataBits, settings.dataBits);
    EXPECT_EQ(line.stopBits, settings.stopBits);
    EXPECT_EQ(line.parity, settings.parity == Parity::None ? 'N' : (settings.parity == Parity::Odd ? 'O' : 'E'));
    EXPECT_EQ(line.dtr, settings.dtr);
    EXPECT_EQ(line.rts, settings.rts);
    m_line.reset();
  }
}

TEST_P(UsbSerial, ControlLinesGoDownAndUp) {
  plugIn();
  open();
  ASSERT_TRUE(m_line->setControlLines(false, true));
  EXPECT_FALSE(m_device->line().dtr);
  EXPECT_TRUE(m_device->line().rts);
  ASSERT_TRUE(m_line->setControlLines(true, false));
  EXPECT_TRUE(m_device->line().dtr);
  EXPECT_FALSE(m_device->line().rts);
}

TEST_P(UsbSerial, WhatABoardSaysWhenItIsOpenedIsNotLost) {
  plugIn();
  m_device->onLineState(
      [](const LineState& before, const LineState& now) { return !before.dtr && now.dtr ? "QSB-D  0E!\r\n" : ""; });
  open();
  EXPECT_EQ(m_line->readUntil("\r\n", generous).value(), "QSB-D  0E!\r\n");
}

TEST_P(UsbSerial, EveryLengthAroundThePacketComesWhole) {
  plugIn();
  open();
  for (std::size_t size = 1; size < 200; ++size) {
    m_device->push(pattern(size));
    ASSERT_EQ(readBytes(size), pattern(size)) << size;
  }
}

TEST_P(UsbSerial, AHundredThousandBytesEachWay) {
  plugIn();
  open();
  const auto bytes = pattern(100'000);
  m_device->push(bytes);
  EXPECT_EQ(readBytes(bytes.size()), bytes);
  ASSERT_TRUE(m_line->write(bytes, generous));
  EXPECT_EQ(m_device->received(), bytes);
}

TEST_P(UsbSerial, AStreamOfLinesIsWhole) {
  plugIn();
  open();
  int next = 0;
  m_device->generate([&next] { // a few lines at every poll, at its own pace
    std::string lines;
    for (int i = 0; i < 7 && next < 5000; ++i) {
      lines += std::to_string(next++) + "\t12.5\n";
    }
    return lines;
  });
  for (int i = 0; i < 5000; ++i) {
    const auto line = m_line->readUntil("\n", generous);
    ASSERT_TRUE(line) << i << ": " << line.error().error.message();
    ASSERT_EQ(*line, std::to_string(i) + "\t12.5\n");
  }
}

TEST_P(UsbSerial, ABoardThatIsFasterThanTheProgramKeepsItsBytes) {
  plugIn();
  open();
  int next = 0;
  m_device->generate([&next] { return std::to_string(next++) + "\n"; }); // always more, however quickly it is asked
  for (int i = 0; i < 1000; ++i) {
    const auto line = m_line->readUntil("\n", generous);
    ASSERT_TRUE(line) << i << ": " << line.error().error.message();
    ASSERT_EQ(*line, std::to_string(i) + "\n");
  }
  const auto held = m_device->lock();
  EXPECT_LT(next, 1000 + 500) << "no more is taken than is kept here";
}

TEST_P(UsbSerial, WhileAWriteWaitsNoMoreIsTakenThanIsKept) {
  plugIn();
  open();
  int next = 0;
  m_device->generate([&next] { return std::to_string(next++) + "\n"; });
  m_device->holdWrites(true);
  const auto printed = [&] {
    const auto held = m_device->lock();
    return next;
  };
  int before = -1;
  for (int i = 0; i < 500 && before != printed(); ++i) { // until it takes no more
    before = printed();
    expectFault(m_line->write("stuck\n", tiny), TransportFault::TimedOut);
  }
  EXPECT_EQ(before, printed());
  EXPECT_LT(before, 500);
  EXPECT_EQ(m_line->readUntil("\n", generous).value(), "0\n");
}

TEST_P(UsbSerial, ATimeOutKeepsTheLineThatHasBegun) {
  plugIn();
  open();
  m_device->push("12.3");
  expectFault(m_line->readUntil("\n", tiny), TransportFault::TimedOut);
  m_device->push("45\n");
  EXPECT_EQ(m_line->readUntil("\n", generous).value(), "12.345\n");
  expectFault(m_line->read(tiny), TransportFault::TimedOut);
  expectTheNextQueryIsAnswered();
}

TEST_P(UsbSerial, ClearDropsWhatWasNotRead) {
  plugIn();
  open();
  m_device->push("old one\nold two\n");
  ASSERT_EQ(m_line->readUntil("\n", generous).value(), "old one\n");
  ASSERT_TRUE(m_line->clear());
  expectFault(m_line->read(tiny), TransportFault::TimedOut);
  expectTheNextQueryIsAnswered();
}

TEST_P(UsbSerial, AStalledReadIsToldAndTheNextWorks) {
  plugIn();
  open();
  m_device->stallNextRead();
  expectFault(m_line->read(generous), TransportFault::Stalled);
  expectTheNextQueryIsAnswered();
}

TEST_P(UsbSerial, AStalledWriteIsToldAndTheNextWorks) {
  plugIn();
  open();
  m_device->stallNextWrite();
  expectFault(m_line->write("lost\n", generous), TransportFault::Stalled);
  expectTheNextQueryIsAnswered();
}

TEST_P(UsbSerial, ALineThatTakesNothingTimesOutAndSaysHowMuchIsLeft) {
  plugIn();
  open();
  m_device->holdWrites(true);
  const auto sent = m_line->write("stuck\n", tiny);
  expectFault(sent, TransportFault::TimedOut);
  EXPECT_THAT(sent.error().error.what, HasSubstr("6 are left"));
  m_device->holdWrites(false);
  expectTheNextQueryIsAnswered();
}

TEST_P(UsbSerial, UnpluggedInTheMiddleEveryByteBeforeIsHandedOut) {
  plugIn();
  open();
  m_device->unplugAfter(321);
  m_device->push(pattern(500));
  EXPECT_EQ(readBytes(321), pattern(321));
  expectFault(m_line->read(generous), TransportFault::Gone);
  expectFault(m_line->write("anyone\n", generous), TransportFault::Gone);
  expectFault(m_line->clear(), TransportFault::Gone);
  m_line.reset();
  plugIn();
  open();
  expectTheNextQueryIsAnswered();
}

TEST_P(UsbSerial, UnpluggedWhileAReadWaits) {
  plugIn();
  open();
  const std::jthread puller([&] { m_bus.unplug(m_plug); });
  expectFault(m_line->read(generous), TransportFault::Gone);
}

TEST_P(UsbSerial, SettingsThatItCannotDoAreRefused) {
  plugIn();
  const auto device = listUsbDevices()->back();
  const SerialSettings settings =
      GetParam() == Kind::Ftdi ? SerialSettings{.baud = 2'700'000} : SerialSettings{.flow = FlowControl::RtsCts};
  const auto refused = UsbSerialTransport::open(device, settings);
  expectFault(refused, TransportFault::Unsupported);
  EXPECT_THAT(refused.error().error.what, HasSubstr(GetParam() == Kind::Ftdi ? "2700000 baud" : "flow control"));
}

INSTANTIATE_TEST_SUITE_P(All, UsbSerial, testing::Values(Kind::CdcAcm, Kind::Ftdi),
                         [](const auto& test) { return test.param == Kind::CdcAcm ? "CdcAcm" : "Ftdi"; });

class Ftdi : public testing::Test {
protected:
  void SetUp() override {
    m_device = std::make_shared<FtdiDevice>();
    m_bus.plug(m_device);
    auto opened = UsbSerialTransport::open(listUsbDevices()->at(0), m_settings);
    ASSERT_TRUE(opened);
    m_line = std::move(*opened);
  }
  EmulatedUsb m_bus;
  SerialSettings m_settings{.flow = FlowControl::RtsCts};
  std::shared_ptr<FtdiDevice> m_device;
  std::unique_ptr<UsbSerialTransport> m_line;
};

TEST_F(Ftdi, IsResetSetToShortLatencyAndToFlowControl) {
  EXPECT_EQ(m_device->resetsOfChip(), 1);
  EXPECT_EQ(m_device->latencyMs(), 2);
  EXPECT_EQ(m_device->line().flow, 'R');
  ASSERT_TRUE(m_line->clear());
  EXPECT_EQ(m_device->purges(), 2);
}

TEST_F(Ftdi, LostAndDamagedBytesAreErrorsAndNotReadings) {
  const std::vector<std::tuple<std::uint8_t, TransportFault, std::string>> cases = {
      {std::uint8_t{0x02}, TransportFault::Overflow, "lost bytes"},
      {std::uint8_t{0x04}, TransportFault::Protocol, "parity"},
      {std::uint8_t{0x08}, TransportFault::Protocol, "stop bit"},
  };
  for (const auto& [bits, fault, says] : cases) {
    m_device->setLineErrors(bits);
    const auto spoilt = m_line->read(generous);
    ASSERT_FALSE(spoilt);
    EXPECT_EQ(spoilt.error().fault, fault);
    EXPECT_THAT(spoilt.error().error.what, HasSubstr(says));
    m_device->push("fine\n");
    EXPECT_EQ(m_line->readUntil("\n", generous).value(), "fine\n");
  }
}

TEST(UsbSerialKinds, WhatIsNeitherIsNotTakenForOne) {
  UsbDevice meter{
      .vendorId = 0x1bfa,
      .productId = 0x0498,
      .interfaces = {{.classCode = 0xFE,
                      .subclass = 3,
                      .driver = {},
                      .endpoints = {{.address = 1, .packetSize = 512}, {.address = 0x82, .packetSize = 512}}}}};
  EXPECT_FALSE(UsbSerialTransport::canOpen(meter));
  meter.interfaces[0].classCode = 0xFF;
  EXPECT_FALSE(UsbSerialTransport::canOpen(meter)) << "vendor specific, and not FTDI's";
  meter.vendorId = 0x0403;
  EXPECT_TRUE(UsbSerialTransport::canOpen(meter));
}

} // namespace
} // namespace straightedge::devices
