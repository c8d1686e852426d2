#include "devices/bench/opened_bench.h"

#include <algorithm>

namespace straightedge::devices {

Result<std::unique_ptr<OpenedBench>> OpenedBench::open(const SavedBench& bench, const ProfileSet& profiles,
                                                       DeviceLister list, const BenchDialogueListener& listener) {
  if (!list) {
    list = [profiles] { return listDevices(profiles); };
  }
  std::unique_ptr<OpenedBench> opened(new OpenedBench(bench, std::move(list)));
  for (const BenchInstrument& wanted : bench.instruments) {
    auto seat = BenchSeat::make(wanted, profiles, opened->m_clock, listener);
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
Role* OpenedBench::filled(Role* (BenchSeat::*role)()) {
  for (const auto& seat : m_seats) {
    if (Role* found = (seat.get()->*role)()) {
      return found;
    }
  }
  return nullptr;
}

std::unexpected<Error> OpenedBench::unfilled(InstrumentRole role) const {
  if (const BenchInstrument* chosen = m_saved.filling(role)) {
    return fail(ErrorKind::Instrument,
                chosen->instrument + " does not fill the role " + std::string(roleWord(role)) + " with its settings",
                "change its settings, or give the role to another instrument", m_saved.name);
  }
  return fail(ErrorKind::Instrument, "no instrument of the bench fills the role " + std::string(roleWord(role)),
              "give the role to an instrument", m_saved.name);
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
  return bench;
}

Result<FieldBench> OpenedBench::fieldBench() {
  FieldBench bench;
  bench.name = m_saved.name;
  bench.probe = filled(&BenchSeat::fieldProbe);
  bench.reference = filled(&BenchSeat::fieldReference);
  bench.pt100 = filled(&BenchSeat::resistanceMeter);
  bench.electronics = filled(&BenchSeat::thermometer);
  bench.chamber = filled(&BenchSeat::chamberThermometer);
  bench.clock = &m_clock;
  bench.connection = this;
  if (bench.probe == nullptr) {
    return unfilled(InstrumentRole::FieldProbe);
  }
  return bench;
}

namespace {

Result<RoleReading> shownReading(const Result<TimedReading>& reading) {
  return reading ? Result<RoleReading>(RoleReading{.values = {reading->value}, .note = {}})
                 : std::unexpected(reading.error());
}

Result<RoleReading> shownReading(const Result<FieldReading>& reading) {
  if (!reading) {
    return std::unexpected(reading.error());
  }
  RoleReading read{.values = {}, .note = {}, .electronicsC = reading->electronicsC};
  if (reading->overRange) {
    read.note = "beyond its range";
  } else {
    read.values.assign(reading->rawT.begin(), reading->rawT.end());
  }
  return read;
}

Result<RoleReading> shownReading(const Result<FieldReferenceReading>& reading) {
  if (!reading) {
    return std::unexpected(reading.error());
  }
  return reading->locked && reading->fieldT ? RoleReading{.values = {*reading->fieldT}, .note = {}}
                                            : RoleReading{.values = {}, .note = "not locked"};
}

} // namespace

template <typename Role>
Result<RoleReading> OpenedBench::readValue(InstrumentRole role, Role* (BenchSeat::*filler)(),
                                           Result<TimedReading> (Role::*read)()) {
  Role* const asked = filled(filler);
  if (asked == nullptr) {
    return unfilled(role);
  }
  return shownReading((asked->*read)());
}

Result<RoleReading> OpenedBench::readRole(InstrumentRole role) {
  switch (role) {
  case InstrumentRole::AngleSensor:
    return readValue(role, &BenchSeat::angleSensor, &AngleSensor::readDeg);
  case InstrumentRole::AngleReference:
    return readValue(role, &BenchSeat::angleReference, &AngleReference::readDeg);
  case InstrumentRole::Resistance:
    return readValue(role, &BenchSeat::resistanceMeter, &ResistanceMeter::readOhm);
  case InstrumentRole::Temperature:
    return readValue(role, &BenchSeat::thermometer, &Thermometer::readC);
  case InstrumentRole::ChamberTemperature:
    return readValue(role, &BenchSeat::chamberThermometer, &Thermometer::readC);
  case InstrumentRole::FieldProbe:
    if (FieldProbe* probe = filled(&BenchSeat::fieldProbe)) {
      return shownReading(probe->readT());
    }
    break;
  case InstrumentRole::FieldReference:
    if (FieldReference* reference = filled(&BenchSeat::fieldReference)) {
      return shownReading(reference->readT());
    }
    break;
  }
  return unfilled(role);
}

bool OpenedBench::allThere() const {
  return std::ranges::all_of(m_seats, [](const auto& seat) { return seat->isThere(); });
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
