#include "devices/simulated/hall_probe.h"

#include "devices/simulated/quantised.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>
#include <span>
#include <utility>

namespace straightedge::devices {

namespace {

constexpr int fixedPointSteps = 12; // each gains three digits or more
constexpr int newtonSteps = 20;

double polynomial(std::span<const double> ascending, double x) {
  double sum = 0.0;
  for (std::size_t i = ascending.size(); i-- > 0;) {
    sum = sum * x + ascending[i];
  }
  return sum;
}

/// x with polynomial(x) = y, near `guess`; rising there.
double solved(std::span<const double> ascending, double y, double guess) {
  double x = guess;
  for (int i = 0; i < newtonSteps; ++i) {
    double value = 0.0;
    double slope = 0.0;
    for (std::size_t k = ascending.size(); k-- > 0;) {
      slope = slope * x + value;
      value = value * x + ascending[k];
    }
    const double step = (value - y) / slope;
    x -= step;
    if (std::abs(step) <= 1e-16 * std::abs(x)) {
      break;
    }
  }
  return x;
}

/// The fifth-order polynomial of field over raw reading that comes nearest to the inverse, over
/// full scale.
std::vector<double> fieldOverRaw(const std::array<double, 8>& rawOverField, double fullScaleT) {
  constexpr int points = 201;
  constexpr int terms = 6;
  Eigen::MatrixXd powers(points, terms);
  Eigen::VectorXd fields(points);
  for (int i = 0; i < points; ++i) {
    fields[i] = fullScaleT * (2.0 * i / (points - 1) - 1.0);
    const double scaled = polynomial(rawOverField, fields[i]) / fullScaleT;
    for (int k = 0; k < terms; ++k) {
      powers(i, k) = std::pow(scaled, k);
    }
  }
  const Eigen::VectorXd fitted = powers.householderQr().solve(fields);
  std::vector<double> ascending(terms);
  for (int k = 0; k < terms; ++k) {
    ascending[static_cast<std::size_t>(k)] = fitted[k] / std::pow(fullScaleT, k);
  }
  return ascending;
}

template <std::size_t N>
std::vector<double> listed(const std::array<double, N>& values) {
  return {values.begin(), values.end()};
}

} // namespace

HallProbeSettings::HallProbeSettings() {
  axes[1].rawOverFieldT = {0.0, 0.95085, 6e-5, 0.011626, -1.6e-5, 6.81e-4, 0.0, 1.934e-4};
  axes[1].offsetT = {-20e-6, -9.75e-6};
  axes[1].sensitivitySlope = {0.0, -1.50e-4, 0.0, -5.0e-7};
  axes[1].electronicsT = {0.0, 4.4e-6};
  axes[1].electronicsSensitivity = {0.0, 2.2e-5};
  axes[2].rawOverFieldT = {0.0, 0.95591, -4e-5, 0.009475, 1e-5, 7.22e-4, 0.0, 2.22e-4};
  axes[2].offsetT = {50e-6, 23.8e-6};
  axes[2].sensitivitySlope = {0.0, -1.46e-4, 0.0, -3.0e-7};
  axes[2].electronicsT = {0.0, -9.0e-6};
  axes[2].electronicsSensitivity = {0.0, 1.8e-5};
  axisMatrix << 1.0, 0.012, -0.009, -0.015, 1.0, 0.011, 0.008, -0.013, 1.0;
}

HallProbe::HallProbe(const HallProbeSettings& settings)
    : m_settings(settings), m_inverse(settings.axisMatrix.inverse()) {
  m_chain.fullScaleT = settings.fullScaleT;
  m_chain.referenceTemperatureC = settings.referenceTemperatureC;
  m_chain.pt100 = {.slopeCPerOhm = 1.0 / settings.pt100OhmPerC,
                   .interceptC = -settings.pt100OhmAt0C / settings.pt100OhmPerC - settings.referenceTemperatureC};
  for (std::size_t i = 0; i < 3; ++i) {
    const HallAxis& axis = settings.axes[i];
    m_chain.axes[i] = {.nonlinearity = fieldOverRaw(axis.rawOverFieldT, settings.fullScaleT),
                       .offsetT = axis.offsetT,
                       .sensitivitySlope = listed(axis.sensitivitySlope),
                       .sensitivityIntercept = listed(axis.sensitivityIntercept),
                       .electronicsT = axis.electronicsT,
                       .electronicsSensitivity = axis.electronicsSensitivity};
  }
  m_chain.axisMatrix = settings.axisMatrix;
}

double HallProbe::rawOf(std::size_t axis, double linearT) const {
  const auto& forward = m_settings.axes[axis].rawOverFieldT;
  const double raw = polynomial(forward, linearT);
  return m_settings.curve == HallCurve::RawOverField ? raw : solved(m_chain.axes[axis].nonlinearity, linearT, raw);
}

double HallProbe::linearOf(std::size_t axis, double rawT) const {
  const double nearly = polynomial(m_chain.axes[axis].nonlinearity, rawT);
  return m_settings.curve == HallCurve::FieldOverRaw ? nearly
                                                     : solved(m_settings.axes[axis].rawOverFieldT, rawT, nearly);
}

Eigen::Vector3d HallProbe::planarT(const Eigen::Vector3d& fieldT) const {
  return {m_settings.axes[0].planarHallPerT * fieldT.y() * fieldT.z(),
          m_settings.axes[1].planarHallPerT * fieldT.z() * fieldT.x(),
          m_settings.axes[2].planarHallPerT * fieldT.x() * fieldT.y()};
}

Eigen::Vector3d HallProbe::idealReadingT(const Eigen::Vector3d& fieldT, double probeC, double electronicsC) const {
  const double probe = probeC - m_settings.referenceTemperatureC;
  const double electronics = electronicsC - m_settings.referenceTemperatureC;
  const Eigen::Vector3d seen = m_settings.axisMatrix * fieldT + planarT(fieldT);
  Eigen::Vector3d raw;
  for (std::size_t i = 0; i < 3; ++i) { // the chain of field::CorrectionChain, from its end to its beginning
    const HallAxis& axis = m_settings.axes[i];
    const auto& [es0, es1] = axis.electronicsSensitivity;
    const double v4 = (seen[static_cast<Eigen::Index>(i)] + es0 * electronics) / (1.0 - es1 * electronics);
    const double v3 = v4 + axis.electronicsT[0] + axis.electronicsT[1] * electronics;
    double v2 = v3;
    for (int step = 0; step < fixedPointSteps; ++step) {
      const double next =
          v3 + polynomial(axis.sensitivitySlope, v2) * probe + polynomial(axis.sensitivityIntercept, v2);
      if (next == std::exchange(v2, next)) {
        break;
      }
    }
    raw[static_cast<Eigen::Index>(i)] = rawOf(i, v2 + axis.offsetT[0] + axis.offsetT[1] * probe);
  }
  return raw;
}

Eigen::Vector3d HallProbe::trueFieldT(const Eigen::Vector3d& rawT, double probeC, double electronicsC) const {
  const double probe = probeC - m_settings.referenceTemperatureC;
  const double electronics = electronicsC - m_settings.referenceTemperatureC;
  Eigen::Vector3d seen;
  for (std::size_t i = 0; i < 3; ++i) {
    const HallAxis& axis = m_settings.axes[i];
    const double v1 = linearOf(i, rawT[static_cast<Eigen::Index>(i)]);
    const double v2 = v1 - (axis.offsetT[0] + axis.offsetT[1] * probe);
    const double v3 = v2 - (polynomial(axis.sensitivitySlope, v2) * probe + polynomial(axis.sensitivityIntercept, v2));
    const double v4 = v3 - (axis.electronicsT[0] + axis.electronicsT[1] * electronics);
    const auto& [es0, es1] = axis.electronicsSensitivity;
    seen[static_cast<Eigen::Index>(i)] = v4 - (es0 + es1 * v4) * electronics;
  }
  Eigen::Vector3d fieldT = m_inverse * seen;
  for (int step = 0; step < fixedPointSteps; ++step) {
    const Eigen::Vector3d next = m_inverse * (seen - planarT(fieldT));
    if (next == std::exchange(fieldT, next)) {
      break;
    }
  }
  return fieldT;
}

double HallProbe::idealPt100Ohm(double probeC) const {
  return m_settings.pt100OhmAt0C + m_settings.pt100OhmPerC * probeC;
}

Eigen::Vector3d HallProbe::readingT(const Eigen::Vector3d& fieldT, double probeC, double electronicsC,
                                    NoiseSource& noise) const {
  Eigen::Vector3d raw = idealReadingT(fieldT, probeC, electronicsC);
  for (double& value : raw) {
    value = quantised(value + m_settings.noiseT * noise.standardNormal(), m_settings.stepT);
  }
  return raw;
}

double HallProbe::pt100Ohm(double probeC, NoiseSource& noise) const {
  return quantised(idealPt100Ohm(probeC) + m_settings.pt100NoiseOhm * noise.standardNormal(), m_settings.pt100StepOhm);
}

double HallProbe::electronicsReadingC(double electronicsC, NoiseSource& noise) const {
  return quantised(electronicsC + m_settings.electronicsNoiseC * noise.standardNormal(), m_settings.electronicsStepC);
}

} // namespace straightedge::devices
