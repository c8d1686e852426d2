#include "devices/simulated/simulated_world.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace straightedge::devices {

namespace {

/// Samples the simulated instrument keeps until it is read; what comes beyond is lost and counted, as in real ones.
constexpr std::size_t streamMemory = 65536;

FieldEllipse fieldOf(const SimulatedAngleSettings& settings) {
  const bool onAxis = settings.geometry == FieldGeometry::OnAxis;
  // Beside the shaft: harmonics of about 8°, 5° and 1° as in the published 32-point example. On its end: 0.6° and 0.3°.
  const double ellipticity = settings.ellipticity != 0.0 ? settings.ellipticity : (onAxis ? 0.01 : 0.21);
  const double eccentricity = settings.eccentricity != 0.0 ? settings.eccentricity : (onAxis ? 0.01 : 0.15);
  return {ellipticity, eccentricity, settings.mountingAngleDeg};
}

double wrapped(double deg) {
  double result = std::fmod(deg, 360.0);
  if (result < 0.0) {
    result += 360.0;
  }
  return result >= 360.0 ? 0.0 : result;
}

} // namespace

SimulatedWorld::SimulatedWorld(const SimulatedAngleSettings& settings)
    : m_settings(settings), m_clock(makeBenchClock(settings.realTime)), m_field(fieldOf(settings)),
      m_motion(settings.stageSpeedDegPerS), m_sensorNoise(settings.seed), m_thermometerNoise(~settings.seed),
      m_laggingFieldDeg(m_field.fieldDeg(0.0)) {}

void SimulatedWorld::moveTo(double shaftDeg) {
  const double now = m_clock->nowS();
  fillStream(now);
  fieldWithHysteresisDeg(now);
  m_motion.moveTo(shaftDeg, now);
}

void SimulatedWorld::halt() {
  const double now = m_clock->nowS();
  fillStream(now);
  fieldWithHysteresisDeg(now);
  m_motion.halt(now);
}

double SimulatedWorld::encoderDeg(double timeS) const {
  const double position = m_motion.positionDeg(timeS);
  const double step = m_settings.encoderStepDeg;
  return step > 0.0 ? std::round(position / step) * step : position;
}

double SimulatedWorld::fieldWithHysteresisDeg(double timeS) {
  // Play: the sensor's magnetisation follows the field at a distance of at most the half width of the loop.
  const double field = m_field.fieldDeg(m_motion.positionDeg(timeS));
  const double play = std::max(0.0, m_settings.hysteresisDeg);
  m_laggingFieldDeg = std::clamp(m_laggingFieldDeg, field - play, field + play);
  return m_laggingFieldDeg;
}

double SimulatedWorld::sensorDeg(double timeS) {
  double reading = fieldWithHysteresisDeg(timeS) + m_settings.noiseDeg * m_sensorNoise.standardNormal();
  if (m_settings.decreasing) {
    reading = -reading;
  }
  if (m_settings.sensorBits > 0) {
    const double lsb = std::ldexp(360.0, -m_settings.sensorBits);
    reading = std::round(reading / lsb) * lsb;
  }
  return wrapped(reading);
}

double SimulatedWorld::ambientC(double timeS) {
  // A room whose heating comes and goes by a tenth of a degree in ten minutes.
  const double swing = 0.1 * std::sin(2.0 * std::numbers::pi * timeS / 600.0);
  return std::round((m_settings.ambientC + swing + 0.01 * m_thermometerNoise.standardNormal()) * 100.0) / 100.0;
}

void SimulatedWorld::startStream(double rateHz) {
  m_streamPeriodS = 1.0 / rateHz;
  m_streamStartS = m_clock->nowS();
  m_streamCount = 0;
  m_streamBlock = {};
}

void SimulatedWorld::fillStream(double untilS) {
  if (m_streamPeriodS <= 0.0) {
    return;
  }
  for (;;) {
    const double due = m_streamStartS + static_cast<double>(m_streamCount) * m_streamPeriodS;
    if (due > untilS) {
      return;
    }
    ++m_streamCount;
    if (m_streamBlock.samples.size() >= streamMemory) {
      ++m_streamBlock.lost;
      continue;
    }
    m_streamBlock.samples.push_back({due, encoderDeg(due), sensorDeg(due)});
  }
}

StreamBlock SimulatedWorld::readStream() {
  fillStream(m_clock->nowS());
  return std::exchange(m_streamBlock, {});
}

} // namespace straightedge::devices
