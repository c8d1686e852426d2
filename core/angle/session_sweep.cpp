#include "core/angle/session_sweep.h"

#include "core/angle/sweep_csv.h"
#include "core/base/sha256.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace straightedge::angle {

namespace {

/// Rows that the review switched off; a review that does not fit the samples was made of other ones and is left out.
void applyReview(Sweep& sweep, const std::string& review) {
  const auto json = nlohmann::json::parse(review, nullptr, false);
  const auto off = json.is_object() ? json.find("switched_off") : json.end();
  if (!json.is_object() || off == json.end() || !off->is_array()) {
    return;
  }
  std::vector<bool> enabled(sweep.size(), true);
  for (const auto& row : *off) {
    if (!row.is_number_unsigned() || row.get<std::size_t>() >= sweep.size()) {
      return;
    }
    enabled[row.get<std::size_t>()] = false;
  }
  sweep.enabled = std::move(enabled);
}

} // namespace

Sweep sweepFromSamples(const std::vector<session::AngleSample>& samples) {
  std::unordered_map<int, int> latest;
  bool warm = !samples.empty();
  for (const session::AngleSample& sample : samples) {
    int& attempt = latest.try_emplace(sample.point, sample.attempt).first->second;
    attempt = std::max(attempt, sample.attempt);
    warm = warm && sample.temperatureC.has_value();
  }
  std::vector<session::AngleSample> counted;
  counted.reserve(samples.size());
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(counted),
               [&](const session::AngleSample& sample) { return sample.attempt == latest[sample.point]; });
  // A point that was measured again arrives last but keeps its place, so that the review's rows stay what they were.
  std::stable_sort(counted.begin(), counted.end(), [](const auto& a, const auto& b) { return a.point < b.point; });
  Sweep sweep;
  for (const session::AngleSample& sample : counted) {
    sweep.encoderDeg.push_back(sample.encoderDeg);
    sweep.sensorDeg.push_back(sample.sensorDeg);
    sweep.turn.push_back(sample.turn);
    sweep.direction.push_back(sample.direction);
    sweep.timeS.push_back(sample.timeS);
    if (warm) { // a column is complete or absent
      sweep.temperatureC.push_back(*sample.temperatureC);
    }
  }
  sweep.source.points = static_cast<long long>(sweep.size());
  return sweep;
}

Result<SessionSweep> readSessionSweep(const std::string& path, session::SweepRole role) {
  const auto opened = session::Session::openReadOnly(path);
  if (!opened) {
    return std::unexpected(opened.error());
  }
  const session::Session& session = **opened;
  if (session.kind() != session::SessionKind::Angle) {
    return fail(ErrorKind::Input, "this session is not an angle calibration", "choose another session", path);
  }
  auto samples = session.angleSamples(role);
  if (!samples) {
    return std::unexpected(std::move(samples.error()));
  }
  if (samples->empty()) {
    return fail(ErrorKind::Input,
                role == session::SweepRole::Calibration ? "the session holds no captured sweep"
                                                        : "the session holds no captured verification sweep",
                "capture one, or give the sweep as CSV", path);
  }
  auto traceability = session.traceability();
  auto review = session.document("review");
  if (!traceability || !review) {
    return std::unexpected(!traceability ? std::move(traceability.error()) : std::move(review.error()));
  }
  SessionSweep result{sweepFromSamples(*samples), *std::move(traceability)};
  if (role == session::SweepRole::Calibration && !review->empty()) {
    applyReview(result.sweep, *review);
  }
  result.sweep.source.file = session.file().filename().string();
  result.sweep.source.sha256 = sha256Hex(sweepToCsv(result.sweep));
  return result;
}

bool isSessionFile(const std::string& path) {
  if (path == "-") {
    return false;
  }
  constexpr std::string_view magic("SQLite format 3\0", 16);
  std::array<char, 16> start{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(start.data(), start.size());
  if (stream.gcount() > 0) {
    return std::string_view(start.data(), static_cast<std::size_t>(stream.gcount())) == magic;
  }
  return path.ends_with(".sedge");
}

} // namespace straightedge::angle
