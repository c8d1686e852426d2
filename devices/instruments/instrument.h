// An instrument behind a transport: which roles of a bench it can fill, and what its owner may ask of it beside
// readings.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/angle_instruments.h"
#include "devices/transport/transport.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace straightedge::devices {

class FieldProbe;      // devices/instruments/field_instruments.h
class FieldReference;  // devices/instruments/field_instruments.h
class ResistanceMeter; // devices/instruments/field_instruments.h

/// What an instrument is used for on a bench.
enum class InstrumentRole : std::uint8_t {
  AngleSensor,
  AngleReference,
  FieldProbe,
  FieldReference,
  Resistance,
  Temperature,       ///< of the surroundings; on a field bench of the teslameter's electronics
  ChamberTemperature ///< of the chamber around a field probe; whatever fills Temperature can fill it
};

/// "angle-sensor", "angle-reference", "field-probe", "field-reference", "resistance", "temperature",
/// "chamber-temperature": in profiles (but the last), saved benches and on the command line.
std::string_view roleWord(InstrumentRole role);
std::optional<InstrumentRole> roleFromWord(std::string_view word);

/// The role that tables and profiles name for instruments that can be given this one on a bench: itself but for
/// ChamberTemperature.
InstrumentRole abilityFor(InstrumentRole role);

/// Readings that came since the last look, in order of time.
struct ReadingBlock {
  std::vector<TimedReading> readings;
  std::int64_t lost = 0;     ///< readings the instrument itself says it dropped
  std::int64_t rejected = 0; ///< lines that came and were no reading: garbage, not a number, out of limits
};

/// An instrument that sends readings by itself. Thread: the capture thread only.
class ReadingStream {
public:
  virtual ~ReadingStream() = default;
  virtual Result<void> start() = 0;
  virtual Result<ReadingBlock> read() = 0; ///< everything since start or the last read; does not wait for more
  virtual Result<void> stop() = 0;
};

/// One instrument on one transport. Thread: the one that uses its transport. Nothing is ever made up: a reading that
/// did not come, came damaged, out of range or not locked is an error or a field that says so.
class Instrument {
public:
  virtual ~Instrument() = default;

  /// Asks who it is and sets it up; to be called before the first reading and again after the transport came back.
  /// Errors (Instrument): no answer, another instrument than expected, a setting refused.
  virtual Result<void> prepare() = 0;

  /// What prepare() learnt; empty fields where the instrument does not say.
  virtual InstrumentIdentity identity() const = 0;

  /// Fault of the transport behind the last error; none where the instrument answered, and its answer was the problem.
  virtual std::optional<TransportFault> lastFault() const = 0;

  /// The roles it can fill; null for the others. They live as long as the instrument and know its transport.
  virtual AngleSensor* angleSensor() { return nullptr; }
  virtual AngleReference* angleReference() { return nullptr; }
  /// Degrees, as a sensor within any turn, as a reference unwrapped; null where it does not send that by itself.
  virtual ReadingStream* angleReadings(InstrumentRole /*role*/) { return nullptr; }
  virtual AngleStream* angleStream() { return nullptr; } ///< both angles in one, where it sends both by itself
  virtual FieldProbe* fieldProbe() { return nullptr; }
  virtual FieldReference* fieldReference() { return nullptr; }
  virtual ResistanceMeter* resistanceMeter() { return nullptr; }
  virtual Thermometer* thermometer() { return nullptr; }
};

} // namespace straightedge::devices
