// USBTMC when something goes wrong: the right error, recovery, and the next query works.
#include "tests/devices/usb/usbtmc_bench.h"

#include <thread>

namespace straightedge::devices {
namespace {

using fakes::UsbTmcDevice;
using fakes::UsbTmcFault;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::SizeIs;

using UsbTmcFaults = UsbTmcBench;

struct BadReply {
  const char* name;
  UsbTmcFault fault;
  TransportFault expected;
  const char* says; ///< part of the message
};

class UsbTmcBadReplies : public UsbTmcBench, public testing::WithParamInterface<BadReply> {};

TEST_P(UsbTmcBadReplies, AreTheRightErrorAndTheNextQueryWorks) {
  plugInAndOpen();
  expectNextQueryWorks();
  m_device->fault(GetParam().fault);
  const auto reply = query("ECHO? spoilt");
  expectFault(reply, GetParam().expected);
  EXPECT_THAT(reply.error().error.what, HasSubstr(GetParam().says));
  EXPECT_FALSE(m_device->isFaultDue());
  expectNextQueryWorks();
}

INSTANTIATE_TEST_SUITE_P(
    All, UsbTmcBadReplies,
    testing::Values(BadReply{"StallOut", UsbTmcFault::StallOut, TransportFault::Stalled, "refused"},
                    BadReply{"StallIn", UsbTmcFault::StallIn, TransportFault::Stalled, "refused"},
                    BadReply{"ShortHeader", UsbTmcFault::ShortHeader, TransportFault::Protocol, "5 bytes is shorter"},
                    BadReply{"WrongTag", UsbTmcFault::WrongTag, TransportFault::Protocol, "carries the tag"},
                    BadReply{"WrongTagAlone", UsbTmcFault::WrongTagAlone, TransportFault::Protocol, "carries the tag"},
                    BadReply{"WrongInverse", UsbTmcFault::WrongInverse, TransportFault::Protocol, "carries the tag"},
                    BadReply{"WrongMessageId", UsbTmcFault::WrongMessageId, TransportFault::Protocol, "of kind 127"},
                    BadReply{"Babble", UsbTmcFault::Babble, TransportFault::Overflow, "sent more"},
                    BadReply{"Truncated", UsbTmcFault::Truncated, TransportFault::Protocol,
                             "announces 17 bytes and brings 7"},
                    BadReply{"SizeBeyondRequest", UsbTmcFault::SizeBeyondRequest, TransportFault::Protocol,
                             "announces 65540 bytes where 65536 were requested"},
                    BadReply{"SizeHuge", UsbTmcFault::SizeHuge, TransportFault::Protocol, "announces 4294967280 bytes"},
                    BadReply{"EmptyReply", UsbTmcFault::EmptyReply, TransportFault::Protocol, "brings nothing"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_F(UsbTmcFaults, ExtraBytesAfterTheReplyAreIgnored) {
  plugInAndOpen();
  m_device->fault(UsbTmcFault::ExtraBytes);
  EXPECT_EQ(query("ECHO? good").value(), "good\n");
  EXPECT_FALSE(m_device->isFaultDue());
  expectNextQueryWorks();
}

TEST_F(UsbTmcFaults, ALateAnswerWithinTheDeadlineIsAnAnswer) {
  plugInAndOpen();
  m_device->fault(UsbTmcFault::Delay);
  EXPECT_EQ(query("ECHO? late").value(), "late\n");
  expectNextQueryWorks();
}

TEST_F(UsbTmcFaults, NeverAnsweredIsATimeOutAbortedByItsTag) {
  plugInAndOpen();
  expectNextQueryWorks(); // tags 1 to 4
  m_device->fault(UsbTmcFault::NeverAnswers);
  expectFault(query("ECHO? lost", tiny), TransportFault::TimedOut);
  EXPECT_THAT(m_device->abortedTags(), ElementsAre(6));
  const int clears = m_device->clears();
  expectNextQueryWorks();
  EXPECT_EQ(m_device->clears(), clears + 1) << "the old answer must not be taken for the next one";
}

TEST_F(UsbTmcFaults, TimeOutsManyTimesInARow) {
  plugInAndOpen();
  for (int i = 0; i < 20; ++i) {
    m_device->fault(UsbTmcFault::NeverAnswers);
    expectFault(query("ECHO? lost", Milliseconds(2)), TransportFault::TimedOut);
  }
  expectNextQueryWorks();
}

TEST_F(UsbTmcFaults, AnAbortThatTakesItsTimeIsWaitedFor) {
  plugInAndOpen();
  m_device->fault(UsbTmcFault::AbortStaysPending);
  expectFault(query("ECHO? lost", tiny), TransportFault::TimedOut);
  EXPECT_FALSE(m_device->isFaultDue());
  expectNextQueryWorks();
}

TEST_F(UsbTmcFaults, ADeviceThatKnowsTagsOf7BitsInAbortsOnly) {
  plugInAndOpen({.answersTagsOf7Bits = true});
  for (int i = 0; i < 64; ++i) { // beyond tag 127
    ASSERT_TRUE(query("ECHO? x"));
  }
  m_device->fault(UsbTmcFault::NeverAnswers);
  expectFault(query("ECHO? lost", tiny), TransportFault::TimedOut);
  EXPECT_THAT(m_device->abortedTags(), ElementsAre(130));
  expectNextQueryWorks();
}

TEST_F(UsbTmcFaults, ATimeOutInsideALongReply) {
  plugInAndOpen({}, {.requestSize = 1000});
  ASSERT_TRUE(m_transport->write("LONG? 5000\n", generous));
  ASSERT_TRUE(m_transport->readUntil(std::string(1, pattern(5000)[10]), generous));
  m_device->fault(UsbTmcFault::NeverAnswers);
  expectFault(m_transport->read(tiny), TransportFault::TimedOut);
  expectNextQueryWorks();
}

TEST_F(UsbTmcFaults, AMessageThatIsNotTakenTimesOutAndIsAborted) {
  plugInAndOpen();
  expectNextQueryWorks();
  m_device->fault(UsbTmcFault::NeverTakes);
  const auto sent = m_transport->write("ECHO? stuck\n", tiny);
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().fault, TransportFault::TimedOut);
  EXPECT_THAT(m_device->abortedOutTags(), ElementsAre(5));
  EXPECT_THAT(m_device->haltsCleared(UsbTmcDevice::out), Ge(2)) << "by the clear at the beginning, and now";
  expectNextQueryWorks();
}

TEST_F(UsbTmcFaults, StallsClearTheHaltOfTheirEndpointOnly) {
  plugInAndOpen();
  expectNextQueryWorks();
  const int before = m_device->haltsCleared(UsbTmcDevice::out);
  m_device->fault(UsbTmcFault::StallIn);
  expectFault(query("ECHO? x"), TransportFault::Stalled);
  EXPECT_EQ(m_device->haltsCleared(UsbTmcDevice::in), 1);
  EXPECT_EQ(m_device->haltsCleared(UsbTmcDevice::out), before);
  expectNextQueryWorks();
}

TEST_F(UsbTmcFaults, AfterTooMuchTheEndpointIsClearedAndTheTransferAborted) {
  plugInAndOpen();
  expectNextQueryWorks(); // tags 1 to 4
  m_device->fault(UsbTmcFault::Babble);
  expectFault(query("ECHO? x"), TransportFault::Overflow);
  EXPECT_EQ(m_device->haltsCleared(UsbTmcDevice::in), 1);
  EXPECT_THAT(m_device->abortedTags(), ElementsAre(6));
  expectNextQueryWorks();
}

class UsbTmcLeaves : public UsbTmcBench, public testing::WithParamInterface<UsbTmcFault> {};

TEST_P(UsbTmcLeaves, IsGoneAndWorksAgainAfterItIsBackAnywhere) {
  plugInAndOpen();
  expectNextQueryWorks();
  m_device->fault(GetParam());
  const auto reply = query("LONG? 3000");
  expectFault(reply, TransportFault::Gone);
  EXPECT_THAT(reply.error().error.what, HasSubstr("gone"));
  EXPECT_FALSE(m_bus.isPlugged(m_plug));
  expectFault(query("ECHO? still there"), TransportFault::Gone);
  EXPECT_EQ(m_transport->statusByte(generous).error().fault, TransportFault::Gone);
  EXPECT_EQ(m_transport->clear().error().fault, TransportFault::Gone);
  EXPECT_THAT(*listUsbDevices(), SizeIs(0));
  m_transport.reset();

  auto options = UsbTmcDevice::Options();
  m_device = std::make_shared<UsbTmcDevice>(options);
  m_device->onMessage(answer);
  m_plug = m_bus.plug(m_device, {.port = "9.2"});
  const auto back = *listUsbDevices();
  ASSERT_THAT(back, SizeIs(1));
  EXPECT_EQ(back[0].serial, "0123456");
  open();
  expectNextQueryWorks();
}

INSTANTIATE_TEST_SUITE_P(All, UsbTmcLeaves,
                         testing::Values(UsbTmcFault::UnplugOnMessage, UsbTmcFault::UnplugOnRequest,
                                         UsbTmcFault::UnplugMidReply));

TEST_F(UsbTmcFaults, UnpluggedWhileATransferWaits) {
  plugInAndOpen();
  expectNextQueryWorks();
  // The read waits for a delayed answer; the handler of the message pulls the plug in the meantime.
  m_device->onMessage([](const std::string&) { return std::optional<std::string>("x"); });
  m_device->fault(UsbTmcFault::NeverAnswers);
  ASSERT_TRUE(m_transport->write("ANY?\n", generous));
  const std::jthread puller([&] {
    while (m_device->isFaultDue()) { // until the read is under way
      std::this_thread::yield();
    }
    m_bus.unplug(m_plug);
  });
  expectFault(m_transport->read(generous), TransportFault::Gone);
}

TEST_F(UsbTmcFaults, TwoEqualInstrumentsKeepTheirRepliesApart) {
  auto first = std::make_shared<UsbTmcDevice>(UsbTmcDevice::Options{.identity = {0x1bfa, 0x0498, "M", "T", "A1"}});
  auto second = std::make_shared<UsbTmcDevice>(UsbTmcDevice::Options{.identity = {0x1bfa, 0x0498, "M", "T", "A2"}});
  first->onMessage([](const std::string&) { return std::optional<std::string>("I am A1"); });
  second->onMessage([](const std::string&) { return std::optional<std::string>("I am A2"); });
  m_bus.plug(first);
  m_bus.plug(second);
  const auto devices = *listUsbDevices();
  ASSERT_THAT(devices, SizeIs(2));
  auto a = UsbTmcTransport::open(devices[0]);
  auto b = UsbTmcTransport::open(devices[1]);
  ASSERT_TRUE(a);
  ASSERT_TRUE(b);
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE((*a)->write("*IDN?\n", generous));
    ASSERT_TRUE((*b)->write("*IDN?\n", generous));
    EXPECT_EQ((*b)->read(generous).value(), "I am A2\n");
    EXPECT_EQ((*a)->read(generous).value(), "I am A1\n");
  }
}

TEST_F(UsbTmcFaults, HeldByAnotherProgramIsBusy) {
  m_device = std::make_shared<UsbTmcDevice>();
  m_bus.plug(m_device, {.heldByAnotherProgram = true});
  const auto refused = UsbTmcTransport::open(listUsbDevices()->at(0));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().fault, TransportFault::Busy);
  EXPECT_THAT(refused.error().error.message(), HasSubstr("USBTMC 1bfa:0498 serial 0123456"));
}

} // namespace
} // namespace straightedge::devices
