#include "devices/instruments/pt2025.h"

#include <array>

namespace straightedge::devices {

namespace {

constexpr std::string_view enquiry = "\x05";
constexpr double commandPauseS = 0.05; ///< it loses commands that follow faster
constexpr int statusTries = 5;
constexpr unsigned syntaxErrorBit = 1U << 2U;
constexpr unsigned hardwareErrorBit = 1U << 3U;

} // namespace

const std::vector<SettingDescription>& pt2025Settings() {
  static const std::vector<SettingDescription> all = {
      {"probe", "Probe channel", "A", "A to H", {"A", "B", "C", "D", "E", "F", "G", "H"}},
      {"mode", "Mode", "automatic", "automatic or manual", {"automatic", "manual"}},
      {"field_sense", "Sense of the field", "positive", "positive or negative", {"positive", "negative"}},
      {"coarse", "Coarse setting", "", "0 to 4095; empty: as it is set at the instrument"},
      {"search", "Search from the coarse setting", "no", "yes or no", {"yes", "no"}},
      {"display", "Display", "normal", "normal or fast", {"normal", "fast"}}};
  return all;
}

Result<std::unique_ptr<Instrument>> Pt2025::make(Transport& transport, BenchClock& clock,
                                                 const SettingValues& settings) {
  SettingReader reader(settings, pt2025Settings(), "Metrolab PT2025");
  const auto coarse = reader.numberIfGiven("coarse", 0, 4095);
  Options options{.probe = reader.text("probe").front(),
                  .automatic = reader.text("mode") == "automatic",
                  .negative = reader.text("field_sense") == "negative",
                  .coarse = coarse ? std::to_string(static_cast<int>(*coarse)) : "",
                  .search = reader.yes("search"),
                  .fastDisplay = reader.text("display") == "fast"};
  if (options.search && options.coarse.empty()) {
    reader.blame("search", "is yes without a coarse setting to search from");
  }
  if (reader.problem()) {
    return std::unexpected(*reader.problem());
  }
  return std::make_unique<Pt2025>(transport, clock, std::move(options));
}

Pt2025::Pt2025(Transport& transport, BenchClock& clock, Options options)
    : m_clock(clock), m_talk(transport, clock, {.commandEnd = "", .replyEnd = "\r\n", .deadline = Milliseconds{1000}}),
      m_options(std::move(options)) {}

Result<void> Pt2025::command(std::string_view text) {
  auto sent = m_talk.send(text);
  if (sent) {
    m_clock.sleepS(commandPauseS);
  }
  return sent;
}

Result<unsigned> Pt2025::status(int reg) {
  const std::string query = "S" + std::to_string(reg);
  std::string last;
  for (int i = 0; i < statusTries; ++i) {
    const auto reply = m_talk.ask(query);
    if (!reply) {
      return std::unexpected(reply.error());
    }
    if (const auto bits = parsePt2025Status(reply->text)) {
      return *bits;
    }
    // It may answer with a field instead (fsc2): ask again, but only then.
    if (!parsePt2025Reading(reply->text)) {
      return m_talk.misunderstood(query, reply->text, "S and hexadecimal digits");
    }
    last = reply->text;
    m_clock.sleepS(commandPauseS);
  }
  return m_talk.misunderstood(query, last,
                              "S and hexadecimal digits, " + std::to_string(statusTries) + " times in a row");
}

Result<void> Pt2025::prepare() {
  if (auto cleared = m_talk.clear(); !cleared) {
    return cleared;
  }
  // One-letter commands run without an end (real session); C and H need one.
  std::vector<std::string> commands = {"R",
                                       "D1",
                                       std::string("P") + m_options.probe,
                                       m_options.negative ? "F0" : "F1",
                                       m_options.automatic ? "A1" : "A0",
                                       m_options.fastDisplay ? "V1" : "V0"};
  if (!m_options.coarse.empty()) {
    std::string digits = m_options.coarse;
    digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
    commands.push_back((m_options.search ? "H" : "C") + digits + "\r\n");
  }
  for (const std::string& text : commands) {
    if (auto sent = command(text); !sent) {
      return sent;
    }
  }
  const auto bits = status(1);
  if (!bits) {
    return std::unexpected(bits.error());
  }
  if ((*bits & hardwareErrorBit) != 0) {
    return m_talk.refused("the PT2025 reports a hardware error", "switch it off and on, and check the probe's cable");
  }
  if ((*bits & syntaxErrorBit) != 0) {
    return m_talk.refused("the PT2025 did not understand how it was set up", "switch it off and on");
  }
  return {};
}

Result<Pt2025Reading> Pt2025::reading(double& timeS) {
  const auto reply = m_talk.ask(enquiry);
  if (!reply) {
    return std::unexpected(reply.error());
  }
  const auto parsed = parsePt2025Reading(reply->text);
  if (!parsed) {
    return m_talk.misunderstood(enquiry, reply->text, "L, S, N or W, a number, and T or F");
  }
  timeS = reply->timeS;
  return *parsed;
}

Result<FieldReferenceReading> Pt2025::readT() {
  double timeS = 0.0;
  auto shown = reading(timeS);
  if (shown && !shown->tesla) {
    // Somebody switched to MHz at the instrument. Its own constant from MHz to tesla is not confirmed: it is to
    // convert.
    if (auto sent = command("D1"); !sent) {
      return std::unexpected(std::move(sent.error()));
    }
    shown = reading(timeS);
  }
  if (!shown) {
    return std::unexpected(std::move(shown.error()));
  }
  const bool locked = shown->state == NmrState::Locked;
  if (locked && !shown->tesla) {
    return m_talk.refused("the PT2025 shows MHz and does not change to tesla",
                          "press LOCAL, choose tesla, and try again");
  }
  return FieldReferenceReading{
      .fieldT = locked ? std::optional(shown->value) : std::nullopt, .locked = locked, .timeS = timeS};
}

} // namespace straightedge::devices
