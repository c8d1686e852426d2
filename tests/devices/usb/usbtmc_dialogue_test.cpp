// USBTMC when all goes well: tags, sizes around the packet, long replies and messages, termination characters, status,
// service requests, trigger, remote, clear, quirks.
#include "tests/devices/usb/usbtmc_bench.h"

#include <stop_token>
#include <thread>

namespace straightedge::devices {
namespace {

using fakes::UsbTmcDevice;
using fakes::UsbTmcFault;
using testing::AllOf;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;

using UsbTmcDialogue = UsbTmcBench;

TEST_F(UsbTmcDialogue, OpensByTheListAndAsksWhoItIs) {
  plugIn();
  auto opened = UsbTmcTransport::open(listUsbDevices()->at(0));
  ASSERT_TRUE(opened) << opened.error().error.message();
  m_transport = std::move(*opened);
  EXPECT_EQ(m_transport->name(), "USBTMC 1bfa:0498 serial 0123456");
  EXPECT_TRUE(m_transport->hasMessages());
  EXPECT_EQ(query("*IDN?").value(), "Metrolab Technology SA,THM1176-MF,0123456,el-B0-gl-B0-mf-B0\n");
  EXPECT_EQ(m_device->resets(), 1) << "the THM1176 may hang from an earlier program";
  EXPECT_TRUE(m_device->isRemote());
  m_transport.reset();
  EXPECT_FALSE(m_device->isRemote());
}

TEST_F(UsbTmcDialogue, FiveHundredQueriesAcrossTheWrapOfTheTag) {
  plugInAndOpen();
  for (int i = 0; i < 500; ++i) {
    const auto reply = query("ECHO? " + std::to_string(i));
    ASSERT_TRUE(reply) << i << ": " << reply.error().error.message();
    ASSERT_EQ(*reply, std::to_string(i) + "\n");
  }
}

class UsbTmcReplySizes : public UsbTmcBench, public testing::WithParamInterface<std::size_t> {};

TEST_P(UsbTmcReplySizes, EverySizeAroundThePacketComesWhole) {
  const std::size_t packet = GetParam();
  plugInAndOpen({.packet = packet});
  for (const std::size_t packets : {1U, 2U, 3U}) {
    for (std::size_t size = packet * packets - 16; size <= packet * packets + 4; ++size) {
      const auto reply = query("LONG? " + std::to_string(size));
      ASSERT_TRUE(reply) << size << ": " << reply.error().error.message();
      ASSERT_EQ(*reply, pattern(size) + "\n") << size;
    }
  }
  for (std::size_t size = 0; size < 6; ++size) {
    ASSERT_EQ(query("LONG? " + std::to_string(size)).value(), pattern(size) + "\n");
  }
}

TEST_P(UsbTmcReplySizes, AReplyThatFillsRequestAndPacketLeavesNothingForTheNext) {
  const std::size_t packet = GetParam();
  const auto requested = static_cast<std::uint32_t>(packet * 2 - usbtmc::headerSize);
  plugInAndOpen({.packet = packet}, {.requestSize = requested});
  for (std::size_t size = requested - 6; size < requested + 6; ++size) {
    const auto reply = query("LONG? " + std::to_string(size));
    ASSERT_TRUE(reply) << size << ": " << reply.error().error.message();
    ASSERT_EQ(*reply, pattern(size) + "\n") << size;
    ASSERT_EQ(query("ECHO? then").value(), "then\n") << size;
  }
}

TEST_P(UsbTmcReplySizes, AReplyThatIsFilledToWholePacketsLeavesNothingForTheNext) {
  // 12 bytes of header and the data are 3 bytes short of two packets, which the device fills up: an empty packet ends
  // the transfer, and it has to be read with it.
  const std::size_t packet = GetParam();
  const auto requested = static_cast<std::uint32_t>(packet * 2 - usbtmc::headerSize - 3);
  plugInAndOpen({.packet = packet, .padsReplies = true}, {.requestSize = requested});
  for (const std::size_t size : {std::size_t{requested} - 1, 2 * std::size_t{requested} - 1}) { // and a line feed
    const auto reply = query("LONG? " + std::to_string(size));
    ASSERT_TRUE(reply) << size << ": " << reply.error().error.message();
    ASSERT_EQ(*reply, pattern(size) + "\n") << size;
    ASSERT_EQ(query("ECHO? then").value(), "then\n") << size;
  }
}

TEST_P(UsbTmcReplySizes, MessagesOfEverySizeArriveWhole) {
  plugInAndOpen({.packet = GetParam()}, {.messageSize = 100});
  for (std::size_t size = 1; size < 300; size += size < 12 ? 1 : 23) {
    const auto text = pattern(size);
    const auto reply = query("ECHO? " + text);
    ASSERT_TRUE(reply) << size << ": " << reply.error().error.message();
    ASSERT_EQ(*reply, text + "\n") << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Packets, UsbTmcReplySizes, testing::Values(64, 512));

TEST_F(UsbTmcDialogue, AMegabyteInManyTransfers) {
  plugInAndOpen();
  const auto reply = query("LONG? 1048576");
  ASSERT_TRUE(reply) << reply.error().error.message();
  EXPECT_EQ(*reply, pattern(1048576) + "\n");
  EXPECT_EQ(m_device->requests(), 17);
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, AMegabyteInTheDevicesOwnPieces) {
  plugInAndOpen({.largestTransfer = 5000});
  EXPECT_EQ(query("LONG? 1048576").value(), pattern(1048576) + "\n");
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, AMegabyteOfMessage) {
  plugInAndOpen();
  const auto text = pattern(1048576);
  EXPECT_EQ(query("ECHO? " + text).value(), text + "\n");
}

TEST_F(UsbTmcDialogue, BytesThatFillTheReplyAreLeftOut) {
  plugInAndOpen({.padsReplies = true});
  for (std::size_t size = 0; size < 9; ++size) {
    EXPECT_EQ(query("LONG? " + std::to_string(size)).value(), pattern(size) + "\n");
  }
}

TEST_F(UsbTmcDialogue, LinesOfOneReplyByTheTerminationCharacter) {
  plugInAndOpen();
  ASSERT_TRUE(m_transport->write("ECHO? one\ntwo\nthree\n", generous));
  EXPECT_EQ(m_transport->readUntil("\n", generous).value(), "one\n");
  EXPECT_EQ(m_transport->readUntil("\n", generous).value(), "two\n");
  EXPECT_EQ(m_device->requests(), 2) << "the device itself ends the transfer";
  EXPECT_EQ(m_transport->readUntil("\n", generous).value(), "three\n");
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, LinesOfOneReplyWithoutATerminationCharacter) {
  plugInAndOpen({.termChar = false});
  ASSERT_TRUE(m_transport->write("ECHO? one\ntwo\nthree\n", generous));
  EXPECT_EQ(m_transport->readUntil("\n", generous).value(), "one\n");
  EXPECT_EQ(m_transport->readUntil("\n", generous).value(), "two\n");
  EXPECT_EQ(m_transport->readUntil("\n", generous).value(), "three\n");
  EXPECT_EQ(m_device->requests(), 1);
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, TheEndOfTheMessageEndsItsLastLine) {
  plugInAndOpen({.endsLines = false});
  ASSERT_TRUE(m_transport->write("ECHO? open\n", generous));
  EXPECT_EQ(m_transport->readUntil("\n", generous).value(), "open");
  ASSERT_TRUE(m_transport->write("ECHO? next\n", generous));
  EXPECT_EQ(m_transport->read(generous).value(), "next");
}

TEST_F(UsbTmcDialogue, NoCommandBeforeTheAnswerIsRead) {
  plugInAndOpen();
  ASSERT_TRUE(m_transport->write("ECHO? first\n", generous));
  const auto refused = m_transport->write("ECHO? second\n", generous);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().fault, TransportFault::Protocol);
  EXPECT_THAT(refused.error().error.what, HasSubstr("'ECHO? first' has not been read"));
  EXPECT_EQ(m_transport->read(generous).value(), "first\n");
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, AQuestionMarkInQuotesIsNoQuery) {
  plugInAndOpen();
  ASSERT_TRUE(m_transport->write("DISP:TEXT \"WHY?\"\n", generous));
  ASSERT_TRUE(m_transport->write("DISP:TEXT 'WHO?'\n", generous));
  EXPECT_THAT(m_device->messages(), ElementsAre("DISP:TEXT \"WHY?\"", "DISP:TEXT 'WHO?'"));
}

TEST_F(UsbTmcDialogue, ReadingWithoutAQueryIsRefusedAndNotSent) {
  plugInAndOpen();
  expectFault(m_transport->read(generous), TransportFault::Protocol);
  ASSERT_EQ(query("ECHO? once").value(), "once\n");
  expectFault(m_transport->readUntil("\n", generous), TransportFault::Protocol);
  EXPECT_EQ(m_device->requests(), 1);
}

TEST_F(UsbTmcDialogue, ClearDropsAnUnreadAnswer) {
  plugInAndOpen();
  ASSERT_TRUE(m_transport->write("ECHO? old\n", generous));
  ASSERT_TRUE(m_transport->clear());
  EXPECT_THAT(m_device->clears(), Ge(1));
  EXPECT_THAT(m_device->haltsCleared(UsbTmcDevice::out), Ge(1));
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, ClearWaitsWhileTheDeviceIsAtItAndDrains) {
  plugInAndOpen();
  expectNextQueryWorks();
  m_device->fault(UsbTmcFault::ClearStaysPending);
  ASSERT_TRUE(m_transport->write("ECHO? old\n", generous));
  ASSERT_TRUE(m_transport->clear());
  EXPECT_FALSE(m_device->isFaultDue());
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, WhatAnEarlierProgramLeftUnreadIsCleared) {
  plugInAndOpen();
  ASSERT_TRUE(m_transport->write("ECHO? from before\n", generous));
  m_transport.reset();
  open();
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, StatusByteByTheInterruptEndpoint) {
  plugInAndOpen();
  for (int i = 0; i < 130; ++i) { // across the wrap of its own tag
    m_device->setStatusByte(static_cast<std::uint8_t>(i));
    const auto status = m_transport->statusByte(generous);
    ASSERT_TRUE(status) << status.error().error.message();
    ASSERT_EQ(*status, i);
  }
}

TEST_F(UsbTmcDialogue, StatusByteByTheRequestWhereThereIsNoInterruptEndpoint) {
  plugInAndOpen({.interruptEndpoint = false});
  m_device->setStatusByte(0x51);
  EXPECT_EQ(m_transport->statusByte(generous).value(), 0x51);
  EXPECT_EQ(m_transport->waitForServiceRequest(generous).error().fault, TransportFault::Unsupported);
}

TEST_F(UsbTmcDialogue, StatusByteThatFailsIsAnErrorAndTheNextWorks) {
  plugInAndOpen();
  m_device->fault(UsbTmcFault::StatusFails);
  const auto refused = m_transport->statusByte(generous);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().fault, TransportFault::Protocol);
  m_device->setStatusByte(7);
  EXPECT_EQ(m_transport->statusByte(generous).value(), 7);
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, ServiceRequestsAreKeptApartAndInOrder) {
  plugInAndOpen();
  m_device->requestService(0x41);
  m_device->requestService(0x42);
  m_device->requestService(0x43);
  EXPECT_EQ(m_transport->waitForServiceRequest(generous).value(), 0x41);
  EXPECT_EQ(m_transport->statusByte(generous).value(), 0x43) << "the answer is found among the requests";
  EXPECT_EQ(m_transport->waitForServiceRequest(generous).value(), 0x42);
  EXPECT_EQ(m_transport->waitForServiceRequest(generous).value(), 0x43);
  const auto none = m_transport->waitForServiceRequest(tiny);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().fault, TransportFault::TimedOut);
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, ServiceRequestsDuringQueriesAreNotLost) {
  plugInAndOpen();
  for (std::uint8_t i = 1; i < 9; ++i) {
    m_device->requestService(i);
    ASSERT_EQ(query("ECHO? x").value(), "x\n");
    ASSERT_EQ(m_transport->statusByte(generous).value(), i);
  }
  for (std::uint8_t i = 1; i < 9; ++i) {
    ASSERT_EQ(m_transport->waitForServiceRequest(generous).value(), i);
  }
}

