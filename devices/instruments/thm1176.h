// Metrolab THM1176 and TFM1186: three-axis Hall teslameters on USBTMC, 1bfa:0498.
#pragma once

#include "devices/instruments/field_instruments.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/instruments/scpi_replies.h"
#include "devices/instruments/thm1176_reply.h"

#include <memory>
#include <optional>

namespace straightedge::devices {

const std::vector<SettingDescription>& thm1176Settings();

/// Commands: Hyperfine/pyTHM1176 thm_usbtmc_api.py, manual p. 45. The drivers that exist reset the USB device when they
/// open it
/// ("left hanging"); that is the transport's affair. Not confirmed by a primary text, and not yet tried on hardware:
/// the reply to RANG:AUTO, what an axis beyond its range looks like, the third number of FETC:ARR (digits).
class Thm1176 : public Instrument, public FieldProbe {
public:
  static Result<std::unique_ptr<Instrument>> make(Transport& transport, BenchClock& clock,
                                                  const SettingValues& settings);
  struct Options {
    std::optional<double> rangeT = 3.0; ///< none: automatic
    int averages = 1;
    std::optional<double> celsiusPerCount; ///< its temperature is in counts: without this there is none in °C
    double celsiusAtZero = 0.0;
  };
  Thm1176(Transport& transport, const BenchClock& clock, const Options& options);

  Result<void> prepare() override;
  InstrumentIdentity identity() const override { return m_identity; }
  std::optional<TransportFault> lastFault() const override { return m_talk.lastFault(); }
  FieldProbe* fieldProbe() override { return this; }

  Result<FieldReading> readT() override;
  bool measuresElectronics() const override { return m_options.celsiusPerCount.has_value(); }
  const std::optional<Thm1176Reply>& lastReply() const { return m_lastReply; } ///< with stamp and temperature as sent

  /// Zeroes the probe in a zero-field chamber: about 6 s.
  Result<void> zero();

private:
  Conversation m_talk;
  Options m_options;
  InstrumentIdentity m_identity;
  std::optional<Thm1176Reply> m_lastReply;
};

} // namespace straightedge::devices
