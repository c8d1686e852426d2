// The physics behind the simulated field bench: one magnet, one probe, two chambers, one clock.
#pragma once

#include "devices/instruments/field_bench.h"
#include "devices/simulated/bench_clock.h"
#include "devices/simulated/hall_probe.h"
#include "devices/simulated/noise_source.h"
#include "devices/simulated/simulated_field_bench.h"

#include <memory>

namespace straightedge::devices {

/// A value that follows what it is sent to with a first-order lag. Times must not decrease.
class LaggingValue {
public:
  LaggingValue(double start, double lagS) : m_target(start), m_value(start), m_lagS(lagS) {}
  void sendTo(double target, double nowS);
  double at(double nowS);
  double target() const { return m_target; }
  double timeS() const { return m_timeS; } ///< of the last look

private:
  double m_target;
  double m_value;
  double m_lagS;
  double m_timeS = 0.0;
};

/// Thread: the one that uses the instruments.
class HallWorld {
public:
  explicit HallWorld(const SimulatedFieldSettings& settings);

  BenchClock& clock() { return *m_clock; }
  const HallProbe& probe() const { return m_probe; }

  void setFieldT(double fieldT);
  void place(ProbePlacement placement);
  void setProbeChamberC(double temperatureC);
  void setElectronicsChamberC(double temperatureC);

  FieldReading readProbe();
  FieldReferenceReading readReference();
  double pt100Ohm();
  double probeChamberC(); ///< as the chamber's own thermometer shows it
  double electronicsChamberC();

  Eigen::Vector3d fieldT(); ///< the truth, in the package's axes
  double probeC();          ///< likewise
  double electronicsC();    ///< likewise

private:
  double magnetT();
  void takeConversionTime();

  SimulatedFieldSettings m_settings;
  std::unique_ptr<BenchClock> m_clock;
  HallProbe m_probe;
  NoiseSource m_noise;
  LaggingValue m_magnet;
  LaggingValue m_probeChamber; ///< the air in it
  LaggingValue m_probeBody;    ///< behind the air
  LaggingValue m_electronicsChamber;
  ProbePlacement m_placement = ProbePlacement::ZeroChamber;
  double m_searchesFromS = 0.0; ///< the NMR begins to look for the field, and has it after its search time
};

} // namespace straightedge::devices