TEST_F(UsbTmcDialogue, TriggersWhereTheDeviceKnowsIt) {
  plugInAndOpen();
  ASSERT_TRUE(m_transport->trigger(generous));
  EXPECT_EQ(m_device->triggers(), 1);
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, NoTriggerWhereTheDeviceKnowsNone) {
  plugInAndOpen({.interruptEndpoint = false});
  EXPECT_EQ(m_transport->trigger(generous).error().fault, TransportFault::Unsupported);
  EXPECT_FALSE(m_device->isRemote());
}

TEST(UsbTmcQuirkTable, ProductsFirstThenVendors) {
  EXPECT_TRUE(usbTmcQuirks(0x1bfa, 0x0498).resetAtOpen);
  EXPECT_EQ(usbTmcQuirks(0x1bfa, 0x0498).largestRequest, 49152U);
  EXPECT_TRUE(usbTmcQuirks(0x1ab1, 0x04ce).headerOnlyOnce);
  EXPECT_FALSE(usbTmcQuirks(0x1ab1, 0x0001).headerOnlyOnce);
  EXPECT_TRUE(usbTmcQuirks(0x1ab1, 0x0001).noRemoteControl);
  EXPECT_TRUE(usbTmcQuirks(0xf4ec, 0x1234).resetAtOpen);
  EXPECT_FALSE(usbTmcQuirks(0x0957, 0x0588).resetAtOpen);
  for (const auto& entry : usbTmcQuirkTable()) {
    EXPECT_FALSE(entry.model.empty());
    EXPECT_FALSE(entry.source.empty());
  }
}

