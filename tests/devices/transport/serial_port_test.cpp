#include "devices/transport/serial_port.h"
#include "tests/devices/transport/pseudo_terminal.h"

#include <gtest/gtest.h>

#include <asm/termbits.h>
#include <sys/ioctl.h>
#include <thread>

namespace straightedge::devices {
namespace {

constexpr Milliseconds patient{5000};
constexpr Milliseconds brief{20};

std::unique_ptr<Transport> opened(const PseudoTerminal& line, const SerialSettings& settings = {}) {
  auto port = openSerialPort(line.path(), settings);
  EXPECT_TRUE(port.has_value()) << (port ? "" : port.error().error.message());
  return port ? *std::move(port) : nullptr;
}

TEST(SerialPort, BytesGoBothWaysUnchanged) {
  PseudoTerminal line;
  const auto port = opened(line);
  ASSERT_TRUE(port);
  EXPECT_EQ(port->name(), line.path());
  EXPECT_FALSE(port->hasMessages());
  // Every byte, control characters that a terminal would act on among them.
  std::string all;
  for (int byte = 0; byte < 256; ++byte) {
    all += static_cast<char>(byte);
  }
  ASSERT_TRUE(port->write(all, patient));
  EXPECT_EQ(line.receive(all.size()), all);
  line.send(all);
  std::string got;
  while (got.size() < all.size()) {
    const auto part = port->read(patient);
    ASSERT_TRUE(part) << part.error().error.message();
    ASSERT_FALSE(part->empty());
    got += *part;
  }
  EXPECT_EQ(got, all);
}

TEST(SerialPort, ReadUntilKeepsTheRest) {
  PseudoTerminal line;
  const auto port = opened(line);
  ASSERT_TRUE(port);
  line.send("N44.914011F\r\nL1.05");
  EXPECT_EQ(port->readUntil("\r\n", patient).value(), "N44.914011F\r\n");
  const auto late = port->readUntil("\r\n", brief);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().fault, TransportFault::TimedOut);
  EXPECT_EQ(late.error().error.kind, ErrorKind::Instrument);
  EXPECT_EQ(late.error().error.where, line.path());
  line.send("36470T\r");
  ASSERT_FALSE(port->readUntil("\r\n", brief));
  line.send("\n");
  EXPECT_EQ(port->readUntil("\r\n", patient).value(), "L1.0536470T\r\n"); // nothing lost, nothing twice
}

TEST(SerialPort, NothingWithinTheDeadlineIsATimeOutAndTheLineGoesOn) {
  PseudoTerminal line;
  const auto port = opened(line);
  ASSERT_TRUE(port);
  for (const Milliseconds deadline : {Milliseconds{0}, brief}) {
    const auto nothing = port->read(deadline);
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().fault, TransportFault::TimedOut);
  }
  line.send("x");
  EXPECT_EQ(port->read(patient).value(), "x");
}

TEST(SerialPort, HangUpIsGoneAfterWhatCameBefore) {
  PseudoTerminal line;
  const auto port = opened(line);
  ASSERT_TRUE(port);
  line.send("last words");
  line.hangUp();
  const auto begun = std::chrono::steady_clock::now();
  const auto rest = port->read(patient);
  // Linux may drop what a closed pseudo terminal had sent; what it keeps must arrive.
  if (rest) {
    EXPECT_EQ(*rest, "last words");
  } else {
    EXPECT_EQ(rest.error().fault, TransportFault::Gone);
  }
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(port->read(patient).error().fault, TransportFault::Gone);
    EXPECT_EQ(port->readUntil("\n", patient).error().fault, TransportFault::Gone);
    EXPECT_EQ(port->write("x", patient).error().fault, TransportFault::Gone);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begun, patient) << "a hang-up was waited for like a time-out";
}

TEST(SerialPort, HangUpWhileWaitingEndsTheWait) {
  PseudoTerminal line;
  const auto port = opened(line);
  ASSERT_TRUE(port);
  std::thread far([&] {
    EXPECT_EQ(line.receive(1), "?"); // the other thread is about to wait
    line.hangUp();
  });
  ASSERT_TRUE(port->write("?", patient));
  EXPECT_EQ(port->readUntil("\n", std::chrono::minutes(4)).error().fault, TransportFault::Gone);
  far.join();
}

TEST(SerialPort, ClearThrowsAwayWhatWaits) {
  PseudoTerminal line;
  const auto port = opened(line);
  ASSERT_TRUE(port);
  line.send("first\nstale");
  EXPECT_EQ(port->readUntil("\n", patient).value(), "first\n");
  ASSERT_TRUE(port->clear());
  line.send("fresh\n");
  EXPECT_EQ(port->readUntil("\n", patient).value(), "fresh\n");
}

TEST(SerialPort, SettingsReachTheLine) {
  PseudoTerminal line;
  const auto port =
      opened(line, {.baud = 250000, .dataBits = 7, .stopBits = 2, .parity = Parity::Odd, .flow = FlowControl::XonXoff});
  ASSERT_TRUE(port);
  termios2 state{};
  ASSERT_EQ(::ioctl(line.descriptor(), TCGETS2, &state), 0);
  EXPECT_EQ(state.c_ospeed, 250000U);
  EXPECT_EQ(state.c_ispeed, 250000U);
  EXPECT_NE(state.c_cflag & CSTOPB, 0U);
  EXPECT_NE(state.c_cflag & PARODD, 0U);
  EXPECT_NE(state.c_iflag & IXON, 0U);
  EXPECT_EQ(state.c_lflag & (ICANON | ECHO | ISIG), 0U);
}

TEST(SerialPort, WhatKeepsItFromOpeningIsTold) {
  PseudoTerminal line;
  const auto first = opened(line);
  ASSERT_TRUE(first);
  const auto second = openSerialPort(line.path(), {});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().fault, TransportFault::Busy) << second.error().error.message();

  const auto missing = openSerialPort("/dev/straightedge-has-no-such-port", {});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().fault, TransportFault::Gone);
  EXPECT_EQ(missing.error().error.where, "/dev/straightedge-has-no-such-port");

  PseudoTerminal other;
  const auto odd = openSerialPort(other.path(), {.dataBits = 9});
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error().fault, TransportFault::Unsupported);
  EXPECT_NE(odd.error().error.what.find("9 data bits"), std::string::npos);
}

TEST(SerialPort, PortsAreListedInOrder) {
  const auto ports = listSerialPorts(); // most test machines have none
  ASSERT_TRUE(ports) << ports.error().message();
  for (std::size_t i = 0; i < ports->size(); ++i) {
    EXPECT_FALSE((*ports)[i].path.empty());
    EXPECT_TRUE(i == 0 || (*ports)[i - 1].path <= (*ports)[i].path);
  }
}

} // namespace
} // namespace straightedge::devices
