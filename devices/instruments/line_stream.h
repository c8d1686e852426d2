// What a board prints by itself as streams of readings: one column, or both angles of every line.
#pragma once

#include "devices/instruments/angle_unwrap.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/line_source.h"

#include <cstddef>

namespace straightedge::devices {

/// The lines of one instrument and whether they are being streamed; owned by it.
struct StreamedLines {
  Conversation* talk = nullptr;
  LineSource* lines = nullptr;
  bool* streaming = nullptr;
};

/// A column as it is printed, or unwrapped where a reference knows one turn only. `unwrap` may be null and lives as
/// long as this. One thread.
class LineReadings final : public ReadingStream {
public:
  LineReadings(const StreamedLines& from, std::size_t column, AngleUnwrap* unwrap)
      : m_from(from), m_column(column), m_unwrap(unwrap) {}

  Result<void> start() override;
  Result<ReadingBlock> read() override;
  Result<void> stop() override;

private:
  StreamedLines m_from;
  std::size_t m_column;
  AngleUnwrap* m_unwrap;
  std::int64_t m_rejectedBefore = 0;
};

/// Encoder and sensor out of the same line: nothing is to be paired. As LineReadings otherwise.
class LineAngles final : public AngleStream {
public:
  LineAngles(const StreamedLines& from, std::size_t encoderColumn, std::size_t sensorColumn, AngleUnwrap* unwrap)
      : m_from(from), m_encoderColumn(encoderColumn), m_sensorColumn(sensorColumn), m_unwrap(unwrap) {}

  Result<void> start(const StreamRequest& request) override;
  Result<StreamBlock> read() override;
  Result<void> stop() override;

private:
  StreamedLines m_from;
  std::size_t m_encoderColumn;
  std::size_t m_sensorColumn;
  AngleUnwrap* m_unwrap;
  std::int64_t m_rejectedBefore = 0;
};

} // namespace straightedge::devices
