// A saved bench with its instruments open: the roles that a capture is run on.
#pragma once

#include "devices/bench/bench_seat.h"
#include "devices/bench/bench_stream.h"
#include "devices/instruments/bench_connection.h"
#include "devices/instruments/field_bench.h"
#include "devices/simulated/bench_clock.h"

#include <memory>
#include <string_view>
#include <vector>

namespace straightedge::devices {

/// What an instrument in a role reads right now.
struct RoleReading {
  std::vector<double> values; ///< degrees, tesla (three of them for a field probe), ohms, °C; empty where there is none
  std::string note;           ///< why there is none although the instrument answered: "not locked"
  std::optional<double> electronicsC = {}; ///< of a field probe that measures its own temperature
};

/// Thread: made by one thread, which asks for the bench; then readings, say() and restore() may come from any, and take
/// turns at each instrument.
class OpenedBench final : public BenchConnection {
public:
  /// Opens all instruments of the bench. `list` finds devices; listDevices() if it is empty. `listener`, if any, hears
  /// all that is said with them. Errors: those of BenchSeat.
  static Result<std::unique_ptr<OpenedBench>> open(const SavedBench& bench, const ProfileSet& profiles,
                                                   DeviceLister list = {}, const BenchDialogueListener& listener = {});

  /// Errors (Instrument): a role that is needed is not filled. The bench is turned by hand: no stage has a driver yet.
  Result<AngleBench> angleBench();
  Result<FieldBench> fieldBench();
  const SavedBench& saved() const { return m_saved; }
  const std::string& instrumentName(std::size_t index) const { return m_seats.at(index)->name(); } ///< as in saved()

  /// For a live display. Errors (Instrument): no instrument fills the role, or not with its settings; its own.
  Result<RoleReading> readRole(InstrumentRole role);
  /// For a console: BenchSeat::say() of the instrument with this place in saved().
  Result<std::string> say(std::size_t index, std::string_view bytes) { return m_seats.at(index)->say(bytes); }

  bool allThere() const; ///< none has left, as far as its last transfer told

  std::optional<TransportFault> lastFault() const override;
  Result<bool> restore() override;

private:
  OpenedBench(SavedBench bench, DeviceLister list) : m_saved(std::move(bench)), m_list(std::move(list)) {}
  template <typename Role>
  Role* filled(Role* (BenchSeat::*role)());
  template <typename Role>
  BenchSeat* seatOf(Role* (BenchSeat::*role)()) const;
  std::unexpected<Error> unfilled(InstrumentRole role) const;
  template <typename Role>
  Result<RoleReading> readValue(InstrumentRole role, Role* (BenchSeat::*filler)(),
                                Result<TimedReading> (Role::*read)());

  SavedBench m_saved;
  DeviceLister m_list;
  RealTimeClock m_clock;
  std::vector<std::unique_ptr<BenchSeat>> m_seats;
  std::unique_ptr<BenchStream> m_stream; ///< null where the instruments cannot stream
};

} // namespace straightedge::devices
