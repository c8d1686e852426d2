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

double degreesPer(std::string_view unit) {
  if (unit == "rad") {
    return 180.0 / std::numbers::pi;
  }
  return unit == "turn" ? 360.0 : 1.0;
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
  const std::string unit = reader.text("unit");
  LineColumn angle;
  angle.quantity = "angle";
  angle.index = reader.integer("column", 1, 64);
  angle.label = reader.text("label");
  angle.unit = reader.text("suffix");
  angle.scale = unit == "count" ? 360.0 / reader.number("counts_per_turn", 2, 1e12) : degreesPer(unit);
  options.format.columns.push_back(angle);
  if (const auto column = reader.numberIfGiven("temperature_column", 1, 64)) {
    LineColumn temperature;
    temperature.quantity = "temperature";
    temperature.index = static_cast<int>(*column);
    options.format.columns.push_back(temperature);
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
  auto reading = m_board.fresh(0);
  if (reading && m_board.m_options.unwrap) {
    reading->value = m_board.m_unwrap.follow(reading->value);
  }
  return reading;
}

Result<TimedReading> AsciiBoard::readC() { return fresh(1); }

Result<void> AsciiBoard::start() {
  auto started = m_lines.startStream(m_talk);
  m_streaming = started.has_value();
  m_told = m_lines.counts();
  return started;
}

Result<ReadingBlock> AsciiBoard::read() {
  const auto came = m_lines.waiting(m_talk);
  if (!came) {
    return std::unexpected(came.error());
  }
  ReadingBlock block;
  block.readings.reserve(came->size());
  for (const TimedValues& reading : *came) {
    block.readings.push_back({reading.values[0], reading.timeS});
  }
  block.rejected = m_lines.counts().rejected - m_told.rejected;
  m_told = m_lines.counts();
  return block;
}

Result<void> AsciiBoard::stop() {
  m_streaming = false;
  return {};
}

} // namespace straightedge::devices
