// Boards that print a line of text for every reading, as an Arduino with `Serial.print` does. There is no standard:
// columns, labels, units and scale are settings.
#pragma once

#include "devices/instruments/angle_unwrap.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/instruments/line_source.h"
#include "devices/instruments/line_stream.h"

#include <memory>
#include <optional>

namespace straightedge::devices {

const std::vector<SettingDescription>& asciiBoardSettings();

struct AsciiBoardOptions {
  LineFormat format;                            ///< column 0: the angle in degrees; the others where they are
  std::optional<std::size_t> temperatureColumn; ///< of `format`: in °C
  std::optional<std::size_t> referenceColumn; ///< of `format`: the encoder's angle, in degrees, where the board prints
                                              ///< both
  double latencyS = 0.0;
  Milliseconds deadline{2000};
  bool unwrap = false;    ///< as a reference: the board knows one turn only
  bool keepsZero = false; ///< as a reference: it knows its angle also after it was without power
};

class AsciiBoard : public Instrument, public AngleSensor, public Thermometer {
public:
  static Result<std::unique_ptr<Instrument>> make(Transport& transport, BenchClock& clock,
                                                  const SettingValues& settings);
  AsciiBoard(Transport& transport, const BenchClock& clock, AsciiBoardOptions options);

  Result<void> prepare() override; ///< waits for one reading, so that a wrong baud rate shows at once
  InstrumentIdentity identity() const override { return {.model = "ASCII board", .serial = {}, .firmware = {}}; }
  std::optional<TransportFault> lastFault() const override { return m_talk.lastFault(); }
  AngleSensor* angleSensor() override { return this; }
  AngleReference* angleReference() override { return &m_reference; }
  ReadingStream* angleReadings(InstrumentRole role) override;
  AngleStream* angleStream() override { return m_options.referenceColumn ? &m_bothAngles : nullptr; }
  Thermometer* thermometer() override { return m_options.temperatureColumn ? this : nullptr; }

  Result<TimedReading> readDeg() override; ///< as a sensor: [0, 360)
  Result<TimedReading> readC() override;

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
  std::size_t referenceColumn() const { return m_options.referenceColumn.value_or(0); }
  AngleUnwrap* unwrap() { return m_options.unwrap ? &m_unwrap : nullptr; }

  Conversation m_talk;
  AsciiBoardOptions m_options;
  LineSource m_lines;
  AngleUnwrap m_unwrap;
  Reference m_reference{*this};
  bool m_streaming = false;
  StreamedLines m_printed{&m_talk, &m_lines, &m_streaming};
  LineReadings m_sensorReadings{m_printed, 0, nullptr};
  LineReadings m_referenceReadings{m_printed, referenceColumn(), unwrap()};
  LineAngles m_bothAngles{m_printed, referenceColumn(), 0, unwrap()};
};

} // namespace straightedge::devices
