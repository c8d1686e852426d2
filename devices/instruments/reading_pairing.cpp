#include "devices/instruments/reading_pairing.h"

#include <cmath>
#include <optional>

namespace straightedge::devices {

namespace {

double intoTurn(double angleDeg) {
  const double wrapped = angleDeg - 360.0 * std::floor(angleDeg / 360.0);
  return wrapped >= 360.0 ? 0.0 : wrapped;
}

/// Between two sensor readings; nothing where one is too far away.
std::optional<double> sensorAt(double timeS, const TimedReading& before, const TimedReading& after, double maxAgeS) {
  if (timeS == before.timeS || timeS == after.timeS) {
    return intoTurn(timeS == before.timeS ? before.value : after.value);
  }
  if (timeS - before.timeS > maxAgeS || after.timeS - timeS > maxAgeS) {
    return std::nullopt;
  }
  const double part = (timeS - before.timeS) / (after.timeS - before.timeS);
  const double difference = after.value - before.value;
  const double way = difference - 360.0 * std::round(difference / 360.0);
  return intoTurn(before.value + part * way);
}

} // namespace

void ReadingPairing::addReference(const TimedReading& reading) {
  if (!m_references.empty() && reading.timeS < m_references.back().timeS) {
    ++m_rejected;
    return;
  }
  m_references.push_back(reading);
  if (m_references.size() > mostWaiting) {
    m_references.pop_front();
    ++m_rejected;
  }
}

void ReadingPairing::addSensor(const TimedReading& reading) {
  if (m_sensors.empty() || reading.timeS > m_sensors.back().timeS) {
    m_sensors.push_back(reading);
  }
  if (m_sensors.size() > mostWaiting) {
    m_sensors.pop_front();
  }
}

std::vector<StreamedAngle> ReadingPairing::takePairs() {
  std::vector<StreamedAngle> pairs;
  while (!m_references.empty()) {
    const TimedReading reference = m_references.front();
    while (m_sensors.size() > 1 && m_sensors[1].timeS <= reference.timeS) {
      m_sensors.pop_front();
    }
    if (m_sensors.empty() || (m_sensors.size() == 1 && m_sensors[0].timeS < reference.timeS)) {
      break; // the reading after it has not come yet
    }
    const TimedReading& before = m_sensors.front();
    const bool tooEarly = before.timeS > reference.timeS; // and no older one will come
    const TimedReading& after = m_sensors.size() > 1 ? m_sensors[1] : before;
    const auto value = tooEarly ? std::nullopt : sensorAt(reference.timeS, before, after, m_rule.maxAgeS);
    if (value) {
      pairs.push_back({.timeS = reference.timeS, .encoderDeg = reference.value, .sensorDeg = *value});
    } else {
      ++m_rejected;
    }
    m_references.pop_front();
  }
  return pairs;
}

} // namespace straightedge::devices
