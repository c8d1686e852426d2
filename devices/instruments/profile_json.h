// JSON values of a profile taken one by one, the first thing wrong remembered with its line. Private to
// devices/instruments' .cpp files: they alone include nlohmann-json there.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/json_place.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

struct ProfileNode {
  const nlohmann::json* value = nullptr; ///< null: absent
  std::vector<std::string> path;

  explicit operator bool() const { return value != nullptr; }
  ProfileNode member(std::string_view key) const;
  ProfileNode item(std::size_t index) const;
  std::size_t size() const { return value == nullptr ? 0 : value->size(); }
};

/// Getters give a harmless value after the first problem.
class ProfileJson {
public:
  ProfileJson(std::string_view text, std::string file) : m_text(text), m_file(std::move(file)) {}

  /// Blames keys that are not among these, and values that are no object.
  bool object(const ProfileNode& node, const std::vector<std::string_view>& keys);
  /// A list or, in its place, one item alone.
  std::vector<ProfileNode> items(const ProfileNode& parent, std::string_view key);
  std::string text(const ProfileNode& parent, std::string_view key, std::string_view fallback);
  std::string requiredText(const ProfileNode& parent, std::string_view key);
  double number(const ProfileNode& parent, std::string_view key, double fallback, double least, double most);
  int integer(const ProfileNode& parent, std::string_view key, int fallback, int least, int most);
  bool truth(const ProfileNode& parent, std::string_view key, bool fallback);
  std::vector<std::string> texts(const ProfileNode& parent, std::string_view key);
  std::string asText(const ProfileNode& node);

  void blame(const ProfileNode& node, std::string what, std::string remedy = "see instrument.schema.json");
  const std::optional<Error>& problem() const { return m_problem; }

private:
  std::string_view m_text;
  std::string m_file;
  std::optional<Error> m_problem;
};

} // namespace straightedge::devices
