// Boards that print a line of text for every reading, as an Arduino with `Serial.print` does. There is no standard:
// columns, labels, units and scale are settings.
#pragma once

#include "devices/instruments/angle_unwrap.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/instruments/line_source.h"

#include <memory>
#include <optional>

namespace straightedge::devices {

const std::vector<SettingDescription>& asciiBoardSettings();

struct AsciiBoardOptions {
  LineFormat format; ///< column 0: the angle in degrees; column 1, where there is one: a temperature in °C
  double latencyS = 0.0;
  Milliseconds deadline{2000};
  bool unwrap = false;    ///< as a reference: the board knows one turn only
  bool keepsZero = false; ///< as a reference: it knows its angle also after it was without power
};

class AsciiBoard : public Instrument, public AngleSensor, public Thermometer, public ReadingStream {
public:
  static Result<std::unique_ptr<Instrument>> make(Transport& transport, BenchClock& clock,
                                                  const SettingValues& settings);
  AsciiBoard(Transport& transport, const BenchClock& clock, AsciiBoardOptions options);

  Result<void> prepare() override; ///< waits for one reading, so that a wrong baud rate shows at once
  InstrumentIdentity identity() const override { return {.model = "ASCII board", .serial = {}, .firmware = {}}; }
  std::optional<TransportFault> lastFault() const override { return m_talk.lastFault(); }
  AngleSensor* angleSensor() override { return this; }
  AngleReference* angleReference() override { return &m_reference; }
  ReadingStream* angleReadings() override { return this; }
  Thermometer* thermometer() override { return m_options.format.columns.size() > 1 ? this : nullptr; }

  Result<TimedReading> readDeg() override; ///< as a sensor: [0, 360)
  Result<TimedReading> readC() override;
  Result<void> start() override;
  Result<ReadingBlock> read() override; ///< as printed
  Result<void> stop() override;

private:
  /// The same board as a reference: AngleSensor and AngleReference both have a readDeg().
  class Reference : public AngleReference {
  public:
    explicit Reference(AsciiBoard& board) : m_board(board) {}
    InstrumentIdentity identity() const override { return m_board.identity(); }
    Result<TimedReading> readDeg() override;
    std::optional<double> incrementDeg() const override {
      return m_board.m_options.keepsZero ? std::nullopt : std::optional(0.0);
    }

  private:
    AsciiBoard& m_board;
  };

  Result<TimedReading> fresh(std::size_t column);

  Conversation m_talk;
  AsciiBoardOptions m_options;
  LineSource m_lines;
  AngleUnwrap m_unwrap;
  Reference m_reference{*this};
  bool m_streaming = false;
  LineCounts m_told; ///< counts when the last block was handed over
};

} // namespace straightedge::devices
