// Sweeps with a known truth, for tests of the angle calibration.
#pragma once

#include "core/angle/angles.h"
#include "core/angle/sweep.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace straightedge::angle {

/// sensor' = shaft + offset + Σ amplitude·cos(order·shaft + phase), which is inverted exactly for the correction.
struct SyntheticSensor {
  struct Term {
    int order;
    double amplitudeDeg, phaseRad;
  };
  double offsetDeg = -95.0;
  std::vector<Term> terms = {{1, 2.0, 0.7}, {2, 5.0, -1.2}, {3, 0.6, 2.0}, {4, 0.9, 0.3}};
  bool decreasing = false;

  double readingDeg(double shaftDeg) const { return wrap360(shaftDeg + errorDeg(shaftDeg)); }
  double sensorDeg(double shaftDeg) const {
    return decreasing ? wrap360(360.0 - readingDeg(shaftDeg)) : readingDeg(shaftDeg);
  }
  double errorDeg(double shaftDeg) const {
    double error = offsetDeg;
    for (const Term& term : terms) {
      error += term.amplitudeDeg * std::cos(term.order * radians(shaftDeg) + term.phaseRad);
    }
    return error;
  }
  /// What must be added to a reading', wrapped to [−180, 180): by fixed point iteration, the error's slope is below 1.
  double correctionDeg(double readingDeg) const {
    double shaft = readingDeg - offsetDeg;
    for (int i = 0; i < 200; ++i) {
      shaft = readingDeg - errorDeg(shaft);
    }
    return wrap180(shaft - readingDeg);
  }

private:
  static double radians(double deg) { return deg * std::numbers::pi / 180.0; }
};

/// One pass over `count` evenly spaced encoder angles.
inline Sweep sweepOf(const SyntheticSensor& sensor, int count, double startDeg = 0.0) {
  Sweep sweep;
  sweep.source.file = "sweep.csv";
  for (int i = 0; i < count; ++i) {
    const double encoder = startDeg + 360.0 * i / count;
    sweep.encoderDeg.push_back(encoder);
    sweep.sensorDeg.push_back(sensor.sensorDeg(encoder));
  }
  return sweep;
}

/// Repeatable random numbers, the same on every machine (SplitMix64; the standard library's distributions differ).
class Randomness {
public:
  explicit Randomness(std::uint64_t seed) : m_state(seed) {}
  double uniform() {
    m_state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = m_state;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    z ^= z >> 31U;
    return static_cast<double>(z >> 11U) * 0x1.0p-53;
  }
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }

private:
  std::uint64_t m_state;
};

} // namespace straightedge::angle
