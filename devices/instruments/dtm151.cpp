#include "devices/instruments/dtm151.h"

#include <utility>

namespace straightedge::devices {

namespace {

constexpr double settlingS = 0.1; ///< after a setter; it measures ten times a second

} // namespace

const std::vector<SettingDescription>& dtm151Settings() {
  static const std::vector<SettingDescription> all = {
      {"range", "Range", "3", "one of 0.3, 0.6, 1.2 and 3 tesla", {"0.3", "0.6", "1.2", "3"}},
      {"filter", "Digital filter", "yes", "yes or no", {"yes", "no"}}};
  return all;
}

Result<std::unique_ptr<Instrument>> Dtm151::make(Transport& transport, BenchClock& clock,
                                                 const SettingValues& settings) {
  SettingReader reader(settings, dtm151Settings(), "Group3 DTM-151");
  const std::string range = reader.text("range");
  const Options options{.range = range == "0.3"   ? 0
                                 : range == "0.6" ? 1
                                 : range == "1.2" ? 2
                                                  : 3,
                        .filter = reader.yes("filter")};
  if (reader.problem()) {
    return std::unexpected(*reader.problem());
  }
  return std::make_unique<Dtm151>(transport, clock, options);
}

Dtm151::Dtm151(Transport& transport, BenchClock& clock, const Options& options)
    : m_clock(clock), m_talk(transport, clock, {.commandEnd = "\r", .replyEnd = "\r", .deadline = Milliseconds{1000}}),
      m_options(options) {}

Result<void> Dtm151::expectReply(std::string_view query, std::string_view wanted) {
  const auto reply = m_talk.ask(query);
  if (!reply) {
    return std::unexpected(reply.error());
  }
  if (reply->text == wanted) {
    return {};
  }
  const auto number = parseDtm151Number(reply->text);
  if (!number && !number.error().empty()) {
    return m_talk.refused("the DTM-151 reports " + number.error() + " while it was set up",
                          "check its probe and choose another range");
  }
  return m_talk.misunderstood(query, reply->text, wanted);
}

Result<void> Dtm151::prepare() {
  // Echo off and no readings by itself, before anything is understood of what it sends. SU1 is answered by a bare line
  // feed on hardware (group3lib), which the next reply begins with.
  for (const std::string_view command : {"SE0", "SM0"}) {
    if (auto sent = m_talk.send(command); !sent) {
      return sent;
    }
  }
  m_clock.sleepS(settlingS);
  if (auto cleared = m_talk.clear(); !cleared) {
    return cleared;
  }
  const std::string range = std::to_string(m_options.range);
  for (const std::string& command : {std::string("SU1"), std::string("GD"), std::string("GC"), "R" + range,
                                     std::string(m_options.filter ? "D1" : "D0")}) {
    if (auto sent = m_talk.send(command); !sent) {
      return sent;
    }
    m_clock.sleepS(settlingS);
  }
  if (auto set = expectReply("IR", range); !set) {
    return set;
  }
  return expectReply("IG", "DC");
}

Result<FieldReferenceReading> Dtm151::readT() {
  const auto reply = m_talk.ask("F");
  if (!reply) {
    return std::unexpected(reply.error());
  }
  const auto number = parseDtm151Number(reply->text);
  if (!number && (number.error() == "OVER RANGE" || number.error() == "OVERFLOW")) {
    return FieldReferenceReading{.fieldT = {}, .locked = false, .timeS = reply->timeS};
  }
  if (!number && !number.error().empty()) {
    return m_talk.refused("the DTM-151 reports " + number.error(), "check its probe and its line");
  }
  // A number without its unit may be gauss: a factor of 10,000. Its DIP switches decide, and SU1 makes it say so.
  const double scale = !number                ? 0.0
                       : number->unit == "T"  ? 1.0
                       : number->unit == "G"  ? 1e-4
                       : number->unit == "kG" ? 0.1
                                              : 0.0;
  if (scale == 0.0) {
    return m_talk.misunderstood("F", reply->text, "a number with T, G or kG");
  }
  return FieldReferenceReading{.fieldT = number->value * scale, .locked = true, .timeS = reply->timeS};
}

Result<TimedReading> Dtm151::readC() {
  const auto reply = m_talk.ask("T");
  if (!reply) {
    return std::unexpected(reply.error());
  }
  const auto number = parseDtm151Number(reply->text);
  if (!number && !number.error().empty()) {
    return m_talk.refused("the DTM-151 reports " + number.error(), "use a probe with a thermometer");
  }
  if (!number || number->unit != "C") {
    return m_talk.misunderstood("T", reply->text, "a number with C");
  }
  return TimedReading{number->value, reply->timeS};
}

} // namespace straightedge::devices
