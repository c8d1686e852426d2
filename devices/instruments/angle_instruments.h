// Small interfaces that an angle bench is made of. Real instruments and the simulated bench implement the same ones.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/pairing_rule.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::devices {

class BenchConnection; // devices/instruments/bench_connection.h

/// A value and when it was taken, in seconds on the bench's monotonic clock.
struct TimedReading {
  double value = 0.0;
  double timeS = 0.0;
};

struct InstrumentIdentity {
  std::string model;
  std::string serial;
  std::string firmware;
};

/// The device under calibration. Thread: the capture thread only.
class AngleSensor {
public:
  virtual ~AngleSensor() = default;
  virtual InstrumentIdentity identity() const = 0;
  virtual Result<TimedReading> readDeg() = 0; ///< [0, 360)
};

/// The reference encoder. Thread: the capture thread only.
class AngleReference {
public:
  virtual ~AngleReference() = default;
  virtual InstrumentIdentity identity() const = 0;
  virtual Result<TimedReading> readDeg() = 0; ///< unwrapped: exceeds 360 over several turns

  /// Where its zero is where it was switched on (an incremental encoder), or where that is not known: degrees of one
  /// count, 0 if that is not known either. None: it knows its angle by itself, also after it was without power.
  virtual std::optional<double> incrementDeg() const { return std::nullopt; }
  /// Grows each time that it was opened and set up again: it may have been without power before.
  virtual int timesOpened() const { return 1; }
};

/// Turns the shaft. Absent on a bench that is turned by hand. Thread: the capture thread only.
class RotaryStage {
public:
  virtual ~RotaryStage() = default;
  virtual InstrumentIdentity identity() const = 0;
  virtual Result<void> moveToDeg(double angleDeg) = 0; ///< unwrapped; returns when the stage says it is there

  /// Begins a move and returns at once. A stage that cannot do so moves and returns when it is there.
  virtual Result<void> startMoveToDeg(double angleDeg) { return moveToDeg(angleDeg); }
  virtual Result<bool> isMoving() { return false; } ///< true until the stage says it is there
  virtual Result<void> halt() { return {}; }        ///< stops a move that was begun, as quickly as the stage can
};

/// Encoder and sensor sampled together.
struct StreamedAngle {
  double timeS = 0.0;
  double encoderDeg = 0.0; ///< unwrapped
  double sensorDeg = 0.0;  ///< [0, 360)
};

struct StreamBlock {
  std::vector<StreamedAngle> samples; ///< in order of time
  // What made no sample since the block before; capture records it as gaps:
  std::int64_t lost = 0;     ///< samples the instrument itself says it dropped
  std::int64_t rejected = 0; ///< lines that came and were no readings
  std::int64_t unpaired = 0; ///< readings of the encoder without readings of the sensor close enough in time
};

struct StreamRequest {
  double rateHz = 0.0;      ///< an instrument with a rate of its own keeps that; capture says so where they differ
  PairingRule pairing = {}; ///< of two instruments: its greatest age. Always interpolated, for the shaft turns
};

/// Samples encoder and sensor by itself at a fixed rate while the shaft turns. Thread: the capture thread only.
class AngleStream {
public:
  virtual ~AngleStream() = default;
  virtual Result<void> start(const StreamRequest& request) = 0;
  virtual Result<StreamBlock> read() = 0; ///< everything since start or the last read; does not wait
  virtual Result<void> stop() = 0;
};

/// Ambient temperature. Optional. Thread: the capture thread only.
class Thermometer {
public:
  virtual ~Thermometer() = default;
  virtual Result<TimedReading> readC() = 0;
};

/// The bench's clock, so that a simulated bench can run faster than real time.
class BenchClock {
public:
  virtual ~BenchClock() = default;
  virtual double nowS() const = 0;
  virtual void sleepS(double seconds) = 0;
};

/// Roles filled by instruments; the owner of the pointers outlives the bench.
struct AngleBench {
  std::string name;
  AngleSensor* sensor = nullptr;
  AngleReference* reference = nullptr;
  RotaryStage* stage = nullptr;       ///< optional
  Thermometer* thermometer = nullptr; ///< optional
  AngleStream* stream = nullptr;      ///< optional: needed for plans with a sample rate
  BenchClock* clock = nullptr;
  BenchConnection* connection = nullptr; ///< optional: instruments that can be unplugged
};

} // namespace straightedge::devices
