#include "devices/capture/reference_zero.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::devices {

namespace {

/// Whole turns do not count: a reference may have lost how many there were.
double awayDeg(double fromDeg, double toDeg) {
  const double difference = toDeg - fromDeg;
  return difference - 360.0 * std::round(difference / 360.0);
}

std::string degrees(double angleDeg) { return formatForPeople(angleDeg) + "°"; }

} // namespace

void ReferenceZero::seen(double encoderDeg) {
  if (std::isfinite(encoderDeg)) {
    m_seenDeg = encoderDeg;
  }
}

void ReferenceZero::stored(const session::AngleSample& sample) {
  m_last = sample;
  m_seenDeg = sample.encoderDeg;
  m_knownFor = m_reference.timesOpened();
}

bool ReferenceZero::inDoubt() const {
  return m_last && m_reference.incrementDeg() && m_knownFor != m_reference.timesOpened();
}

std::optional<Error> ReferenceZero::compare(double encoderDeg, double sensorDeg) {
  const std::string otherwise = "; where the encoder was without power, begin the sweep again in a new session";
  if (const auto before = std::exchange(m_seenDeg, std::nullopt)) {
    const double tolerance = std::max(stillDeg, 1.5 * m_reference.incrementDeg().value_or(0.0));
    if (std::abs(awayDeg(*before, encoderDeg)) > tolerance) {
      return Error{ErrorKind::Instrument,
                   "the encoder reads " + degrees(encoderDeg) + " and read " + degrees(*before) +
                       " before it was unplugged",
                   "if only the shaft was moved, turn it back to the last reading at " + degrees(m_last->encoderDeg) +
                       " and resume" + otherwise,
                   {}};
    }
  } else {
    const double moved = awayDeg(m_last->encoderDeg, encoderDeg);
    const double sensorMoved = awayDeg(m_last->sensorDeg, sensorDeg);
    if (std::abs(moved) > nearDeg) {
      return Error{ErrorKind::Instrument,
                   "the encoder reads " + degrees(encoderDeg) + " and the sweep's last reading was at " +
                       degrees(m_last->encoderDeg),
                   "turn the shaft back there and resume" + otherwise,
                   {}};
    }
    if (std::min(std::abs(sensorMoved - moved), std::abs(sensorMoved + moved)) > agreesDeg) { // it may run backwards
      // No fault that passes: trying again is of no use, and the exit code says so.
      return Error{ErrorKind::Input,
                   "the encoder has another zero than before: at " + degrees(encoderDeg) + " the sensor reads " +
                       degrees(sensorDeg) + ", and read " + degrees(m_last->sensorDeg) + " at " +
                       degrees(m_last->encoderDeg),
                   "begin the sweep again in a new session",
                   {}};
    }
  }
  m_seenDeg = encoderDeg;
  m_knownFor = m_reference.timesOpened();
  return std::nullopt;
}

} // namespace straightedge::devices
