#include "devices/instruments/profile_json.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace straightedge::devices {

namespace {

constexpr std::size_t longestText = 2000;

std::string nameOf(const ProfileNode& node) {
  std::string name;
  for (const std::string& step : node.path) {
    name += (name.empty() ? "" : ".") + step;
  }
  return name.empty() ? "the profile" : name;
}

} // namespace

ProfileNode ProfileNode::member(std::string_view key) const {
  ProfileNode child{nullptr, path};
  child.path.emplace_back(key);
  if (value != nullptr && value->is_object()) {
    const auto found = value->find(std::string(key));
    child.value = found != value->end() ? &*found : nullptr;
  }
  return child;
}

ProfileNode ProfileNode::item(std::size_t index) const {
  ProfileNode child{&(*value)[index], path};
  child.path.push_back(std::to_string(index));
  return child;
}

void ProfileJson::blame(const ProfileNode& node, std::string what, std::string remedy) {
  if (!m_problem) {
    m_problem = Error{ErrorKind::Input, nameOf(node) + " " + std::move(what), std::move(remedy),
                      m_file + ":" + std::to_string(lineInJson(m_text, node.path))};
  }
}

bool ProfileJson::object(const ProfileNode& node, const std::vector<std::string_view>& keys) {
  if (!node || !node.value->is_object()) {
    blame(node, node ? "is no JSON object" : "is missing");
    return false;
  }
  for (const auto& [key, value] : node.value->items()) {
    if (std::ranges::find(keys, key) == keys.end()) {
      std::string known;
      for (const std::string_view name : keys) {
        known += (known.empty() ? "" : ", ") + std::string(name);
      }
      blame(node.member(key), "is no key that is known here", "use one of " + known);
      return false;
    }
  }
  return true;
}

std::vector<ProfileNode> ProfileJson::items(const ProfileNode& parent, std::string_view key) {
  const ProfileNode node = parent.member(key);
  if (!node) {
    return {};
  }
  if (!node.value->is_array()) {
    return {node};
  }
  constexpr std::size_t most = 100;
  if (node.size() > most) {
    blame(node, "has " + std::to_string(node.size()) + " items", "leave at most " + std::to_string(most));
    return {};
  }
  std::vector<ProfileNode> all;
  all.reserve(node.size());
  for (std::size_t i = 0; i < node.size(); ++i) {
    all.push_back(node.item(i));
  }
  return all;
}

std::string ProfileJson::asText(const ProfileNode& node) {
  if (!node.value->is_string()) {
    blame(node, "is no text", "put it in quotes");
    return {};
  }
  auto content = node.value->get<std::string>();
  if (content.size() > longestText) {
    blame(node, "is longer than " + std::to_string(longestText) + " bytes", "shorten it");
    return {};
  }
  return content;
}

std::string ProfileJson::text(const ProfileNode& parent, std::string_view key, std::string_view fallback) {
  const ProfileNode node = parent.member(key);
  return node ? asText(node) : std::string(fallback);
}

std::string ProfileJson::requiredText(const ProfileNode& parent, std::string_view key) {
  const ProfileNode node = parent.member(key);
  if (!node) {
    blame(node, "is missing");
    return {};
  }
  std::string content = asText(node);
  if (content.empty()) {
    blame(node, "is empty");
  }
  return content;
}

double ProfileJson::number(const ProfileNode& parent, std::string_view key, double fallback, double least,
                           double most) {
  const ProfileNode node = parent.member(key);
  if (!node) {
    return fallback;
  }
  const double value = node.value->is_number() ? node.value->get<double>() : std::nan("");
  if (!(value >= least && value <= most)) {
    const bool anyIsGood = most == std::numeric_limits<double>::max();
    blame(node, anyIsGood ? "is no number" : "is no number from " + formatDouble(least) + " to " + formatDouble(most));
    return fallback;
  }
  return value;
}

int ProfileJson::integer(const ProfileNode& parent, std::string_view key, int fallback, int least, int most) {
  const double value = number(parent, key, fallback, least, most);
  if (std::floor(value) != value) {
    blame(parent.member(key), "is no whole number");
    return fallback;
  }
  return static_cast<int>(value);
}

bool ProfileJson::truth(const ProfileNode& parent, std::string_view key, bool fallback) {
  const ProfileNode node = parent.member(key);
  if (node && !node.value->is_boolean()) {
    blame(node, "is neither true nor false");
    return fallback;
  }
  return node ? node.value->get<bool>() : fallback;
}

std::vector<std::string> ProfileJson::texts(const ProfileNode& parent, std::string_view key) {
  std::vector<std::string> all;
  for (const ProfileNode& node : items(parent, key)) {
    all.push_back(asText(node));
  }
  return all;
}

} // namespace straightedge::devices
