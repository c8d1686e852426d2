// An emulated USBTMC/USB488 instrument that answers by a function of the message, records what the host does wrong, and
// misbehaves when told to. After USBTMC 1.0 and USB488 1.0.
#pragma once

#include "tests/fakes/usb/emulated_device.h"

#include <functional>

namespace straightedge::fakes {

/// One thing that goes wrong with the next message or reply; afterwards the device behaves again.
enum class UsbTmcFault : std::uint8_t {
  None,
  StallOut,      ///< the message is refused
  StallIn,       ///< the reply is refused
  NeverTakes,    ///< the message is not acknowledged (NAK) until it is aborted
  NeverAnswers,  ///< the reply does not come until it is aborted
  Delay,         ///< the reply comes after Options::delay
  ShortHeader,   ///< a reply of 5 bytes
  WrongTag,      ///< with its own inverse
  WrongTagAlone, ///< with the inverse of the right one
  WrongInverse,
  WrongMessageId,
  Babble,            ///< a packet longer than wMaxPacketSize
  Truncated,         ///< the reply ends before the announced size
  ExtraBytes,        ///< bytes follow the announced ones in the same transfer
  SizeBeyondRequest, ///< announces and sends more than was requested
  SizeHuge,          ///< announces 4 GB
  EmptyReply,        ///< announces 0 bytes without the end of the message
  UnplugOnMessage,   ///< leaves while it takes the message
  UnplugOnRequest,   ///< leaves while the read waits
  UnplugMidReply,    ///< leaves after the first packet of the reply
  AbortStaysPending, ///< never answers, and says "pending" three times while it is aborted
  StatusFails,       ///< READ_STATUS_BYTE says failed
  ClearStaysPending, ///< says "pending" three times while it is cleared, with bytes left to drain
};

class UsbTmcDevice : public EmulatedDevice {
public:
  struct Options {
    DeviceIdentity identity = {0x1bfa, 0x0498, "Metrolab Technology SA", "THM1176", "0123456"};
    std::size_t packet = 512;        ///< wMaxPacketSize of the bulk endpoints: 512 or 64
    bool interruptEndpoint = true;   ///< USB488 with SRQ
    bool termChar = true;            ///< GET_CAPABILITIES says it can end a read at a character
    bool padsReplies = false;        ///< fills replies to a multiple of 4
    bool endsLines = true;           ///< adds LF to replies
    bool answersTagsOf7Bits = false; ///< masks abort tags with 0x7F, as TinyUSB does
    bool headerOnlyOnce = false;     ///< Rigol DS1000: the rest of a long reply follows without header, EOM set at once
    bool clearHangs = false;         ///< Rigol DS1000Z: INITIATE_CLEAR is never answered (stalls here)
    std::size_t largestTransfer = 0; ///< bytes per reply transfer; 0: as many as requested
    std::chrono::milliseconds delay = std::chrono::milliseconds(20);
  };

  UsbTmcDevice() : UsbTmcDevice(Options{}) {}
  explicit UsbTmcDevice(Options options);

  using Handler = std::function<std::optional<std::string>(const std::string& message)>;
  /// Answers a message, without its line end; nullopt: it was a command. Called in the device's thread.
  void onMessage(Handler handler);

  void fault(UsbTmcFault fault);                ///< for the next message or reply
  void requestService(std::uint8_t statusByte); ///< SRQ on the interrupt endpoint
  void setStatusByte(std::uint8_t statusByte);

  std::vector<std::string> messages() const; ///< all that came, without line ends
  std::vector<int> abortedTags() const;      ///< of INITIATE_ABORT_BULK_IN
  std::vector<int> abortedOutTags() const;   ///< of INITIATE_ABORT_BULK_OUT
  int clears() const;
  bool isRemote() const;
  bool isFaultDue() const; ///< true until the armed fault has happened
  int triggers() const;
  int requests() const; ///< REQUEST_DEV_DEP_MSG_IN so far

  Bytes configurationDescriptor() const override;
  std::size_t packetSize(std::uint8_t endpoint) const override;
  bool highSpeed() const override { return m_options.packet == 512; }
  std::optional<Bytes> control(const ControlSetup& setup, const Bytes& data) override;
  Handshake packetOut(std::uint8_t endpoint, const Bytes& packet) override;
  std::optional<Bytes> packetIn(std::uint8_t endpoint) override;
  void haltCleared(std::uint8_t endpoint) override;
  void wasClaimed() override;
  void wasReset() override;

  static constexpr std::uint8_t out = 0x01;
  static constexpr std::uint8_t in = 0x82;
  static constexpr std::uint8_t interrupt = 0x83;

private:
  void transferArrived();
  void checkHeader();
  void messageArrived(const Bytes& transfer, std::size_t size, bool last);
  void requestArrived(const Bytes& transfer);
  void sendReply(std::size_t requested, std::optional<std::uint8_t> termChar);
  void sendFaulty(Bytes reply, std::size_t requested);
  std::optional<Bytes> initiateAbortIn(const ControlSetup& setup);
  std::optional<Bytes> checkAbortIn(const ControlSetup& setup);
  std::optional<Bytes> abortOut(const ControlSetup& setup);
  std::optional<Bytes> clearRequest(const ControlSetup& setup);
  std::optional<Bytes> statusByteRequest(const ControlSetup& setup);
  void expectLength(const ControlSetup& setup, std::uint16_t length);
  bool takeFault(UsbTmcFault fault);
  void dropAll();

  const Options m_options;
  Handler m_handler;
  UsbTmcFault m_fault = UsbTmcFault::None;
  Bytes m_transfer; ///< Bulk-OUT under way
  Bytes m_message;  ///< collected until the end of the message
  Bytes m_reply;    ///< not yet sent
  bool m_replyDue = false;
  bool m_reading = false; ///< REQUEST taken, its transfer not finished
  bool m_neverTaking = false;
  bool m_leaveMidReply = false;
  std::optional<std::uint8_t> m_lastTag; ///< none: the host may begin with any
  std::uint8_t m_readTag = 0;
  std::uint8_t m_lastStatusTag = 0;
  std::uint8_t m_status = 0;
  int m_pendingAnswers = 0;
  bool m_aborting = false;
  bool m_clearing = false;
  bool m_remote = false;
  int m_clears = 0;
  int m_triggers = 0;
  int m_requests = 0;
  std::vector<std::string> m_messages;
  std::vector<int> m_abortedTags;
  std::vector<int> m_abortedOutTags;
};

} // namespace straightedge::fakes
