// What can be chosen about an instrument, as text by key: the window makes a form of it, a saved bench keeps it.
#pragma once

#include "core/base/error.h"

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

/// Values by key; a key that is missing has its description's default.
using SettingValues = std::map<std::string, std::string, std::less<>>;

struct SettingDescription {
  std::string_view key;                       ///< "counts_per_turn"
  std::string_view label;                     ///< for people: "Counts per turn"
  std::string_view fallback;                  ///< the default; empty where it must be given, or where nothing is chosen
  std::string_view help;                      ///< one clause
  std::vector<std::string_view> choices = {}; ///< empty: free text
};

/// Values checked one by one, the first problem remembered: a default after it. Errors are of kind Usage.
class SettingReader {
public:
  /// Keys that no description has are a problem: a misspelt setting must not go by silently.
  SettingReader(const SettingValues& values, const std::vector<SettingDescription>& descriptions, std::string where);

  std::string text(std::string_view key);
  double number(std::string_view key, double least, double most);
  int integer(std::string_view key, int least, int most);
  std::optional<double> numberIfGiven(std::string_view key, double least, double most);
  bool yes(std::string_view key); ///< "yes" or "no"

  void blame(std::string_view key, const std::string& what);
  const std::optional<Error>& problem() const { return m_problem; }

private:
  const SettingDescription* find(std::string_view key) const;

  const SettingValues& m_values;
  const std::vector<SettingDescription>& m_descriptions;
  std::string m_where;
  std::optional<Error> m_problem;
};

} // namespace straightedge::devices
