// Keys that may be absent: files of others, and of other versions. Private to the .cpp files of core/export.
#pragma once

#include "core/export/json_reader.h"

#include <optional>
#include <string>
#include <string_view>

namespace straightedge::exporting {

inline constexpr long long largestCount = 1LL << 52U;

/// Several keys of a file that others wrote may be absent; what they stand for is then simply not known.
inline std::string textIfAny(JsonReader& reader, const JsonNode& parent, std::string_view key) {
  return parent.optional(key) ? reader.text(parent, key) : std::string();
}

inline double numberIfAny(JsonReader& reader, const JsonNode& parent, std::string_view key, double otherwise = 0.0) {
  return parent.optional(key) ? reader.number(parent, key) : otherwise;
}

inline std::optional<double> optionalNumber(JsonReader& reader, const JsonNode& parent, std::string_view key) {
  return parent.optional(key) ? std::optional(reader.number(parent, key)) : std::nullopt;
}

/// A list if the key is there; no list otherwise.
inline JsonNode listIfAny(JsonReader& reader, const JsonNode& parent, std::string_view key) {
  const JsonNode node = parent.optional(key);
  return node ? reader.list(parent, key) : node;
}

inline JsonNode objectIfAny(JsonReader& reader, const JsonNode& parent, std::string_view key) {
  const JsonNode node = parent.optional(key);
  return node ? reader.object(parent, key) : node;
}

template <typename Words>
auto readWord(JsonReader& reader, const JsonNode& parent, std::string_view key, const Words& words) {
  const std::string text = reader.text(parent, key);
  std::string allowed;
  for (const auto& [value, word] : words) {
    if (word == text) {
      return value;
    }
    allowed += (allowed.empty() ? "\"" : ", \"") + std::string(word) + "\"";
  }
  reader.blame(parent.optional(key).path + " is \"" + text + "\" but must be one of " + allowed);
  return words.front().first;
}

} // namespace straightedge::exporting
