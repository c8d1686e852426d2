#include "core/field/uncertainty.h"

#include "core/field/closest_fit.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace straightedge::field {

namespace {

double cumulative(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }
double density(double x) { return std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi); }

Eigen::Vector3d root(const Eigen::Vector3d& squares) { return squares.cwiseMax(0.0).cwiseSqrt(); }

TemperatureRange rangeOf(const FitPoints& points) {
  TemperatureRange range;
  for (const std::vector<FitPoint>& axis : points.axes) {
    for (const FitPoint& point : axis) {
      if (point.step == CampaignStep::Sensitivity) {
        range.probeLowC = std::min(range.probeLowC, point.probeC);
        range.probeHighC = std::max(range.probeHighC, point.probeC);
      } else if (point.step == CampaignStep::ElectronicsSensitivity) {
        range.electronicsLowC = std::min(range.electronicsLowC, point.electronicsC);
        range.electronicsHighC = std::max(range.electronicsHighC, point.electronicsC);
      }
    }
  }
  return range;
}

} // namespace

double halfWidth95(double mean, double sigma) {
  const double shift = std::abs(mean);
  if (!(sigma > 0.0)) {
    return shift;
  }
  const double r = shift / sigma;
  constexpr double farAway = 4.0; // the other tail is empty
  constexpr double oneSided = 1.6448536269514722;
  if (r > farAway) {
    return shift + oneSided * sigma;
  }
  double k = std::hypot(1.96, r); // Newton's method on Φ(k − r) − Φ(−k − r) = 0.95
  for (int i = 0; i < 30; ++i) {
    const double step = (cumulative(k - r) - cumulative(-k - r) - 0.95) / (density(k - r) + density(k + r));
    k -= step;
    if (std::abs(step) < 1e-12) {
      break;
    }
  }
  return k * sigma;
}

FieldUncertainty::FieldUncertainty(CorrectionChain chain, AppliedChain applied, JointReport closest,
                                   const ReadingNoise& noise, const FieldUncertaintyInputs& inputs,
                                   const TemperatureRange& range)
    : m_chain(std::move(chain)), m_applied(applied), m_closest(std::move(closest)), m_noise(noise), m_inputs(inputs),
      m_range(range), m_inverse(m_closest.chain.axisMatrix.value_or(Eigen::Matrix3d::Identity()).inverse()) {}

Result<FieldUncertainty> FieldUncertainty::of(const CampaignParts& parts, const CorrectionChain& chain,
                                              const FieldUncertaintyInputs& inputs, const std::string& name) {
  auto applied = AppliedChain::prepare(chain);
  if (!applied) {
    return std::unexpected(std::move(applied.error()));
  }
  const FitPoints points = fitPoints(parts, chain);
  auto closest = fitClosely(points, chain, name);
  if (!closest) {
    return std::unexpected(std::move(closest.error()));
  }
  for (JointAxisReport& axis : closest->axes) {
    // Where the rest is more than noise, the coefficients have been drawn about by it as well.
    if (axis.restT > 0.0) {
      axis.covariance *= axis.excess * axis.excess;
    }
  }
  return FieldUncertainty(chain, *std::move(applied), *std::move(closest), readingNoise(parts, chain.fullScaleT),
                          inputs, rangeOf(points));
}

Result<FieldUncertainty> FieldUncertainty::forChain(const CorrectionChain& chain) const {
  auto applied = AppliedChain::prepare(chain);
  if (!applied) {
    return std::unexpected(std::move(applied.error()));
  }
  return FieldUncertainty(chain, *std::move(applied), m_closest, m_noise, m_inputs, m_range);
}

