// Pieces of JSON that a session's documents are made of. Inside of the documents: not for other folders.
#pragma once

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::gui {

inline std::unexpected<Error> unreadableDocument(const char* document) {
  return fail(ErrorKind::Storage, std::string("the session's \"") + document + "\" cannot be read",
              "go on with the default, or open a copy of the file");
}

/// A document as a JSON object; discarded where it is anything else.
inline nlohmann::json jsonObjectFrom(std::string_view text) {
  nlohmann::json parsed = nlohmann::json::parse(text, nullptr, false);
  return parsed.is_object() ? parsed : nlohmann::json(nlohmann::json::value_t::discarded);
}

/// False where there is a value that is no list of numbers; a list that is absent leaves `column` as it is.
template <typename T>
bool columnInto(const nlohmann::json& object, const char* key, std::vector<T>& column) {
  const auto found = object.find(key);
  if (found == object.end()) {
    return true;
  }
  if (!found->is_array() ||
      !std::all_of(found->begin(), found->end(), [](const nlohmann::json& value) { return value.is_number(); })) {
    return false;
  }
  column = found->template get<std::vector<T>>();
  return true;
}

template <typename T>
void columnFrom(nlohmann::json& object, const char* key, const std::vector<T>& column) {
  if (!column.empty()) {
    object[key] = column;
  }
}

inline double numberOr(const nlohmann::json& object, const char* key, double otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

inline std::string textOr(const nlohmann::json& object, const char* key, const std::string& otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

} // namespace straightedge::gui
