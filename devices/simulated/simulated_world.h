// The physics behind the simulated instruments: one shaft, one magnet, one clock.
#pragma once

#include "devices/simulated/bench_clock.h"
#include "devices/simulated/field_geometry.h"
#include "devices/simulated/noise_source.h"
#include "devices/simulated/shaft_motion.h"
#include "devices/simulated/simulated_angle_bench.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace straightedge::devices {

/// Thread: the one that uses the instruments.
class SimulatedWorld {
public:
  explicit SimulatedWorld(const SimulatedAngleSettings& settings);

  BenchClock& clock() { return *m_clock; }
  const FieldEllipse& field() const { return m_field; }

  void moveTo(double shaftDeg);
  void halt();
  bool isMoving() const { return m_motion.isMoving(m_clock->nowS()); }
  double arrivalS() const { return m_motion.arrivalS(); }

  double encoderDeg(double timeS) const; ///< unwrapped, quantised
  double sensorDeg(double timeS);        ///< with hysteresis, noise and quantisation; times must not decrease
  double ambientC(double timeS);

  void startStream(double rateHz);
  StreamBlock readStream();
  void stopStream() { m_streamPeriodS = 0.0; }

private:
  double fieldWithHysteresisDeg(double timeS);
  void fillStream(double untilS);

  SimulatedAngleSettings m_settings;
  std::unique_ptr<BenchClock> m_clock;
  FieldEllipse m_field;
  ShaftMotion m_motion;
  NoiseSource m_sensorNoise;
  NoiseSource m_thermometerNoise;
  double m_laggingFieldDeg;     ///< output of the play operator
  double m_streamPeriodS = 0.0; ///< 0: no stream runs
  double m_streamStartS = 0.0;
  std::int64_t m_streamCount = 0; ///< samples due and taken since the stream began
  StreamBlock m_streamBlock;
};

} // namespace straightedge::devices