TEST_F(UsbTmcDialogue, RigolSendsItsHeaderOnlyOnce) {
  plugInAndOpen({.headerOnlyOnce = true, .clearHangs = true}, {.quirks = usbTmcQuirks(0x1ab1, 0x04ce)});
  for (const std::size_t size : {10U, 499U, 500U, 501U, 1800U, 20000U}) {
    ASSERT_EQ(query("LONG? " + std::to_string(size)).value(), pattern(size) + "\n") << size;
  }
  EXPECT_EQ(m_device->requests(), 6) << "a second request would restart the reply";
  EXPECT_FALSE(m_device->isRemote());
  ASSERT_TRUE(m_transport->write("ECHO? old\n", generous));
  ASSERT_TRUE(m_transport->clear());
  EXPECT_EQ(m_device->clears(), 0);
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, AdvantestNeverMarksTheEnd) {
  plugInAndOpen({}, {.quirks = usbTmcQuirks(0x1334, 1)});
  EXPECT_EQ(query("LONG? 20").value(), pattern(20) + "\n");
  expectNextQueryWorks();
}

TEST_F(UsbTmcDialogue, ASecondThreadStopsAWait) {
  plugIn();
  const auto device = listUsbDevices()->at(0);
  auto handle = UsbHandle::open(device, {0});
  ASSERT_TRUE(handle);
  std::stop_source stop;
  handle->get()->setStop(stop.get_token());
  std::vector<std::uint8_t> buffer(64);
  const std::jthread stopper([&] { stop.request_stop(); });
  const auto stopped = handle->get()->bulkIn(UsbTmcDevice::in, buffer, generous);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().fault, UsbFault::Cancelled);
  EXPECT_EQ(stopped.error().error.kind, ErrorKind::Cancelled);
}

} // namespace
} // namespace straightedge::devices
