// The physics of the simulated three-axis teslameter: field and temperatures in, raw readings out, and back exactly.
#pragma once

#include "core/field/calibration.h"
#include "devices/simulated/noise_source.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace straightedge::devices {

inline constexpr double referenceStepT = 1e-7; ///< last digit of the simulated NMR
inline constexpr double chamberStepC = 1e-3;   ///< last digit of a chamber's thermometer

/// Which way the polynomial leads that is the plate's nonlinearity.
enum class HallCurve : std::uint8_t {
  RawOverField, ///< as a plate does it; a fifth-order one of field over reading then leaves 0.01 %, as in the paper
  FieldOverRaw, ///< the fifth-order one is the truth itself: an evaluation can find it without a rest
};

/// One axis. Polynomials in ascending powers; blocks and signs as in field::CorrectionChain, temperatures minus
/// reference.
struct HallAxis {
  std::array<double, 8> rawOverFieldT = {0.0, 0.95216, -4e-5, 0.010987, 1e-5, 6.57e-4, 0.0, 2.175e-4};
  std::array<double, 2> offsetT = {40e-6, 16.9e-6};
  std::array<double, 4> sensitivitySlope = {0.0, -1.55e-4, 0.0, -4.0e-7};
  std::array<double, 2> sensitivityIntercept = {0.0, 0.0};
  std::array<double, 2> electronicsT = {0.0, -6.0e-6};
  std::array<double, 2> electronicsSensitivity = {0.0, 2.0e-5};
  double planarHallPerT = 0.0; ///< adds this · B_a · B_b of the two other axes; the chain has no block for it
};

/// Defaults resemble the paper's instrument.
struct HallProbeSettings {
  HallProbeSettings();

  HallCurve curve = HallCurve::RawOverField;
  std::array<HallAxis, 3> axes;
  Eigen::Matrix3d axisMatrix; ///< S: rows are probe axes, columns package axes
  double fullScaleT = 2.0;
  double referenceTemperatureC = 24.0;
  double noiseT = 5e-6; ///< standard deviation of a raw reading
  double stepT = 1e-7;  ///< of its quantisation; 0 = none
  double pt100OhmAt0C = 100.0;
  double pt100OhmPerC = 0.3851;
  double pt100NoiseOhm = 0.007;
  double pt100StepOhm = 1e-4;
  double electronicsNoiseC = 0.05;
  double electronicsStepC = 0.0625; ///< of a 12-bit sensor
};

/// Temperatures in °C, not minus reference. Immutable; noise comes from outside.
class HallProbe {
public:
  explicit HallProbe(const HallProbeSettings& settings);

  const HallProbeSettings& settings() const { return m_settings; }

  /// Without noise and quantisation.
  Eigen::Vector3d idealReadingT(const Eigen::Vector3d& fieldT, double probeC, double electronicsC) const;
  double idealPt100Ohm(double probeC) const;

  Eigen::Vector3d readingT(const Eigen::Vector3d& fieldT, double probeC, double electronicsC, NoiseSource& noise) const;
  double pt100Ohm(double probeC, NoiseSource& noise) const;
  double electronicsReadingC(double electronicsC, NoiseSource& noise) const;

  /// The truth backwards: the field that gives this reading, to rounding.
  Eigen::Vector3d trueFieldT(const Eigen::Vector3d& rawT, double probeC, double electronicsC) const;

  /// The truth as a chain. Exact for HallCurve::FieldOverRaw without planar Hall effect; else its nonlinearity is the
  /// fifth-order polynomial that comes nearest over the full scale.
  const field::CorrectionChain& trueChain() const { return m_chain; }

private:
  double rawOf(std::size_t axis, double linearT) const;
  double linearOf(std::size_t axis, double rawT) const;
  Eigen::Vector3d planarT(const Eigen::Vector3d& fieldT) const;

  HallProbeSettings m_settings;
  field::CorrectionChain m_chain;
  Eigen::Matrix3d m_inverse;
};

} // namespace straightedge::devices
