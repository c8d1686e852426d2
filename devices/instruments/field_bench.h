// What a field bench is made of beside teslameter and reference: magnet, placement, chambers; and the roles together.
#pragma once

#include "devices/instruments/field_instruments.h"

#include <cstdint>
#include <string>

namespace straightedge::devices {

/// Where the teslameter's probe is and how it lies. Numbered as field::Orientation, then the zero-field chamber.
enum class ProbePlacement : std::uint8_t { PlusX, MinusX, PlusY, MinusY, PlusZ, MinusZ, ZeroChamber };

/// The electromagnet. Absent where the field is set by hand. Thread: the capture thread only.
class FieldMagnet {
public:
  virtual ~FieldMagnet() = default;
  virtual InstrumentIdentity identity() const = 0;
  virtual Result<void> setFieldT(double fieldT) = 0; ///< along its own direction, signed; returns at once
};

/// Turns the probe and carries it between magnet and zero-field chamber. Absent where that is done by hand, as on most
/// benches: then the plan's stages wait for a person. Thread: the capture thread only.
class ProbeCarrier {
public:
  virtual ~ProbeCarrier() = default;
  virtual Result<void> place(ProbePlacement placement) = 0; ///< returns when it is there
};

/// Heats and cools the probe (chamber, Peltier element) or the electronics (climate chamber). Thread: the capture
/// thread only.
class TemperatureChamber {
public:
  virtual ~TemperatureChamber() = default;
  virtual InstrumentIdentity identity() const = 0;
  virtual Result<void> setC(double temperatureC) = 0; ///< returns at once
  virtual Result<TimedReading> readC() = 0;           ///< of the chamber, not of what is in it
};

/// Roles filled by instruments; the owner of the pointers outlives the bench. What is null leaves its column empty, and
/// what it would have done is done by hand.
struct FieldBench {
  std::string name;
  FieldProbe* probe = nullptr;                      ///< required
  FieldReference* reference = nullptr;              ///< stages with a reference need it
  ResistanceMeter* pt100 = nullptr;                 ///< optional
  Thermometer* electronics = nullptr;               ///< optional; else what the probe says of itself
  Thermometer* chamber = nullptr;                   ///< optional: in the probe's chamber, where that has no driver
  FieldMagnet* magnet = nullptr;                    ///< optional
  ProbeCarrier* carrier = nullptr;                  ///< optional
  TemperatureChamber* probeChamber = nullptr;       ///< optional: temperature sweeps of the probe
  TemperatureChamber* electronicsChamber = nullptr; ///< optional: temperature sweeps of the electronics
  BenchClock* clock = nullptr;                      ///< required
  BenchConnection* connection = nullptr;            ///< optional: instruments that can be unplugged
};

} // namespace straightedge::devices
