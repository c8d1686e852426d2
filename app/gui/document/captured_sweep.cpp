#include "app/gui/document/captured_sweep.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>

namespace straightedge::gui {

angle::Sweep capturedSweep(const std::vector<session::AngleSample>& samples) {
  std::unordered_map<int, int> latest;
  bool warm = !samples.empty();
  for (const session::AngleSample& sample : samples) {
    int& attempt = latest.try_emplace(sample.point, sample.attempt).first->second;
    attempt = std::max(attempt, sample.attempt);
    warm = warm && sample.temperatureC.has_value();
  }
  std::vector<session::AngleSample> counted;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(counted),
               [&](const session::AngleSample& sample) { return sample.attempt == latest[sample.point]; });
  // A point that was measured again arrives last but keeps its place, so that the review's rows stay what they were.
  std::stable_sort(counted.begin(), counted.end(), [](const auto& a, const auto& b) { return a.point < b.point; });
  angle::Sweep sweep;
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

} // namespace straightedge::gui
