#include "devices/instruments/scpi_multimeter.h"

#include "core/base/number_text.h"
#include "devices/instruments/angle_unwrap.h"

namespace straightedge::devices {

namespace {

/// 100 power line cycles at 50 Hz are 2 s, twice that with autozero.
constexpr Milliseconds longestReading{10'000};

std::string configure(const std::string& function, const std::string& range) {
  const char* command = function == "ohm-4-wire" ? "CONF:FRES" : function == "ohm-2-wire" ? "CONF:RES" : "CONF:VOLT:DC";
  return range.empty() ? command : std::string(command) + " " + range;
}

} // namespace

const std::vector<SettingDescription>& scpiMultimeterSettings() {
  static const std::vector<SettingDescription> all = {
      {"function",
       "Measures",
       "ohm-4-wire",
       "ohm-4-wire or ohm-2-wire for a PT100, volt for an analogue angle sensor",
       {"ohm-4-wire", "ohm-2-wire", "volt"}},
      {"range", "Range", "", "the largest value expected in ohms or volts; empty: automatic"},
      {"power_line_cycles",
       "Integration in power line cycles",
       "10",
       "one of 0.02, 0.2, 1, 10 and 100",
       {"0.02", "0.2", "1", "10", "100"}},
      {"deg_per_volt", "Degrees per volt", "72", "72 for a sensor of 0 to 5 V a turn"},
      {"offset_deg", "Angle at 0 V in degrees", "0", "-360 to 360 degrees"}};
  return all;
}

Result<std::unique_ptr<Instrument>> ScpiMultimeter::make(Transport& transport, BenchClock& clock,
                                                         const SettingValues& settings) {
  SettingReader reader(settings, scpiMultimeterSettings(), "SCPI multimeter");
  const std::string function = reader.text("function");
  const auto range = reader.numberIfGiven("range", 1e-3, 1e9);
  Options options{.volts = function == "volt",
                  .setUp = configure(function, range ? formatDouble(*range) : ""),
                  .powerLineCycles = reader.number("power_line_cycles", 0.02, 100.0),
                  .degPerVolt = reader.number("deg_per_volt", -1e6, 1e6),
                  .offsetDeg = reader.number("offset_deg", -360.0, 360.0)};
  if (reader.problem()) {
    return std::unexpected(*reader.problem());
  }
  return std::make_unique<ScpiMultimeter>(transport, clock, std::move(options));
}

ScpiMultimeter::ScpiMultimeter(Transport& transport, const BenchClock& clock, Options options)
    : m_talk(transport, clock, {.deadline = Milliseconds{2000}}), m_options(std::move(options)) {}

Result<void> ScpiMultimeter::prepare() {
  if (auto cleared = m_talk.clear(); !cleared) {
    return cleared;
  }
  // Over RS-232 it takes commands only after this one; over USB it is an error it forgets with *CLS.
  if (!m_talk.transport().hasMessages()) {
    if (auto remote = m_talk.send(":SYST:REM"); !remote) {
      return remote;
    }
  }
  if (auto cleared = m_talk.send("*CLS"); !cleared) {
    return cleared;
  }
  const auto reply = m_talk.ask("*IDN?");
  if (!reply) {
    return std::unexpected(reply.error());
  }
  const auto identity = parseIdentity(reply->text);
  if (!identity) {
    return m_talk.misunderstood("*IDN?", reply->text, "maker, model, serial number and firmware");
  }
  m_identity = *identity;
  const std::string cycles = std::string(m_options.volts                            ? "VOLT:DC"
                                         : m_options.setUp.starts_with("CONF:FRES") ? "FRES"
                                                                                    : "RES") +
                             ":NPLC " + formatDouble(m_options.powerLineCycles);
  for (const std::string_view command : {std::string_view(m_options.setUp), std::string_view(cycles),
                                         std::string_view("TRIG:SOUR IMM"), std::string_view("SAMP:COUN 1")}) {
    if (auto sent = m_talk.send(command); !sent) {
      return sent;
    }
  }
  return checkErrorQueue(m_talk, "SYST:ERR?", "while it was set up");
}

Result<TimedReading> ScpiMultimeter::read() {
  const auto reply = m_talk.ask("READ?", longestReading);
  if (!reply) {
    return std::unexpected(reply.error());
  }
  const auto value = parseScpiNumber(reply->text);
  if (!value) {
    return m_talk.misunderstood("READ?", reply->text, "one number");
  }
  if (isScpiOverload(*value)) {
    return m_talk.refused("the multimeter is overloaded",
                          m_options.volts ? "choose a larger range"
                                          : "check the wires of the PT100, or choose a larger range");
  }
  return TimedReading{*value, reply->timeS};
}

Result<TimedReading> ScpiMultimeter::readDeg() {
  auto reading = read();
  if (reading) {
    reading->value = wrapTurn(m_options.offsetDeg + m_options.degPerVolt * reading->value);
  }
  return reading;
}

} // namespace straightedge::devices
