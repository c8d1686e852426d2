#include "devices/simulated/hall_world.h"

#include "devices/simulated/quantised.h"

#include <algorithm>
#include <cmath>

namespace straightedge::devices {

namespace {

constexpr double hallConversionS = 1e-3; ///< of a reading on the virtual clock, so that no two have the same time
/// The body's lag is followed in steps no longer than this while the air it hangs in moves.
constexpr double longestStepS = 0.5;

} // namespace

void LaggingValue::sendTo(double target, double nowS) {
  at(nowS);
  m_target = target;
}

double LaggingValue::at(double nowS) {
  const double passed = nowS - m_timeS;
  if (passed > 0.0) {
    m_value = m_lagS > 0.0 ? m_target + (m_value - m_target) * std::exp(-passed / m_lagS) : m_target;
    m_timeS = nowS;
  }
  return m_lagS > 0.0 ? m_value : m_target;
}

HallWorld::HallWorld(const SimulatedFieldSettings& settings)
    : m_settings(settings), m_clock(makeBenchClock(settings.realTime)), m_probe(settings.probe), m_noise(settings.seed),
      m_magnet(0.0, settings.magnetLagS), m_probeChamber(settings.roomC, settings.chamberLagS),
      m_probeBody(settings.roomC, settings.probeLagS), m_electronicsChamber(settings.roomC, settings.chamberLagS) {}

void HallWorld::setFieldT(double fieldT) {
  const double limit = m_settings.largestFieldT;
  m_magnet.sendTo(std::clamp(fieldT, -limit, limit), m_clock->nowS());
}

void HallWorld::place(ProbePlacement placement) {
  m_clock->sleepS(m_settings.placingS);
  m_placement = placement;
  m_searchesFromS = m_clock->nowS();
}

void HallWorld::setProbeChamberC(double temperatureC) {
  probeC();
  m_probeChamber.sendTo(temperatureC, m_clock->nowS());
}

void HallWorld::setElectronicsChamberC(double temperatureC) {
  m_electronicsChamber.sendTo(temperatureC, m_clock->nowS());
}

double HallWorld::probeC() {
  // The body follows the air while the air itself follows the chamber's setting.
  const double now = m_clock->nowS();
  const double begun = m_probeBody.timeS();
  const int steps = std::clamp(static_cast<int>(std::ceil((now - begun) / longestStepS)), 1, 10000);
  for (int i = 1; i <= steps; ++i) {
    const double time = begun + (now - begun) * i / steps;
    m_probeBody.sendTo(m_probeChamber.at(time), m_probeBody.timeS());
    m_probeBody.at(time);
  }
  return m_probeBody.at(now);
}

double HallWorld::electronicsC() { return m_electronicsChamber.at(m_clock->nowS()); }

double HallWorld::magnetT() {
  const double field = m_magnet.at(m_clock->nowS());
  // The poles touch what heats the probe: the field falls a little as they warm up.
  return field * (1.0 + 1e-6 * m_settings.poleDriftPpmPerC * (probeC() - m_settings.roomC));
}

Eigen::Vector3d HallWorld::fieldT() {
  if (m_placement == ProbePlacement::ZeroChamber) {
    return Eigen::Vector3d::Zero();
  }
  const auto number = static_cast<int>(m_placement);
  return Eigen::Vector3d::Unit(number / 2) * (number % 2 == 0 ? 1.0 : -1.0) * magnetT();
}

void HallWorld::takeConversionTime() {
  if (!m_settings.realTime) {
    m_clock->sleepS(hallConversionS);
  }
}

FieldReading HallWorld::readProbe() {
  takeConversionTime();
  const Eigen::Vector3d raw = m_probe.readingT(fieldT(), probeC(), electronicsC(), m_noise);
  FieldReading reading;
  reading.rawT = {raw.x(), raw.y(), raw.z()};
  reading.timeS = m_clock->nowS();
  reading.electronicsC = m_probe.electronicsReadingC(electronicsC(), m_noise);
  return reading;
}

FieldReferenceReading HallWorld::readReference() {
  const double now = m_clock->nowS();
  const double field = magnetT();
  const double changing = std::abs(m_magnet.target() - m_magnet.at(now));
  const bool steady = changing <= 1e-6 * m_settings.lockGradientPpm * std::abs(field);
  if (!steady || std::abs(field) < m_settings.lockThresholdT) {
    m_searchesFromS = now;
  }
  FieldReferenceReading reading;
  reading.timeS = now;
  reading.locked =
      steady && std::abs(field) >= m_settings.lockThresholdT && now - m_searchesFromS >= m_settings.searchS;
  if (reading.locked) {
    const double shown =
        std::abs(field) *
        (1.0 + 1e-6 * (m_settings.referenceScalePpm + m_settings.referenceNoisePpm * m_noise.standardNormal()));
    reading.fieldT = quantised(shown, referenceStepT);
  }
  return reading;
}

double HallWorld::pt100Ohm() { return m_probe.pt100Ohm(probeC(), m_noise); }

double HallWorld::probeChamberC() {
  probeC(); // the body follows the air: never look ahead of it
  return quantised(m_probeChamber.at(m_clock->nowS()), chamberStepC);
}

double HallWorld::electronicsChamberC() { return quantised(electronicsC(), chamberStepC); }

} // namespace straightedge::devices
