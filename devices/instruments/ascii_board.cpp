#include "devices/instruments/ascii_board.h"

#include <numbers>

namespace straightedge::devices {

namespace {

std::string separatorsOf(std::string_view word) {
  if (word == "comma") {
    return ",";
  }
  if (word == "semicolon") {
    return ";";
  }
  if (word == "tab") {
    return "\t";
  }
  return word == "blanks" ? " \t" : ",;\t";
}

/// Of the column whose unit and counts per turn have these keys.
double degreesPer(SettingReader& reader, std::string_view unitKey, std::string_view countsKey) {
  const std::string unit = reader.text(unitKey);
  if (unit == "count") {
    return 360.0 / reader.number(countsKey, 2, 1e12);
  }
  if (unit == "rad") {
    return 180.0 / std::numbers::pi;
  }
  return unit == "turn" ? 360.0 : 1.0;
}

/// A board that prints the encoder's angle beside the sensor's: both in one line, sampled together.
std::optional<LineColumn> referenceColumnOf(SettingReader& reader) {
  const auto column = reader.numberIfGiven("reference_column", 1, 64);
  const std::string label = reader.text("reference_label");
  if (!column && label.empty()) {
    return std::nullopt;
  }
  LineColumn reference;
  reference.quantity = "reference";
  reference.index = static_cast<int>(column.value_or(1));
  reference.label = label;
  reference.scale = degreesPer(reader, "reference_unit", "reference_counts_per_turn");
  return reference;
}

} // namespace

const std::vector<SettingDescription>& asciiBoardSettings() {
  static const std::vector<SettingDescription> all = {
      {"separator",
       "Between the fields",
       "any",
       "any (comma, semicolon or tab), or the one the board prints",
       {"any", "comma", "semicolon", "tab", "blanks"}},
      {"column", "Field with the angle", "1", "its number in the line, from 1"},
      {"label", "Label before the angle", "",
       "the text before the number; it is then found by that, not by its number"},
      {"unit",
       "Unit of the angle",
       "deg",
       "what one unit is: deg, rad, turn or count",
       {"deg", "rad", "turn", "count"}},
      {"counts_per_turn", "Counts per turn", "", "for the unit count: 4096 for 12 bits, 16384 for 14"},
      {"reference_column", "Field with the encoder's angle", "",
       "its number in the line, where the board prints both angles"},
      {"reference_label", "Label before the encoder's angle", "", "it is then found by that, not by its number"},
      {"reference_unit",
       "Unit of the encoder's angle",
       "deg",
       "what one unit of it is: deg, rad, turn or count",
       {"deg", "rad", "turn", "count"}},
      {"reference_counts_per_turn", "Encoder's counts per turn", "", "for the unit count: 4 times its lines"},
      {"suffix", "Text after the number", "", "what the board prints behind the angle, for example deg"},
      {"prefix", "Lines begin with", "", "the text that all lines with a reading begin with"},
      {"temperature_column", "Field with a temperature", "", "its number in the line, where there is one, in °C"},
      {"latency_s", "Latency in seconds", "0", "the time from measuring to printing, 0 to 10 s"},
      {"deadline_s", "Longest wait in seconds", "2", "more than the time between two lines, 0.01 to 600 s"},
      {"unwrap", "Count turns", "yes", "yes where a reference prints 0 to 360 over several turns", {"yes", "no"}},
      {"keeps_zero",
       "Keeps its zero without power",
       "no",
       "yes where a reference is an absolute encoder, no where it counts from where it was switched on",
       {"yes", "no"}}};
  return all;
}

Result<std::unique_ptr<Instrument>> AsciiBoard::make(Transport& transport, BenchClock& clock,
                                                     const SettingValues& settings) {
  SettingReader reader(settings, asciiBoardSettings(), "ASCII board");
  AsciiBoardOptions options;
  options.format.separators = separatorsOf(reader.text("separator"));
  options.format.prefix = reader.text("prefix");
  LineColumn angle;
  angle.quantity = "angle";
  angle.index = reader.integer("column", 1, 64);
  angle.label = reader.text("label");
  angle.unit = reader.text("suffix");
  angle.scale = degreesPer(reader, "unit", "counts_per_turn");
  options.format.columns.push_back(angle);
  if (const auto column = reader.numberIfGiven("temperature_column", 1, 64)) {
    LineColumn temperature;
    temperature.quantity = "temperature";
    temperature.index = static_cast<int>(*column);
    options.temperatureColumn = options.format.columns.size();
    options.format.columns.push_back(temperature);
  }
  if (auto reference = referenceColumnOf(reader)) {
    options.referenceColumn = options.format.columns.size();
    options.format.columns.push_back(*std::move(reference));
  }
  options.latencyS = reader.number("latency_s", 0.0, 10.0);
  options.deadline = Milliseconds{static_cast<int>(1000.0 * reader.number("deadline_s", 0.01, 600.0))};
  options.unwrap = reader.yes("unwrap");
  options.keepsZero = reader.yes("keeps_zero");
  if (reader.problem()) {
    return std::unexpected(*reader.problem());
  }
  return std::make_unique<AsciiBoard>(transport, clock, std::move(options));
}

AsciiBoard::AsciiBoard(Transport& transport, const BenchClock& clock, AsciiBoardOptions options)
    : m_talk(transport, clock, {}), m_options(std::move(options)), m_lines(m_options.format, m_options.latencyS) {}

Result<void> AsciiBoard::prepare() {
  m_streaming = false;
  m_unwrap.restart();
  const auto first = m_lines.fresh(m_talk, m_options.deadline);
  return first ? Result<void>{} : std::unexpected(first.error());
}

Result<TimedReading> AsciiBoard::fresh(std::size_t column) {
  if (m_streaming) {
    return m_talk.refused("the board is streaming", "stop the stream before asking for single readings");
  }
  const auto reading = m_lines.fresh(m_talk, m_options.deadline);
  if (!reading) {
    return std::unexpected(reading.error());
  }
  return TimedReading{reading->values[column], reading->timeS};
}

Result<TimedReading> AsciiBoard::readDeg() {
  auto reading = fresh(0);
  if (reading) {
    reading->value = wrapTurn(reading->value);
  }
  return reading;
}

Result<TimedReading> AsciiBoard::Reference::readDeg() {
  auto reading = m_board.fresh(m_board.referenceColumn());
  if (reading && m_board.m_options.unwrap) {
    reading->value = m_board.m_unwrap.follow(reading->value);
  }
  return reading;
}

Result<TimedReading> AsciiBoard::readC() { return fresh(m_options.temperatureColumn.value_or(0)); }

ReadingStream* AsciiBoard::angleReadings(InstrumentRole role) {
  if (role == InstrumentRole::AngleReference) {
    return &m_referenceReadings;
  }
  return role == InstrumentRole::AngleSensor ? &m_sensorReadings : nullptr;
}

} // namespace straightedge::devices
