#include "core/field/names.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace straightedge::field {

namespace {

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return lower;
}

} // namespace

std::optional<Axis> parseAxis(std::string_view text) {
  const auto* const direct = std::ranges::find(allAxes, text, axisName);
  if (direct != allAxes.end()) {
    return *direct;
  }
  const std::string word = lowered(text);
  const auto* const found = std::ranges::find(allAxes, word, axisName);
  return found == allAxes.end() ? std::nullopt : std::optional(*found);
}

std::optional<Orientation> parseOrientation(std::string_view text) {
  std::string word = lowered(text);
  constexpr std::string_view minusSign = "\xE2\x88\x92"; // as a word processor writes it
  if (word.starts_with(minusSign)) {
    word.replace(0, minusSign.size(), "-");
  }
  if (word.size() == 1) {
    word.insert(0, "+");
  }
  const auto* const found = std::ranges::find(allOrientations, word, orientationName);
  return found == allOrientations.end() ? std::nullopt : std::optional(*found);
}

std::optional<CampaignStep> parseStep(std::string_view text) {
  const auto direct = std::ranges::find(allSteps, text, stepName);
  if (direct != allSteps.end()) {
    return *direct;
  }
  std::string word = lowered(text);
  std::ranges::replace(word, '_', '-');
  std::ranges::replace(word, ' ', '-');
  const auto* const found = std::ranges::find(allSteps, word, stepName);
  return found == allSteps.end() ? std::nullopt : std::optional(*found);
}

} // namespace straightedge::field
