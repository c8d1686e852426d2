#include "devices/capture/stream_pass.h"

#include <algorithm>
#include <cmath>

namespace straightedge::devices {

namespace {

/// A hand trembles and an encoder jitters by less; farther back, play and hysteresis are those of the other direction.
constexpr double turnedBackDeg = 0.5;

} // namespace

StreamPass::StreamPass(CaptureCourse& course, PointRun run, bool byHand)
    : m_course(course), m_run(run), m_byHand(byHand), m_direction(course.point(run.first).direction),
      m_fromDeg(course.point(run.first).encoderDeg), m_sector(run.first - 1), m_ready(!byHand) {}

double StreamPass::toDeg() const {
  return m_fromDeg + m_direction * (m_run.last - m_run.first + 1) * m_course.stepDeg();
}

bool StreamPass::counts(double travelledDeg) {
  if (!m_ready) {
    m_ready = travelledDeg < 0.0;
    m_farthestDeg = travelledDeg;
    return false;
  }
  if (!m_byHand) {
    return true;
  }
  m_turnedBack = travelledDeg < m_farthestDeg - (m_turnedBack ? 0.0 : turnedBackDeg);
  m_farthestDeg = std::max(m_farthestDeg, travelledDeg);
  return !m_turnedBack;
}

std::optional<int> StreamPass::place(double encoderDeg) {
  const double travelledDeg = (encoderDeg - m_fromDeg) * m_direction;
  if (passed() || !counts(travelledDeg)) {
    return std::nullopt;
  }
  if (!std::isfinite(travelledDeg)) { // no angle leads anywhere; whoever stores the sample refuses it
    return begun() ? std::optional(m_sector) : std::nullopt;
  }
  const double sectors = std::floor(travelledDeg / m_course.stepDeg());
  const int at = m_run.first + static_cast<int>(std::clamp(sectors, -1.0, m_run.last - m_run.first + 1.0));
  while (m_sector < at) {
    if (begun()) {
      m_course.sectorDone(m_sector);
    }
    ++m_sector;
    if (!passed()) {
      m_course.sectorBegun(m_sector);
    }
  }
  return begun() && !passed() ? std::optional(m_sector) : std::nullopt;
}

} // namespace straightedge::devices
