#include "devices/bench/bench_check.h"

#include "devices/bench/bench_seat.h"
#include "devices/simulated/bench_clock.h"

#include <set>

namespace straightedge::devices {

namespace {

/// Behind an instrument that is made only to see whether its settings are right.
class NoTransport : public Transport {
public:
  std::string name() const override { return "nothing"; }
  TransportResult<void> write(std::string_view, Milliseconds) override { return none(); }
  TransportResult<std::string> read(Milliseconds) override { return none(); }
  TransportResult<std::string> readUntil(std::string_view, Milliseconds) override { return none(); }
  TransportResult<void> clear() override { return none(); }

private:
  static std::unexpected<TransportError> none() {
    return std::unexpected(TransportError{TransportFault::Unsupported,
                                          {ErrorKind::Instrument, "nothing is connected here", "open the bench", {}}});
  }
};

} // namespace

Result<void> checkBenchInstrument(const BenchInstrument& instrument, const ProfileSet& profiles) {
  RealTimeClock clock;
  if (const auto seat = BenchSeat::make(instrument, profiles, clock); !seat) {
    return std::unexpected(seat.error());
  }
  const KnownInstrument* known = knownInstrument(instrument.instrument);
  if (known == nullptr) {
    if (!instrument.settings.empty()) {
      return fail(ErrorKind::Usage, "there is no setting '" + instrument.settings.begin()->first + "'",
                  "change the profile's file instead", instrument.instrument);
    }
    return {};
  }
  NoTransport transport;
  auto made = known->make(transport, clock, instrument.settings);
  return made ? Result<void>{} : std::unexpected(std::move(made.error()));
}

Result<void> checkBench(const SavedBench& bench, const ProfileSet& profiles) {
  std::set<InstrumentRole> filled;
  for (const BenchInstrument& instrument : bench.instruments) {
    for (const InstrumentRole role : instrument.roles) {
      if (!filled.insert(role).second) {
        return fail(ErrorKind::Input, "two instruments fill the role " + std::string(roleWord(role)),
                    "give it to one of them", bench.name);
      }
    }
    if (auto checked = checkBenchInstrument(instrument, profiles); !checked) {
      return checked;
    }
  }
  return {};
}

} // namespace straightedge::devices
