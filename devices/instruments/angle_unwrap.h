// Angles of instruments that know one turn only.
#pragma once

#include <cmath>

namespace straightedge::devices {

/// Into [0, 360); exactly 360 is 0.
inline double wrapTurn(double angleDeg) {
  const double wrapped = angleDeg - 360.0 * std::floor(angleDeg / 360.0);
  return wrapped >= 360.0 ? 0.0 : wrapped;
}

/// Follows a reading over turns: correct while it moves less than half a turn between two readings.
class AngleUnwrap {
public:
  double follow(double angleDeg) {
    m_turnsDeg += m_begun ? -360.0 * std::round((angleDeg - m_lastDeg) / 360.0) : 0.0;
    m_lastDeg = angleDeg;
    m_begun = true;
    return angleDeg + m_turnsDeg;
  }
  void restart() { *this = {}; }

private:
  double m_lastDeg = 0.0;
  double m_turnsDeg = 0.0;
  bool m_begun = false;
};

} // namespace straightedge::devices
