#include "devices/instruments/qsb.h"

#include <array>
#include <charconv>
#include <utility>

namespace straightedge::devices {

namespace {

constexpr std::uint8_t registerQuadrature = 0x03;
constexpr std::uint8_t registerDirection = 0x04;
constexpr std::uint8_t registerThreshold = 0x0B;
constexpr std::uint8_t registerInterval = 0x0C;
constexpr std::uint8_t registerStampReset = 0x0D;
constexpr std::uint8_t registerCount = 0x0E;
constexpr std::uint8_t registerVersion = 0x14;
constexpr std::uint8_t registerReplyFormat = 0x15;

constexpr Milliseconds patience{2000}; // it answers within milliseconds; a busy computer may not
/// Arrivals of a stream that are taken in one go.
constexpr int mostStreamReads = 128;
constexpr int mostForeignReplies = 200; ///< stream lines and banner that may come before the reply to a command

/// The manual's text says 1/256 s for the stamp in one place and 1/512 s in another. 1.95 ms for the interval and a
/// rollover after 94.5 days (Qsb.cs) are 1/512.
constexpr double stampTickS = 1.0 / 512;

/// The manual says bit 8; Qsb.cs writes 0x80. The manual's is taken. Not yet tried on hardware.
constexpr std::uint32_t directionDown = 0x100;

std::string hexText(std::uint32_t value, std::size_t digits) {
  std::array<char, 8> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, 16).ptr;
  std::string text(buffer.data(), end);
  for (char& c : text) {
    c = c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

} // namespace

const std::vector<SettingDescription>& qsbSettings() {
  static const std::vector<SettingDescription> all = {
      {"counts_per_turn", "Counts per turn", "", "4 times the encoder's cycles per revolution, for example 10000"},
      {"direction", "Direction", "up", "up or down", {"up", "down"}}};
  return all;
}

Result<std::unique_ptr<Instrument>> Qsb::make(Transport& transport, BenchClock& clock, const SettingValues& settings) {
  SettingReader reader(settings, qsbSettings(), "US Digital QSB");
  const double countsPerTurn = reader.number("counts_per_turn", 4, 1e9);
  const bool down = reader.text("direction") == "down";
  if (reader.problem()) {
    return std::unexpected(*reader.problem());
  }
  return std::make_unique<Qsb>(transport, clock, 360.0 / countsPerTurn, down);
}

Qsb::Qsb(Transport& transport, const BenchClock& clock, double degPerCount, bool countDown)
    : m_talk(transport, clock, {.commandEnd = "\r\n", .replyEnd = "!", .deadline = patience}),
      m_degPerCount(degPerCount), m_countDown(countDown), m_times(stampTickS) {}

/// The reply to this command; stream lines and the banner of a reset ("QSB-D  0E!") that come before it are passed
/// over, and `unreadable` others, where the line was emptied in the middle of one.
Result<Qsb::Answer> Qsb::ask(std::string_view command, int unreadable) {
  const auto kind = static_cast<char>(command[0] - 'A' + 'a');
  auto reply = m_talk.ask(command);
  for (int foreign = 0; reply; ++foreign) {
    const auto parsed = parseQsbReply(reply->text);
    if (parsed && parsed->kind == kind && hexText(parsed->reg, 2) == command.substr(1, 2)) {
      return Answer{*parsed, reply->timeS};
    }
    if (parsed && (parsed->kind == 'e' || parsed->kind == 'x')) {
      return m_talk.refused("the QSB refuses " + shown(command) + " with " + shown(reply->text),
                            "check that it is a QSB with firmware 10 or later");
    }
    const bool banner = !parsed && reply->text.starts_with("QSB");
    const bool passable = (parsed && parsed->kind == 's') || banner || (!parsed && unreadable-- > 0);
    if (!passable || foreign == mostForeignReplies) {
      return m_talk.misunderstood(command, reply->text, "register, 8 hexadecimal digits and '!'");
    }
    reply = m_talk.receive(patience);
  }
  return std::unexpected(std::move(reply.error()));
}

Result<void> Qsb::write(std::uint8_t reg, std::uint32_t value) {
  const std::string command = "W" + hexText(reg, 2) + hexText(value, reg == registerReplyFormat ? 8 : 1);
  const auto answer = ask(command);
  if (!answer) {
    return std::unexpected(answer.error());
  }
  return {};
}

Result<void> Qsb::prepare() {
  m_streaming = false;
  m_counted = false;
  m_stream.clear();
  if (auto cleared = m_talk.clear(); !cleared) {
    return cleared;
  }
  // A stream of an earlier program ends with the first read of its register.
  if (auto stopped = ask("R0E", 1); !stopped) {
    return std::unexpected(std::move(stopped.error()));
  }
  if (auto written = write(registerReplyFormat, 0x0F); !written) { // line feed, return, stamp, blanks
    return written;
  }
  const auto version = ask("R14");
  if (!version) {
    return std::unexpected(version.error());
  }
  // 5 digits of serial number, 1 of type, 2 of firmware.
  const std::string digits = hexText(version->reply.data, 8);
  const char type = digits[5];
  m_identity = {.model = type == '0'   ? "US Digital QSB-D"
                         : type == '1' ? "US Digital QSB-M"
                                       : "US Digital QSB-S",
                .serial = digits.substr(0, 5),
                .firmware = digits.substr(6, 2)};
  struct Setting {
    std::uint8_t reg;
    std::uint32_t value;
  };
  for (const Setting& setting : {
           Setting{registerQuadrature, 3}, // four counts a cycle, free running
           Setting{registerDirection, m_countDown ? directionDown : 0U},
           Setting{registerThreshold, 0}, // stream every reading, changed or not
           Setting{registerInterval, 1},  // 1.95 ms
           Setting{registerStampReset, 1},
       }) {
    if (auto written = write(setting.reg, setting.value); !written) {
      return written;
    }
  }
  return {};
}

double Qsb::degrees(std::uint32_t count) {
  // Two's complement; the difference survives a rollover of the register.
  m_unwrapped =
      m_counted ? m_unwrapped + static_cast<std::int32_t>(count - m_lastCount) : static_cast<std::int32_t>(count);
  m_lastCount = count;
  m_counted = true;
  return static_cast<double>(m_unwrapped) * m_degPerCount;
}

Result<TimedReading> Qsb::readDeg() {
  if (m_streaming) {
    return m_talk.refused("the QSB is streaming", "stop the stream before asking for single readings");
  }
  const auto answer = ask("R0E");
  if (!answer) {
    return std::unexpected(answer.error());
  }
  return TimedReading{degrees(answer->reply.data), answer->timeS};
}

Result<void> Qsb::start() {
  m_stream.clear();
  m_times.restart();
  m_streamFault.reset();
  const auto answer = ask("S0E");
  m_streaming = answer.has_value();
  return answer ? Result<void>{} : std::unexpected(answer.error());
}

Result<double> Qsb::receiveStream() {
  double arrivedS = m_talk.clock().nowS();
  if (const auto fault = std::exchange(m_streamFault, std::nullopt)) {
    return m_talk.failed(*fault, "while streaming");
  }
  for (int i = 0; i < mostStreamReads; ++i) {
    auto bytes = m_talk.transport().read(Milliseconds{0});
    if (!bytes && bytes.error().fault == TransportFault::TimedOut) {
      break;
    }
    if (!bytes && i == 0) {
      return m_talk.failed(bytes.error(), "while streaming");
    }
    if (!bytes) {
      m_streamFault = std::move(bytes.error());
      break;
    }
    arrivedS = m_talk.clock().nowS();
    m_stream.append(*bytes);
  }
  return arrivedS;
}

Result<ReadingBlock> Qsb::read() {
  const auto arrivedS = receiveStream();
  if (!arrivedS) {
    return std::unexpected(arrivedS.error());
  }
  ReadingBlock block;
  std::vector<std::uint32_t> stamps;
  while (const auto line = m_stream.takeThrough("!")) {
    const auto reply = parseQsbReply(*line);
    if (reply && reply->kind == 's' && reply->reg == registerCount && reply->stamp) {
      block.readings.push_back({degrees(reply->data), 0.0});
      stamps.push_back(*reply->stamp);
    } else {
      ++block.rejected;
    }
  }
  const auto times = m_times.place(stamps, *arrivedS);
  for (std::size_t i = 0; i < times.size(); ++i) {
    block.readings[i].timeS = times[i];
  }
  return block;
}

Result<void> Qsb::stop() {
  m_streaming = false;
  m_stream.clear();
  if (auto cleared = m_talk.clear(); !cleared) {
    return cleared;
  }
  const auto answer = ask("R0E", 1);
  return answer ? Result<void>{} : std::unexpected(answer.error());
}

} // namespace straightedge::devices
