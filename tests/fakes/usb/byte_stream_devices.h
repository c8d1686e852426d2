// Emulated serial adapters and boards: CDC-ACM (an Arduino-like board) and FTDI (FT232R), both a stream of bytes.
#pragma once

#include "tests/fakes/usb/emulated_device.h"

#include <functional>

namespace straightedge::fakes {

/// What the host has set the line to.
struct LineState {
  int baud = 0;
  int dataBits = 8;
  int stopBits = 1;
  char parity = 'N'; ///< N, O, E
  bool dtr = false;
  bool rts = false;
  char flow = 'N'; ///< N, R (RTS/CTS), X (XON/XOFF)
};

/// Bytes come from three sides: answers to what the host sends, push() of a test, and a generator asked whenever the
/// host polls, with which a board streams by its own clock.
class ByteStreamDevice : public EmulatedDevice {
public:
  using EmulatedDevice::EmulatedDevice;

  using Handler = std::function<std::string(const std::string& received)>;
  void onBytes(Handler handler); ///< gets bytes as they arrive, not lines; returns what to send back

  /// Gets whole lines (ended by `end`, which is taken off); returns what to send back. Replaces onBytes().
  void onLine(std::string end, Handler handler);

  using Generator = std::function<std::string()>;
  void generate(Generator generator);

  using LineWatcher = std::function<std::string(const LineState& before, const LineState& now)>;
  void onLineState(LineWatcher watcher); ///< returns what to send: a board that resets on DTR prints its banner

  void push(std::string_view bytes);
  void stallNextRead();
  void stallNextWrite();
  void holdWrites(bool hold);          ///< NAK: the device takes nothing
  void unplugAfter(std::size_t bytes); ///< leaves after so many more bytes to the host

  std::string received() const;
  LineState line() const;

protected:
  Handshake takeBytes(std::uint8_t endpoint, const Bytes& packet);
  std::string giveBytes(std::uint8_t endpoint, std::size_t most);
  void setLine(const LineState& line);
  void dropToHost() {
    m_toHost.clear();
    m_given = 0;
  }

private:
  Handler m_handler;
  Generator m_generator;
  LineWatcher m_watcher;
  std::string m_toHost;
  std::size_t m_given = 0; ///< of m_toHost, already
  std::string m_received;
  LineState m_line;
  bool m_stallRead = false;
  bool m_stallWrite = false;
  bool m_hold = false;
  std::optional<std::size_t> m_leaveAfter;
};

class CdcAcmDevice : public ByteStreamDevice {
public:
  explicit CdcAcmDevice(DeviceIdentity identity = {0x2341, 0x0043, "Straightedge tests", "angle board", "ACM-1"})
      : ByteStreamDevice(std::move(identity)) {}

  Bytes configurationDescriptor() const override;
  std::size_t packetSize(std::uint8_t endpoint) const override { return endpoint == notify ? 8 : 64; }
  std::optional<Bytes> control(const ControlSetup& setup, const Bytes& data) override;
  Handshake packetOut(std::uint8_t endpoint, const Bytes& packet) override { return takeBytes(endpoint, packet); }
  std::optional<Bytes> packetIn(std::uint8_t endpoint) override;

  static constexpr std::uint8_t notify = 0x81;
  static constexpr std::uint8_t out = 0x02;
  static constexpr std::uint8_t in = 0x83;

private:
  bool m_endWithEmpty = false; ///< the last packet was full and the stream is empty now
};

/// FT232R: two status bytes before each packet's data, and every latency period a packet of them alone.
class FtdiDevice : public ByteStreamDevice {
public:
  explicit FtdiDevice(DeviceIdentity identity = {0x0403, 0x6001, "FTDI", "FT232R USB UART", "FT-1", 0x0600})
      : ByteStreamDevice(std::move(identity)) {}

  void setLineErrors(std::uint8_t bits); ///< into the second status byte, once: bit 1 overrun, 2 parity, 3 framing
  int latencyMs() const;
  int resetsOfChip() const; ///< SIO_RESET and purges
  int purges() const;

  Bytes configurationDescriptor() const override;
  std::size_t packetSize(std::uint8_t /*endpoint*/) const override { return 64; }
  std::optional<Bytes> control(const ControlSetup& setup, const Bytes& data) override;
  Handshake packetOut(std::uint8_t endpoint, const Bytes& packet) override { return takeBytes(endpoint, packet); }
  std::optional<Bytes> packetIn(std::uint8_t endpoint) override;

  static constexpr std::uint8_t in = 0x81;
  static constexpr std::uint8_t out = 0x02;

private:
  std::uint8_t m_errors = 0;
  int m_latencyMs = 16;
  int m_chipResets = 0;
  int m_purges = 0;
  std::chrono::steady_clock::time_point m_lastPacket;
};

} // namespace straightedge::fakes
