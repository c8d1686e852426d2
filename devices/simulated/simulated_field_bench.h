// The field bench that is shipped: a Hall teslameter, an NMR, magnet and chambers, with known truth and known noise.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/field_bench.h"
#include "devices/simulated/hall_probe.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace straightedge::devices {

struct SimulatedFieldSettings {
  HallProbeSettings probe;
  double roomC = 24.0;
  double magnetLagS = 0.8; ///< time constants of first-order lags
  double chamberLagS = 2.0;
  double probeLagS = 12.0; ///< of the probe behind the air of its chamber: the hysteresis of the paper's Figure 7
  double placingS = 5.0;   ///< to turn the probe or carry it to the other chamber
  double largestFieldT = 2.2;
  double poleDriftPpmPerC = -2.8;
  double lockThresholdT = 0.043; ///< the NMR does not lock on less
  double lockGradientPpm = 50.0; ///< nor while the field is still so far from where it goes
  double searchS = 1.0;          ///< from a field it can lock on until it has locked
  double referenceNoisePpm = 1.5;
  double referenceScalePpm = 0.0;
  bool byHand = false;  ///< no carrier: the plan's stages wait for a person
  bool realTime = true; ///< false: as fast as possible, on a virtual clock
  std::uint64_t seed = 1;
};

/// Owns its instruments; bench() points into it. The NMR shows magnitudes.
class SimulatedFieldBench {
public:
  explicit SimulatedFieldBench(const SimulatedFieldSettings& settings);
  ~SimulatedFieldBench();
  SimulatedFieldBench(const SimulatedFieldBench&) = delete;
  SimulatedFieldBench& operator=(const SimulatedFieldBench&) = delete;

  FieldBench bench();
  const SimulatedFieldSettings& settings() const;

  /// Where there is no carrier: a person's hand. Not while the capture thread reads.
  void placeByHand(ProbePlacement placement);

  /// The truth: probe, chain, and the exact inverse (HallProbe::trueFieldT).
  const HallProbe& truth() const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

/// Settings as the JSON that a session keeps, so that a campaign is resumed on the same bench.
std::string simulatedFieldSettingsToJson(const SimulatedFieldSettings& settings);
/// What is missing keeps its default. Errors: Input, not JSON or of a wrong kind.
Result<SimulatedFieldSettings> simulatedFieldSettingsFromJson(std::string_view json);

} // namespace straightedge::devices
