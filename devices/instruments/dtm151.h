// Group3 DTM-151: one-axis Hall teslameter on RS-232, as a reference with a sign, and its probe's thermometer.
#pragma once

#include "devices/instruments/conversation.h"
#include "devices/instruments/dtm151_reply.h"
#include "devices/instruments/field_instruments.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/transport/serial_settings.h"

#include <memory>

namespace straightedge::devices {

/// As set by its DIP switches; this is how it is delivered (?).
inline constexpr SerialSettings dtm151Serial = {.baud = 9600};

const std::vector<SettingDescription>& dtm151Settings();

/// Setters are silent on success; what is wrong with them comes as text before the next reply. "Locked" means: a value
/// in range.
class Dtm151 : public Instrument, public FieldReference, public Thermometer {
public:
  static Result<std::unique_ptr<Instrument>> make(Transport& transport, BenchClock& clock,
                                                  const SettingValues& settings);
  struct Options {
    int range = 3;      ///< 0 to 3: 0.3, 0.6, 1.2, 3 T
    bool filter = true; ///< its digital filter: quieter and slower
  };
  Dtm151(Transport& transport, BenchClock& clock, const Options& options);

  Result<void> prepare() override;
  InstrumentIdentity identity() const override { return {.model = "Group3 DTM-151", .serial = {}, .firmware = {}}; }
  std::optional<TransportFault> lastFault() const override { return m_talk.lastFault(); }
  FieldReference* fieldReference() override { return this; }
  Thermometer* thermometer() override { return this; }

  Result<FieldReferenceReading> readT() override;
  bool knowsSign() const override { return true; }
  Result<TimedReading> readC() override;

private:
  Result<void> expectReply(std::string_view query, std::string_view wanted);

  BenchClock& m_clock;
  Conversation m_talk;
  Options m_options;
};

} // namespace straightedge::devices
