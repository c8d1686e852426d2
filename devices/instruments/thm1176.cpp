#include "devices/instruments/thm1176.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace straightedge::devices {

namespace {

constexpr std::string_view errorQueue = ":SYST:ERR?";
constexpr Milliseconds zeroingTime{15'000}; // CAL takes about 6 s

/// One measurement of all axes with its time, temperature and status in one reply. Joined with ; it is answered as one
/// message.
constexpr std::string_view measure =
    ":FETC:ARR:X? 1,5;:FETC:ARR:Y? 1,5;:FETC:ARR:Z? 1,5;:FETC:TIMESTAMP?;:FETC:TEMPERATURE?;*STB?";

/// Averaging of the largest count at its slowest rate stays far below this.
constexpr Milliseconds longestMeasurement{5'000};

constexpr int errorQueueBit = 4;

/// A reading this far beyond the range is none, whatever the instrument says of it.
constexpr double mostOfRange = 1.1;

} // namespace

const std::vector<SettingDescription>& thm1176Settings() {
  static const std::vector<SettingDescription> all = {
      {"range", "Range", "3", "one of auto, 0.1, 0.3, 1 and 3 tesla", {"auto", "0.1", "0.3", "1", "3"}},
      {"averages", "Readings averaged", "100", "1 to 10000"},
      {"celsius_per_count", "°C per count of its temperature", "",
       "the slope of its thermometer as you calibrated it; empty: its temperature is not used"},
      {"celsius_at_zero", "°C at count 0", "0", "-1000 to 1000"}};
  return all;
}

Result<std::unique_ptr<Instrument>> Thm1176::make(Transport& transport, BenchClock& clock,
                                                  const SettingValues& settings) {
  SettingReader reader(settings, thm1176Settings(), "Metrolab THM1176");
  Options options;
  options.rangeT = reader.text("range") == "auto" ? std::nullopt : std::optional(reader.number("range", 0.1, 3.0));
  options.averages = reader.integer("averages", 1, 10000);
  options.celsiusPerCount = reader.numberIfGiven("celsius_per_count", -100.0, 100.0);
  options.celsiusAtZero = reader.number("celsius_at_zero", -1000.0, 1000.0);
  if (reader.problem()) {
    return std::unexpected(*reader.problem());
  }
  return std::make_unique<Thm1176>(transport, clock, options);
}

Thm1176::Thm1176(Transport& transport, const BenchClock& clock, const Options& options)
    : m_talk(transport, clock, {.deadline = Milliseconds{2000}}), m_options(options) {}

Result<void> Thm1176::prepare() {
  m_lastReply.reset();
  if (auto cleared = m_talk.clear(); !cleared) {
    return cleared;
  }
  // While it waits for a BUS trigger, ranges and INIT are illegal (manual p. 45): end that first.
  for (const std::string_view command : {":ABOR", "*CLS"}) {
    if (auto sent = m_talk.send(command); !sent) {
      return sent;
    }
  }
  const auto reply = m_talk.ask("*IDN?");
  if (!reply) {
    return std::unexpected(reply.error());
  }
  const auto identity = parseIdentity(reply->text);
  const bool known = identity && (identity->model.find("THM1176") != std::string::npos ||
                                  identity->model.find("TFM1186") != std::string::npos);
  if (!known) {
    return m_talk.misunderstood("*IDN?", reply->text, "a THM1176 or TFM1186");
  }
  m_identity = *identity;
  const std::string range =
      m_options.rangeT ? ":SENS:FLUX:RANG:UPP " + formatDouble(*m_options.rangeT) + " T" : ":SENS:FLUX:RANG:AUTO ON";
  std::vector<std::string> commands;
  if (m_options.rangeT) {
    commands.emplace_back(":SENS:FLUX:RANG:AUTO OFF");
  }
  commands.insert(commands.end(), {range, ":FORM:DATA ASCII", ":AVER:COUN " + std::to_string(m_options.averages),
                                   ":TRIG:SOUR IMM", ":TRIG:COUN 1"});
  for (const std::string& command : commands) {
    if (auto sent = m_talk.send(command); !sent) {
      return sent;
    }
  }
  return checkErrorQueue(m_talk, errorQueue, "while it was set up");
}

Result<FieldReading> Thm1176::readT() {
  if (auto begun = m_talk.send(":INIT"); !begun) {
    return std::unexpected(std::move(begun.error()));
  }
  const auto answer = m_talk.ask(measure, longestMeasurement);
  if (!answer) {
    return std::unexpected(answer.error());
  }
  const auto reply = parseThm1176Reply(answer->text);
  if (!reply) {
    // An error may have taken the place of the readings; the queue knows more than the text.
    if (auto queue = checkErrorQueue(m_talk, errorQueue, "instead of a reading"); !queue && !m_talk.lastFault()) {
      return std::unexpected(std::move(queue.error()));
    }
    return m_talk.misunderstood(measure, answer->text, "three fields in tesla, time, temperature and status");
  }
  m_lastReply = reply;
  if ((reply->status & errorQueueBit) != 0) {
    if (auto queue = checkErrorQueue(m_talk, errorQueue, "with a reading"); !queue) {
      return std::unexpected(std::move(queue.error()));
    }
  }
  FieldReading reading{.rawT = reply->fieldT, .timeS = answer->timeS, .overRange = reply->overload, .electronicsC = {}};
  const double mostT = m_options.rangeT.value_or(3.0) * mostOfRange;
  reading.overRange =
      reading.overRange || std::ranges::any_of(reading.rawT, [&](double fieldT) { return std::abs(fieldT) > mostT; });
  if (m_options.celsiusPerCount) {
    reading.electronicsC =
        m_options.celsiusAtZero + *m_options.celsiusPerCount * static_cast<double>(reply->temperature);
  }
  return reading;
}

Result<void> Thm1176::zero() {
  if (auto begun = m_talk.send(":CAL:INIT"); !begun) {
    return begun;
  }
  const auto done = m_talk.ask("*OPC?", zeroingTime);
  if (!done) {
    return std::unexpected(done.error());
  }
  return checkErrorQueue(m_talk, errorQueue, "while it was zeroed");
}

} // namespace straightedge::devices
