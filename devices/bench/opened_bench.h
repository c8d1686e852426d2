// A saved bench with its instruments open: the roles that a capture is run on.
#pragma once

#include "devices/bench/bench_seat.h"
#include "devices/bench/bench_stream.h"
#include "devices/instruments/bench_connection.h"
#include "devices/instruments/field_bench.h"
#include "devices/simulated/bench_clock.h"

#include <memory>
#include <vector>

namespace straightedge::devices {

/// Thread: made by the controlling thread, then the capture thread's while a capture runs.
class OpenedBench final : public BenchConnection {
public:
  /// Opens all instruments of the bench. `list` finds devices; listDevices() if it is empty. Errors: those of
  /// BenchSeat.
  static Result<std::unique_ptr<OpenedBench>> open(const SavedBench& bench, const ProfileSet& profiles,
                                                   DeviceLister list = {});

  /// Errors (Instrument): a role that is needed is not filled. The bench is turned by hand: no stage has a driver yet.
  Result<AngleBench> angleBench();
  Result<FieldBench> fieldBench();
  const SavedBench& saved() const { return m_saved; }

  std::optional<TransportFault> lastFault() const override;
  Result<bool> restore() override;

private:
  OpenedBench(SavedBench bench, DeviceLister list) : m_saved(std::move(bench)), m_list(std::move(list)) {}
  template <typename Role>
  Role* filled(Role* (BenchSeat::*role)());
  template <typename Role>
  BenchSeat* seatOf(Role* (BenchSeat::*role)()) const;
  std::unexpected<Error> unfilled(InstrumentRole role) const;

  SavedBench m_saved;
  DeviceLister m_list;
  RealTimeClock m_clock;
  std::vector<std::unique_ptr<BenchSeat>> m_seats;
  std::unique_ptr<BenchStream> m_stream; ///< null where the instruments cannot stream
};

} // namespace straightedge::devices
