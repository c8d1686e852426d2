// An emulated USBTMC instrument, plugged in and opened through the real libusb.
#pragma once

#include "devices/transport/usbtmc_transport.h"
#include "devices/usb/usb_handle.h"
#include "tests/fakes/usb/emulated_usb.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <gmock/gmock.h>

namespace straightedge::devices {

inline constexpr Milliseconds generous = std::chrono::seconds(60); ///< for what has to come
inline constexpr Milliseconds tiny = Milliseconds(15);             ///< for what must not come

class UsbTmcBench : public testing::Test {
protected:
  /// Plugs the instrument in; a query "ECHO? x" is answered by x, "LONG? n" by n bytes of a pattern.
  void plugIn(fakes::UsbTmcDevice::Options options = {}) {
    m_device = std::make_shared<fakes::UsbTmcDevice>(std::move(options));
    m_device->onMessage(answer);
    m_plug = m_bus.plug(m_device);
  }

  void open(UsbTmcOptions options = {}) {
    options.recoveryTime = generous; // a busy machine must not make a recovery fail
    const auto found = listUsbDevices();
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 1U);
    const auto& device = found->front();
    const auto* interface = UsbTmcTransport::interfaceOf(device);
    ASSERT_NE(interface, nullptr);
    auto handle = UsbHandle::open(device, {interface->number});
    ASSERT_TRUE(handle) << handle.error().error.message();
    UsbTmcChannel channel{.interfaceNumber = interface->number,
                          .out = *interface->find(UsbEndpointType::Bulk, false),
                          .in = *interface->find(UsbEndpointType::Bulk, true),
                          .interrupt = std::nullopt};
    if (const auto* interrupt = interface->find(UsbEndpointType::Interrupt, true)) {
      channel.interrupt = *interrupt;
    }
    auto started = UsbTmcTransport::start(std::move(*handle), "meter", channel, options);
    ASSERT_TRUE(started) << started.error().error.message();
    m_transport = std::move(*started);
  }

  void plugInAndOpen(fakes::UsbTmcDevice::Options options = {}, UsbTmcOptions ours = {}) {
    plugIn(std::move(options));
    open(ours);
  }

  void TearDown() override {
    m_transport.reset();
    if (m_device) {
      EXPECT_THAT(m_device->violations(), testing::IsEmpty());
    }
  }

  TransportResult<std::string> query(const std::string& text, Milliseconds readTime = generous) {
    if (auto sent = m_transport->write(text + "\n", generous); !sent) {
      return std::unexpected(sent.error());
    }
    return m_transport->read(readTime);
  }

  /// What every fault has to end with: the connection is as good as new.
  void expectNextQueryWorks() {
    const auto reply = query("ECHO? next");
    ASSERT_TRUE(reply) << reply.error().error.message();
    EXPECT_EQ(*reply, "next\n");
    const auto another = query("ECHO? another");
    ASSERT_TRUE(another) << another.error().error.message();
    EXPECT_EQ(*another, "another\n");
  }

  void expectFault(const TransportResult<std::string>& result, TransportFault fault) {
    ASSERT_FALSE(result) << "answered: " << *result;
    EXPECT_EQ(result.error().fault, fault) << result.error().error.message();
    EXPECT_EQ(result.error().error.kind, ErrorKind::Instrument);
    EXPECT_FALSE(result.error().error.what.empty());
    EXPECT_FALSE(result.error().error.remedy.empty());
    EXPECT_THAT(result.error().error.where, testing::HasSubstr("meter"));
  }

  static std::string pattern(std::size_t size) {
    std::string text(size, '\0');
    for (std::size_t i = 0; i < size; ++i) {
      text[i] = static_cast<char>('!' + i * 7 % 90);
    }
    return text;
  }

  static std::optional<std::string> answer(const std::string& message) {
    if (message.starts_with("ECHO? ")) {
      return message.substr(6);
    }
    if (message.starts_with("LONG? ")) {
      return pattern(std::stoul(message.substr(6)));
    }
    if (message == "*IDN?") {
      return "Metrolab Technology SA,THM1176-MF,0123456,el-B0-gl-B0-mf-B0";
    }
    return std::nullopt;
  }

  fakes::EmulatedUsb m_bus;
  std::shared_ptr<fakes::UsbTmcDevice> m_device;
  fakes::EmulatedUsb::Plug m_plug = 0;
  std::unique_ptr<UsbTmcTransport> m_transport;
};

} // namespace straightedge::devices
