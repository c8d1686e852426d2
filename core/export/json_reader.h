// JSON values taken one by one with the first thing wrong remembered, so that reading code stays straight.
// Private to the .cpp files of core/export: it alone includes nlohmann-json there.
#pragma once

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace straightedge::exporting {

/// What to do about a file that is not as it should be.
inline constexpr std::string_view angleFitAgain = "write the file anew with straightedge-cli angle fit";
inline constexpr std::string_view fieldFitAgain = "write the file anew with straightedge-cli field fit";

/// Parsed text. Errors (Input): FILE:LINE where the text stops being JSON; a number too large for a double.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& name,
                                 std::string_view remedy = angleFitAgain);

/// A value together with its path in the file ("models[1].values_deg").
struct JsonNode {
  const nlohmann::json* value = nullptr; ///< null: absent
  std::string path;

  explicit operator bool() const { return value != nullptr; }
  JsonNode optional(std::string_view key) const; ///< absent where the key is missing or null, or this is no object
  JsonNode item(std::size_t index) const;
  std::size_t size() const { return value == nullptr ? 0 : value->size(); }
};

/// Getters give a harmless value after the first problem; check problem() at the end, and before using sizes.
class JsonReader {
public:
  explicit JsonReader(std::string name, std::string_view remedy = angleFitAgain)
      : m_name(std::move(name)), m_remedy(remedy) {}

  JsonNode object(const JsonNode& parent, std::string_view key);
  JsonNode list(const JsonNode& parent, std::string_view key);
  double number(const JsonNode& parent, std::string_view key);
  long long integer(const JsonNode& parent, std::string_view key, long long least, long long most);
  std::string text(const JsonNode& parent, std::string_view key);
  bool truth(const JsonNode& parent, std::string_view key);

  bool requireObject(const JsonNode& node);
  double asNumber(const JsonNode& node);
  long long asInteger(const JsonNode& node, long long least, long long most);

  void blame(std::string what, std::string remedy);
  void blame(std::string what) { blame(std::move(what), m_remedy); }
  const std::optional<Error>& problem() const { return m_problem; }

private:
  JsonNode required(const JsonNode& parent, std::string_view key);
  void wrongType(const JsonNode& node, std::string_view wanted);

  std::string m_name;
  std::string m_remedy; ///< unless one is given
  std::optional<Error> m_problem;
};

} // namespace straightedge::exporting
