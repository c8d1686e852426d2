// Small interfaces that a field bench is made of. Real instruments and the simulated bench implement the same ones.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/angle_instruments.h"

#include <array>
#include <optional>

namespace straightedge::devices {

/// One measurement of a three-axis teslameter, before any correction of ours.
struct FieldReading {
  std::array<double, 3> rawT = {0.0, 0.0, 0.0}; ///< x, y, z; not to be used where overRange
  double timeS = 0.0;
  bool overRange = false;             ///< the instrument said that an axis is beyond its range
  std::optional<double> electronicsC; ///< where the instrument measures its own temperature, in °C
};

/// The teslameter under calibration. Thread: the capture thread only.
class FieldProbe {
public:
  virtual ~FieldProbe() = default;
  virtual InstrumentIdentity identity() const = 0;
  virtual Result<FieldReading> readT() = 0;
  virtual bool measuresElectronics() const { return false; } ///< its readings carry electronicsC
};

/// One measurement of the reference. Not locked (or not in range) is an answer, not an error: then there is no value.
struct FieldReferenceReading {
  std::optional<double> fieldT; ///< magnitude, or signed where the instrument knows the sign; only if locked
  bool locked = false;
  double timeS = 0.0;
};

/// The reference field: an NMR teslameter, or another calibrated one. Thread: the capture thread only.
class FieldReference {
public:
  virtual ~FieldReference() = default;
  virtual InstrumentIdentity identity() const = 0;
  virtual Result<FieldReferenceReading> readT() = 0;
  virtual bool knowsSign() const { return false; } ///< false: magnitudes, the sign is the plan's
};

/// PT100 in ohms. Thread: the capture thread only.
class ResistanceMeter {
public:
  virtual ~ResistanceMeter() = default;
  virtual InstrumentIdentity identity() const = 0;
  virtual Result<TimedReading> readOhm() = 0;
};

} // namespace straightedge::devices
