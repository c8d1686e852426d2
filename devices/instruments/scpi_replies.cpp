#include "devices/instruments/scpi_replies.h"

#include "core/base/number_text.h"

#include <array>
#include <cmath>

namespace straightedge::devices {

std::optional<InstrumentIdentity> parseIdentity(std::string_view reply) {
  std::array<std::string_view, 4> fields{};
  std::size_t count = 0;
  for (; count < fields.size(); ++count) {
    const std::size_t comma = count + 1 < fields.size() ? reply.find(',') : std::string_view::npos;
    fields[count] = withoutBlanks(reply.substr(0, comma));
    if (comma == std::string_view::npos) {
      ++count;
      break;
    }
    reply.remove_prefix(comma + 1);
  }
  if (count < 2 || fields[1].empty()) {
    return std::nullopt;
  }
  const std::string maker = fields[0].empty() ? "" : std::string(fields[0]) + " ";
  // A serial number of 0 is how instruments without one answer.
  return InstrumentIdentity{.model = maker + std::string(fields[1]),
                            .serial = fields[2] == "0" ? "" : std::string(fields[2]),
                            .firmware = std::string(fields[3])};
}

std::optional<ScpiError> parseScpiError(std::string_view reply) {
  const std::size_t comma = reply.find(',');
  const auto code = parseInt(reply.substr(0, comma));
  if (!code) {
    return std::nullopt;
  }
  std::string_view text = comma == std::string_view::npos ? std::string_view() : withoutBlanks(reply.substr(comma + 1));
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  return ScpiError{*code, std::string(text)};
}

std::optional<double> parseScpiNumber(std::string_view reply) {
  const auto value = parseDouble(reply);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

bool isScpiOverload(double value) { return std::abs(value) >= 9.9e37; }

Result<void> checkErrorQueue(Conversation& talk, std::string_view command, std::string_view after) {
  constexpr int longestQueue = 64;
  std::optional<ScpiError> first;
  for (int i = 0; i < longestQueue; ++i) {
    const auto reply = talk.ask(command);
    if (!reply) {
      return std::unexpected(reply.error());
    }
    const auto error = parseScpiError(reply->text);
    if (!error) {
      return talk.misunderstood(command, reply->text, "an error number and its text");
    }
    if (error->code == 0) {
      break;
    }
    first = first ? first : error;
  }
  if (first) {
    return talk.refused("the instrument reports error " + std::to_string(first->code) + " (" + first->text + ") " +
                            std::string(after),
                        "check its settings and its firmware");
  }
  return {};
}

} // namespace straightedge::devices
