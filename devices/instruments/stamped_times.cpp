#include "devices/instruments/stamped_times.h"

#include <algorithm>

namespace straightedge::devices {

namespace {

/// Longer than a line and a busy machine delay a reading.
constexpr double longestDelayS = 0.25;
/// More than two crystals differ by: so quickly the least delay is forgotten.
constexpr double clocksDiffer = 5e-4;

} // namespace

std::vector<double> StampedTimes::place(std::span<const std::uint32_t> ticks, double arrivalS) {
  std::vector<std::int64_t> counted;
  counted.reserve(ticks.size());
  for (const std::uint32_t tick : ticks) {
    if (!m_begun) {
      m_begun = true;
      m_originS = arrivalS - m_tickS * static_cast<double>(ticks.back() - tick); // unsigned: survives going round
      m_lastS = m_originS;
      m_lastArrivalS = arrivalS;
      m_lastTick = tick;
    }
    m_ticks += static_cast<std::int32_t>(tick - m_lastTick);
    m_lastTick = tick;
    counted.push_back(m_ticks);
  }
  if (counted.empty()) {
    return {};
  }
  const double originS = arrivalS - m_tickS * static_cast<double>(counted.back());
  if (originS < m_originS || originS > m_originS + longestDelayS) {
    m_originS = originS;
  } else {
    m_originS = std::min(originS, m_originS + clocksDiffer * (arrivalS - m_lastArrivalS));
  }
  m_lastArrivalS = arrivalS;
  std::vector<double> times;
  times.reserve(counted.size());
  for (const std::int64_t tick : counted) {
    m_lastS = std::max(m_lastS, m_originS + m_tickS * static_cast<double>(tick));
    times.push_back(m_lastS);
  }
  return times;
}

} // namespace straightedge::devices
