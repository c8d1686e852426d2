// Metrolab PT2025: NMR teslameter on RS-232.
#pragma once

#include "devices/instruments/conversation.h"
#include "devices/instruments/field_instruments.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/instruments/pt2025_reply.h"
#include "devices/transport/serial_settings.h"

#include <memory>
#include <string>

namespace straightedge::devices {

inline constexpr SerialSettings pt2025Serial = {.baud = 19200};

const std::vector<SettingDescription>& pt2025Settings();

/// Magnitudes only, and only locked ones: whatever else it shows is a reading without a value. Commands: lnls-ima
/// hall-bench-control NMRLib.py and a real session; status retries: fsc2 pt2025.c. The ranges of the probes are not
/// confirmed.
class Pt2025 : public Instrument, public FieldReference {
public:
  static Result<std::unique_ptr<Instrument>> make(Transport& transport, BenchClock& clock,
                                                  const SettingValues& settings);
  struct Options {
    char probe = 'A';      ///< channel, A to H
    bool automatic = true; ///< follows the field by itself
    bool negative = false; ///< sense of the field
    std::string coarse;    ///< the coarse setting of the search, "0" to "4095"; empty: left as it is
    bool search = false;   ///< from `coarse` on
    bool fastDisplay = false;
  };
  Pt2025(Transport& transport, BenchClock& clock, Options options);

  Result<void> prepare() override;
  InstrumentIdentity identity() const override { return {.model = "Metrolab PT2025", .serial = {}, .firmware = {}}; }
  std::optional<TransportFault> lastFault() const override { return m_talk.lastFault(); }
  FieldReference* fieldReference() override { return this; }

  Result<FieldReferenceReading> readT() override;
  Result<unsigned> status(int reg); ///< bits of register 1 to 4

private:
  Result<void> command(std::string_view text);
  Result<Pt2025Reading> reading(double& timeS);

  BenchClock& m_clock;
  Conversation m_talk;
  Options m_options;
};

} // namespace straightedge::devices
