// The bench that is shipped: magnet, sensor and encoder with known truth, noise, hysteresis and quantisation.
#pragma once

#include "devices/instruments/angle_instruments.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace straightedge::devices {

/// How the magnet's field reaches the sensor.
enum class FieldGeometry : std::uint8_t {
  OnAxis,    ///< end of shaft, slightly off centre: small 1st and 2nd harmonic
  SideShaft, ///< off axis: strong 2nd harmonic, errors above 10°
};

struct SimulatedAngleSettings {
  FieldGeometry geometry = FieldGeometry::SideShaft;
  double ellipticity = 0.0;       ///< ratio − 1 of radial and tangential field amplitude; 0 = the geometry's default
  double eccentricity = 0.0;      ///< magnet offset as a share of the air gap; 0 = the geometry's default
  double mountingAngleDeg = 80.0; ///< sensor zero against encoder zero
  bool decreasing = false;        ///< sensor mounted upside down
  double noiseDeg = 0.02;         ///< standard deviation of one reading
  double hysteresisDeg = 0.05;    ///< half the width of the loop
  int sensorBits = 14;            ///< quantisation of the sensor; 0 = none
  double encoderStepDeg = 0.0001; ///< quantisation of the encoder; 0 = none
  double ambientC = 23.0;
  double stageSpeedDegPerS = 360.0;
  bool realTime = true; ///< false: as fast as possible, on a virtual clock
  std::uint64_t seed = 1;
};

/// Owns its instruments; bench() points into it.
class SimulatedAngleBench {
public:
  explicit SimulatedAngleBench(const SimulatedAngleSettings& settings);
  ~SimulatedAngleBench();
  SimulatedAngleBench(const SimulatedAngleBench&) = delete;
  SimulatedAngleBench& operator=(const SimulatedAngleBench&) = delete;

  AngleBench bench();
  const SimulatedAngleSettings& settings() const;

  /// The truth: sensor angle (no noise, hysteresis or quantisation) at a shaft angle.
  double trueSensorDeg(double shaftDeg) const;
  /// The truth: what must be added to a reading' (360 − reading if decreasing), wrapped to [−180, 180).
  double trueCorrectionDeg(double readingDeg) const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::devices
