// US Digital QSB-D: quadrature encoder reader on an FTDI serial line.
#pragma once

#include "devices/instruments/conversation.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/instruments/qsb_reply.h"
#include "devices/instruments/stamped_times.h"
#include "devices/transport/byte_buffer.h"
#include "devices/transport/serial_settings.h"

#include <memory>

namespace straightedge::devices {

/// 230400 8N1, DTR high, RTS low as the manual words it (the reader's program Qsb.cs raises RTS instead).
inline constexpr SerialSettings qsbSerial = {.baud = 230400, .dtr = true, .rts = false};

const std::vector<SettingDescription>& qsbSettings();

/// The count times 360 / counts per turn, unwrapped; zero is where the QSB's counter is zero. Single readings are asked
/// for one by one; a stream comes every 1.95 ms with the QSB's stamps, which space the readings of one arrival.
class Qsb : public Instrument, public AngleReference, public ReadingStream {
public:
  static Result<std::unique_ptr<Instrument>> make(Transport& transport, BenchClock& clock,
                                                  const SettingValues& settings);
  Qsb(Transport& transport, const BenchClock& clock, double degPerCount, bool countDown);

  Result<void> prepare() override;
  InstrumentIdentity identity() const override { return m_identity; }
  std::optional<TransportFault> lastFault() const override { return m_talk.lastFault(); }
  AngleReference* angleReference() override { return this; }
  std::optional<double> incrementDeg() const override { return m_degPerCount; } ///< it counts from its last reset
  ReadingStream* angleReadings(InstrumentRole role) override {
    return role == InstrumentRole::AngleReference ? this : nullptr;
  }

  Result<TimedReading> readDeg() override;
  Result<void> start() override;
  Result<ReadingBlock> read() override;
  Result<void> stop() override;

private:
  struct Answer {
    QsbReply reply;
    double timeS = 0.0;
  };
  Result<Answer> ask(std::string_view command, int unreadable = 0);
  Result<void> write(std::uint8_t reg, std::uint32_t value);
  double degrees(std::uint32_t count);
  /// Puts what has come into m_stream; the bench's time of the last arrival.
  Result<double> receiveStream();

  Conversation m_talk;
  double m_degPerCount;
  bool m_countDown;
  InstrumentIdentity m_identity;
  std::int64_t m_unwrapped = 0; ///< counts, beyond the 32 bits of the register
  std::uint32_t m_lastCount = 0;
  bool m_counted = false;
  bool m_streaming = false;
  ByteBuffer m_stream;
  StampedTimes m_times;
  std::optional<TransportError> m_streamFault; ///< came behind what was received last
};

} // namespace straightedge::devices
