#include "devices/bench/opened_bench.h"

#include <algorithm>

namespace straightedge::devices {

Result<std::unique_ptr<OpenedBench>> OpenedBench::open(const SavedBench& bench, const ProfileSet& profiles,
                                                       DeviceLister list) {
  if (!list) {
    list = [profiles] { return listDevices(profiles); };
  }
  std::unique_ptr<OpenedBench> opened(new OpenedBench(bench, std::move(list)));
  for (const BenchInstrument& wanted : bench.instruments) {
    auto seat = BenchSeat::make(wanted, profiles, opened->m_clock);
    if (!seat) {
      return std::unexpected(std::move(seat.error()));
    }
    opened->m_seats.push_back(*std::move(seat));
  }
  for (const auto& seat : opened->m_seats) {
    if (auto done = seat->open(opened->m_list); !done) {
      return std::unexpected(std::move(done.error()));
    }
  }
  return opened;
}

template <typename Role>
BenchSeat* OpenedBench::seatOf(Role* (BenchSeat::*role)()) const {
  const auto found = std::ranges::find_if(m_seats, [&](const auto& seat) { return (seat.get()->*role)() != nullptr; });
  return found == m_seats.end() ? nullptr : found->get();
}

template <typename Role>
Role* OpenedBench::filled(Role* (BenchSeat::*role)()) {
  BenchSeat* seat = seatOf(role);
  return seat == nullptr ? nullptr : (seat->*role)();
}

std::unexpected<Error> OpenedBench::unfilled(InstrumentRole role) const {
  return fail(ErrorKind::Instrument, "no instrument of the bench fills the role " + std::string(roleWord(role)),
              "add one to the bench's file", m_saved.name);
}

Result<AngleBench> OpenedBench::angleBench() {
  AngleBench bench;
  bench.name = m_saved.name;
  bench.sensor = filled(&BenchSeat::angleSensor);
  bench.reference = filled(&BenchSeat::angleReference);
  bench.thermometer = filled(&BenchSeat::thermometer);
  bench.clock = &m_clock;
  bench.connection = this;
  if (bench.sensor == nullptr) {
    return unfilled(InstrumentRole::AngleSensor);
  }
  if (bench.reference == nullptr) {
    return unfilled(InstrumentRole::AngleReference);
  }
  if (!m_stream) { // one for all that ask: a capture may run on it
    m_stream = BenchStream::make(seatOf(&BenchSeat::angleReference), seatOf(&BenchSeat::angleSensor), m_clock);
  }
  bench.stream = m_stream.get();
  return bench;
}

Result<FieldBench> OpenedBench::fieldBench() {
  FieldBench bench;
  bench.name = m_saved.name;
  bench.probe = filled(&BenchSeat::fieldProbe);
  bench.reference = filled(&BenchSeat::fieldReference);
  bench.pt100 = filled(&BenchSeat::resistanceMeter);
  bench.electronics = filled(&BenchSeat::thermometer);
  bench.clock = &m_clock;
  bench.connection = this;
  if (bench.probe == nullptr) {
    return unfilled(InstrumentRole::FieldProbe);
  }
  return bench;
}

std::optional<TransportFault> OpenedBench::lastFault() const {
  for (const auto& seat : m_seats) {
    if (seat->lastFault()) {
      return seat->lastFault();
    }
  }
  return std::nullopt;
}

Result<bool> OpenedBench::restore() {
  for (const auto& seat : m_seats) {
    if (seat->isThere()) {
      continue;
    }
    if (!seat->isPluggedIn(m_list)) {
      return false;
    }
    if (auto opened = seat->open(m_list); !opened) {
      return std::unexpected(std::move(opened.error()));
    }
  }
  for (const auto& seat : m_seats) {
    seat->forgetFault();
  }
  return true;
}

} // namespace straightedge::devices
