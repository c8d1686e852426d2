#include "core/angle/comparison.h"
#include "core/angle/messages.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <string>

namespace straightedge::angle {

namespace {

constexpr std::array kinds = {ModelKind::Harmonic, ModelKind::Linear, ModelKind::LookupTable};

/// The error that can be relied on: on the finer grid where it is known.
double judgedError(const ComparisonRow& row) { return row.maxErrorFineDeg.value_or(row.maxErrorDeg); }

bool needsLess(const ComparisonRow& left, const ComparisonRow& right) {
  if (left.storageEntries != right.storageEntries) {
    return left.storageEntries < right.storageEntries;
  }
  if (left.bytes != right.bytes) {
    return left.bytes < right.bytes;
  }
  return judgedError(left) < judgedError(right);
}

bool isMoreAccurate(const ComparisonRow& left, const ComparisonRow& right) {
  if (judgedError(left) != judgedError(right)) {
    return judgedError(left) < judgedError(right);
  }
  return needsLess(left, right);
}

/// Best row of every kind among those that meet the demand; of equals the first.
template <typename Meets, typename Better>
std::array<const ComparisonRow*, kinds.size()> bestOfKinds(const Comparison& comparison, Meets meets, Better better) {
  std::array<const ComparisonRow*, kinds.size()> best{};
  for (const ComparisonRow& row : comparison.rows) {
    const ComparisonRow*& candidate = best[static_cast<std::size_t>(row.name.kind)];
    if (meets(row) && (candidate == nullptr || better(row, *candidate))) {
      candidate = &row;
    }
  }
  return best;
}

template <typename Better>
const ComparisonRow* bestOf(const std::array<const ComparisonRow*, kinds.size()>& candidates, Better better) {
  const ComparisonRow* best = nullptr;
  for (const ComparisonRow* candidate : candidates) {
    if (candidate != nullptr && (best == nullptr || better(*candidate, *best))) {
      best = candidate;
    }
  }
  return best;
}

/// A demand as a person would write it: 0.5°, not 0.500°.
std::string demandText(double value) {
  std::string text = formatForPeople(value, 3);
  if (text.find('.') != std::string::npos && text.find('e') == std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text + "°";
}

std::string entriesText(int entries) { return std::to_string(entries) + (entries == 1 ? " entry" : " entries"); }

std::string storageText(const ComparisonRow& row) {
  return entriesText(row.storageEntries) + " (" + std::to_string(row.bytes) + " bytes)";
}

std::string runnersUpText(const std::vector<ComparisonRow>& runnersUp) {
  std::string text;
  for (const ComparisonRow& row : runnersUp) {
    text += (text.empty() ? "; runners-up: " : ", ") + row.name.text() + " with " + storageText(row) + ", " +
            degreesText(judgedError(row));
  }
  if (runnersUp.size() == 1) {
    text.replace(text.find("runners-up"), 10, "runner-up");
  }
  return text;
}

template <typename Meets, typename Better>
Recommendation recommend(const Comparison& comparison, Meets meets, Better better) {
  Recommendation result;
  const auto candidates = bestOfKinds(comparison, meets, better);
  const ComparisonRow* choice = bestOf(candidates, better);
  if (choice == nullptr) {
    return result;
  }
  result.choice = *choice;
  for (const ComparisonRow* candidate : candidates) {
    if (candidate != nullptr && candidate != choice) {
      const auto later = std::find_if(result.runnersUp.begin(), result.runnersUp.end(),
                                      [&](const ComparisonRow& other) { return better(*candidate, other); });
      result.runnersUp.insert(later, *candidate);
    }
  }
  return result;
}

} // namespace

Recommendation recommendForTarget(const Comparison& comparison, double targetErrorDeg) {
  Recommendation result = recommend(
      comparison, [targetErrorDeg](const ComparisonRow& row) { return judgedError(row) <= targetErrorDeg; }, needsLess);
  if (result.choice) {
    const ComparisonRow& choice = *result.choice;
    result.sentence = choice.name.text() + " meets " + demandText(targetErrorDeg) + " with " + storageText(choice) +
                      ", " + degreesText(judgedError(choice)) + " maximum error" + runnersUpText(result.runnersUp) +
                      ".";
    return result;
  }
  const Recommendation nearest = recommend(comparison, [](const ComparisonRow&) { return true; }, isMoreAccurate);
  result.sentence = "No model meets " + demandText(targetErrorDeg);
  if (nearest.choice) {
    result.sentence += "; the most accurate is " + nearest.choice->name.text() + " with " +
                       storageText(*nearest.choice) + " and " + degreesText(judgedError(*nearest.choice)) +
                       " maximum error";
  }
  result.sentence += ".";
  return result;
}

Recommendation recommendForBudget(const Comparison& comparison, int storageEntries) {
  Recommendation result = recommend(
      comparison, [storageEntries](const ComparisonRow& row) { return row.storageEntries <= storageEntries; },
      isMoreAccurate);
  if (result.choice) {
    const ComparisonRow& choice = *result.choice;
    result.sentence = choice.name.text() + " is the most accurate within " + entriesText(storageEntries) + ": " +
                      degreesText(judgedError(choice)) + " maximum error with " + storageText(choice) +
                      runnersUpText(result.runnersUp) + ".";
    return result;
  }
  const Recommendation smallest = recommend(comparison, [](const ComparisonRow&) { return true; }, needsLess);
  result.sentence = "No model fits into " + entriesText(storageEntries);
  if (smallest.choice) {
    result.sentence += "; the smallest is " + smallest.choice->name.text() + " with " + storageText(*smallest.choice);
  }
  result.sentence += ".";
  return result;
}

} // namespace straightedge::angle
