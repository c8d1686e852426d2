#include "devices/simulated/shaft_motion.h"

#include <algorithm>
#include <cmath>

namespace straightedge::devices {

ShaftMotion::ShaftMotion(double speedDegPerS) : m_speedDegPerS(speedDegPerS > 0.0 ? speedDegPerS : 360.0) {}

void ShaftMotion::moveTo(double targetDeg, double nowS) {
  const double commanded = commandedDeg(nowS);
  m_initialLagDeg = commanded - positionDeg(nowS);
  m_fromDeg = commanded;
  m_toDeg = targetDeg;
  m_startS = nowS;
  m_durationS = std::abs(targetDeg - commanded) / m_speedDegPerS;
}

double ShaftMotion::commandedDeg(double timeS) const {
  if (timeS >= m_startS + m_durationS) {
    return m_toDeg;
  }
  const double passed = std::max(0.0, timeS - m_startS);
  return m_fromDeg + std::copysign(m_speedDegPerS, m_toDeg - m_fromDeg) * passed;
}

double ShaftMotion::positionDeg(double timeS) const {
  const double passed = std::max(0.0, timeS - m_startS);
  const double ramp = std::min(passed, m_durationS);
  const double steadyLag = std::copysign(m_speedDegPerS, m_toDeg - m_fromDeg) * lagS;
  const double fading = std::exp(-ramp / lagS);
  const double lagAtRampEnd = m_initialLagDeg * fading + (m_durationS > 0.0 ? steadyLag * (1.0 - fading) : 0.0);
  return commandedDeg(timeS) - lagAtRampEnd * std::exp(-(passed - ramp) / lagS);
}

} // namespace straightedge::devices