ReadingUncertainty FieldUncertainty::at(const Reading& reading) const {
  const double probeC = m_applied.needsProbeTemperature() ? probeAboveReference(m_chain, reading.pt100Ohm) : 0.0;
  const double electronicsC =
      m_applied.needsElectronicsTemperature() ? reading.electronicsC - m_chain.referenceTemperatureC : 0.0;
  std::array<AxisGradient, 3> gradients;
  std::array<Eigen::VectorXd, 3> byUnknown;
  Eigen::Vector3d valuesT;
  Eigen::Vector3d byProbe;
  Eigen::Vector3d byElectronics;
  Eigen::Vector3d repeatability;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const JointAxisReport& report = m_closest.axes[axis];
    const auto count = static_cast<Eigen::Index>(report.parameters.size());
    byUnknown[axis].setZero(report.values.size());
    const auto i = static_cast<Eigen::Index>(axis);
    gradients[axis] = axisGradient(m_closest.chain.axes[axis], report.parameters, reading.rawT[axis], probeC,
                                   electronicsC, byUnknown[axis].head(count));
    valuesT[i] = gradients[axis].valueT;
    byProbe[i] = gradients[axis].byProbe;
    byElectronics[i] = gradients[axis].byElectronics;
    repeatability[i] = gradients[axis].byRaw * m_noise.rawT[axis];
  }
  const Eigen::Vector3d closestT = m_inverse * valuesT;
  Eigen::Vector3d coefficients2;
  Eigen::Vector3d model2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const JointAxisReport& report = m_closest.axes[axis];
    if (report.fitsAxisRow) {
      byUnknown[axis].tail<3>() = -closestT; // B = S⁻¹·V: a change of S's row acts as one of V
    }
    const auto i = static_cast<Eigen::Index>(axis);
    coefficients2[i] = byUnknown[axis].dot(report.covariance * byUnknown[axis]);
    model2[i] = report.restT * report.restT;
  }
  const Eigen::Matrix3d share = m_inverse.cwiseAbs2(); // of independent variances of the axes
  const double probeSigmaC = m_chain.pt100 ? std::abs(m_chain.pt100->slopeCPerOhm) * m_noise.pt100Ohm : 0.0;
  ReadingUncertainty u;
  u.fieldT = m_applied.correct(reading);
  u.residualT = u.fieldT - closestT;
  u.repeatabilityT = root(share * repeatability.cwiseAbs2());
  u.coefficientsT = root(share * coefficients2);
  u.modelT = root(share * model2);
  // A temperature is common to the axes.
  u.probeTemperatureT = (m_inverse * byProbe).cwiseAbs() * probeSigmaC;
  u.electronicsTemperatureT = (m_inverse * byElectronics).cwiseAbs() * m_noise.electronicsC;
  u.referenceT = closestT.cwiseAbs() * m_inputs.referenceRelative;
  u.combinedT =
      root(u.repeatabilityT.cwiseAbs2() + u.coefficientsT.cwiseAbs2() + u.modelT.cwiseAbs2() +
           u.probeTemperatureT.cwiseAbs2() + u.electronicsTemperatureT.cwiseAbs2() + u.referenceT.cwiseAbs2());
  for (Eigen::Index i = 0; i < 3; ++i) {
    u.expandedT[i] = halfWidth95(u.residualT[i], u.combinedT[i]);
  }
  return u;
}

Reading FieldUncertainty::readingFor(const Eigen::Vector3d& fieldT, double probeC, double electronicsC) const {
  const double probe = probeC - m_chain.referenceTemperatureC;
  const double electronics = electronicsC - m_chain.referenceTemperatureC;
  const Eigen::Vector3d seen =
      m_closest.chain.axisMatrix ? Eigen::Vector3d(*m_closest.chain.axisMatrix * fieldT) : fieldT;
  Reading reading;
  reading.electronicsC = electronicsC;
  if (m_chain.pt100) {
    reading.pt100Ohm = (probe - m_chain.pt100->interceptC) / m_chain.pt100->slopeCPerOhm;
  }
  Eigen::VectorXd unused(0);
  constexpr int newtonSteps = 20;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double target = seen[static_cast<Eigen::Index>(axis)];
    double& raw = reading.rawT[axis];
    raw = target;
    for (int i = 0; i < newtonSteps; ++i) {
      const AxisGradient gradient =
          axisGradient(m_closest.chain.axes[axis], {}, raw, m_chain.pt100 ? probe : 0.0, electronics, unused);
      const double step = (gradient.valueT - target) / gradient.byRaw;
      raw -= step;
      if (std::abs(step) < 1e-12) {
        break;
      }
    }
  }
  return reading;
}

} // namespace straightedge::field
