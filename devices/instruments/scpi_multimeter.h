// Multimeters of the 34401A family: PT100 in ohms, or the voltage of an analogue angle sensor.
#pragma once

#include "devices/instruments/field_instruments.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/instruments/scpi_replies.h"
#include "devices/transport/serial_settings.h"

#include <memory>
#include <string>

namespace straightedge::devices {

/// 9600 baud, 8 data bits, 2 stop bits, no parity; DTR/DSR handshake is left to the cable. It is set at the
/// instrument's menu.
inline constexpr SerialSettings scpiMultimeterSerial = {.baud = 9600, .stopBits = 2};

const std::vector<SettingDescription>& scpiMultimeterSettings();

/// Commands and replies: pymeasure hp34401A.py and its test. An overload (9.9e37) is an error and never a reading.
class ScpiMultimeter : public Instrument, public ResistanceMeter, public AngleSensor {
public:
  static Result<std::unique_ptr<Instrument>> make(Transport& transport, BenchClock& clock,
                                                  const SettingValues& settings);
  struct Options {
    bool volts = false;            ///< otherwise ohms
    std::string setUp;             ///< the CONF command
    double powerLineCycles = 10.0; ///< integration time; 0: left as it is
    double degPerVolt = 72.0;      ///< of an analogue angle sensor
    double offsetDeg = 0.0;
  };
  ScpiMultimeter(Transport& transport, const BenchClock& clock, Options options);

  Result<void> prepare() override;
  InstrumentIdentity identity() const override { return m_identity; }
  std::optional<TransportFault> lastFault() const override { return m_talk.lastFault(); }
  ResistanceMeter* resistanceMeter() override { return m_options.volts ? nullptr : this; }
  AngleSensor* angleSensor() override { return m_options.volts ? this : nullptr; }

  Result<TimedReading> readOhm() override { return read(); }
  Result<TimedReading> readDeg() override;

private:
  Result<TimedReading> read();

  Conversation m_talk;
  Options m_options;
  InstrumentIdentity m_identity;
};

} // namespace straightedge::devices
