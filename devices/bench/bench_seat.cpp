#include "devices/bench/bench_seat.h"

#include "core/base/number_text.h"
#include "devices/instruments/profile_instrument.h"
#include "devices/transport/recording_transport.h"
#include "devices/transport/usb_serial_transport.h"
#include "devices/transport/usbtmc_transport.h"

#include <algorithm>

namespace straightedge::devices {

namespace {

// Of what a person sends by hand: how long it may take, and on a line how long to listen for an answer.
constexpr Milliseconds saidWithin{1000};
constexpr Milliseconds answeredWithin{2000};
constexpr Milliseconds lineAnsweredWithin{500};
constexpr Milliseconds lineQuietAfter{100};
constexpr int staleReads = 8;

std::unexpected<Error> profileOrDriverMissing(const std::string& id) {
  return fail(ErrorKind::Input, "there is no instrument '" + id + "'",
              "use an id of the instrument table or the name of a profile's file without .json", "bench");
}

template <typename To, typename From>
TransportResult<std::unique_ptr<Transport>> asTransport(TransportResult<std::unique_ptr<From>> opened) {
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  return std::unique_ptr<To>(std::move(*opened));
}

} // namespace

/// The roles as a bench holds them.
struct BenchSeat::Roles {
  struct Sensor : AngleSensor {
    BenchSeat* seat = nullptr;
    InstrumentIdentity identity() const override { return seat->m_identity; }
    Result<TimedReading> readDeg() override { return seat->ask(&Instrument::angleSensor, &AngleSensor::readDeg); }
  } sensor;
  struct Reference : AngleReference {
    BenchSeat* seat = nullptr;
    InstrumentIdentity identity() const override { return seat->m_identity; }
    Result<TimedReading> readDeg() override { return seat->ask(&Instrument::angleReference, &AngleReference::readDeg); }
    std::optional<double> incrementDeg() const override { return seat->m_incrementDeg; }
    int timesOpened() const override {
      const std::lock_guard turn(seat->m_turn);
      return seat->m_opened;
    }
  } reference;
  struct Probe : FieldProbe {
    BenchSeat* seat = nullptr;
    InstrumentIdentity identity() const override { return seat->m_identity; }
    Result<FieldReading> readT() override { return seat->ask(&Instrument::fieldProbe, &FieldProbe::readT); }
    bool measuresElectronics() const override { return seat->m_measuresElectronics; }
  } probe;
  struct Field : FieldReference {
    BenchSeat* seat = nullptr;
    InstrumentIdentity identity() const override { return seat->m_identity; }
    Result<FieldReferenceReading> readT() override {
      return seat->ask(&Instrument::fieldReference, &FieldReference::readT);
    }
    bool knowsSign() const override { return seat->m_knowsSign; }
  } field;
  struct Resistance : ResistanceMeter {
    BenchSeat* seat = nullptr;
    InstrumentIdentity identity() const override { return seat->m_identity; }
    Result<TimedReading> readOhm() override {
      return seat->ask(&Instrument::resistanceMeter, &ResistanceMeter::readOhm);
    }
  } resistance;
  struct Temperature : Thermometer {
    BenchSeat* seat = nullptr;
    Result<TimedReading> readC() override { return seat->ask(&Instrument::thermometer, &Thermometer::readC); }
  } temperature;
};

BenchSeat::BenchSeat(BenchInstrument wanted, BenchClock& clock)
    : m_wanted(std::move(wanted)), m_clock(clock), m_roles(std::make_unique<Roles>()) {
  m_roles->sensor.seat = m_roles->reference.seat = m_roles->probe.seat = this;
  m_roles->field.seat = m_roles->resistance.seat = m_roles->temperature.seat = this;
}

BenchSeat::~BenchSeat() = default;

Result<std::unique_ptr<BenchSeat>> BenchSeat::make(BenchInstrument wanted, const ProfileSet& profiles,
                                                   BenchClock& clock, BenchDialogueListener listener) {
  std::unique_ptr<BenchSeat> seat(new BenchSeat(std::move(wanted), clock));
  seat->m_listener = std::move(listener);
  const BenchInstrument& asked = seat->m_wanted;
  std::vector<InstrumentRole> canFill;
  seat->m_known = knownInstrument(asked.instrument);
  if (seat->m_known != nullptr) {
    seat->m_name = std::string(seat->m_known->name);
    canFill = seat->m_known->roles;
  } else if (const Profile* profile = findProfile(profiles, asked.instrument)) {
    seat->m_profile = *profile;
    seat->m_name = profile->name;
    canFill = rolesOf(*profile);
  } else {
    return profileOrDriverMissing(asked.instrument);
  }
  seat->m_name += asked.serial.empty() ? " at " + asked.port : ", serial " + asked.serial;
  for (const InstrumentRole role : asked.roles) {
    if (std::ranges::find(canFill, abilityFor(role)) == canFill.end()) {
      return fail(ErrorKind::Input, seat->m_name + " cannot fill the role " + std::string(roleWord(role)),
                  "give the role to another instrument", "bench");
    }
  }
  return seat;
}

Error BenchSeat::named(Error error) const {
  error.where = error.where.empty() ? m_name : m_name + " (" + error.where + ")";
  return error;
}

std::unexpected<Error> BenchSeat::notThere() const {
  return fail(ErrorKind::Instrument, "the instrument is not plugged in", "plug it in and switch it on", m_name);
}

Result<ListedDevice> BenchSeat::find(const DeviceLister& list) const {
  auto all = list();
  if (!all) {
    return std::unexpected(std::move(all.error()));
  }
  std::erase_if(*all, [this](const ListedDevice& device) {
    if (device.serial != m_wanted.serial) {
      return true;
    }
    // A serial number alone is no proof where the ids say that it is something else.
    return !device.instrument.empty() && m_known != nullptr && device.instrument != m_wanted.instrument &&
           knownInstrument(device.instrument) != nullptr;
  });
  if (all->empty()) {
    return notThere();
  }
  if (all->size() > 1) {
    return fail(ErrorKind::Instrument, "two devices with this serial number are plugged in", "unplug one of them",
                m_name);
  }
  return std::move(all->front());
}

bool BenchSeat::isPluggedIn(const DeviceLister& list) const { return !m_wanted.port.empty() || find(list).has_value(); }

SerialSettings BenchSeat::serialSettings() const {
  const auto own = m_known != nullptr ? m_known->serial : m_profile->serial;
  SerialSettings settings = own.value_or(SerialSettings{});
  settings.baud = m_wanted.baud.value_or(settings.baud);
  return settings;
}

TransportResult<std::unique_ptr<Transport>> BenchSeat::openTransport(const ListedDevice& device) const {
  if (device.usb && UsbTmcTransport::interfaceOf(*device.usb) != nullptr) {
    return asTransport<Transport>(UsbTmcTransport::open(*device.usb));
  }
  // The kernel's tty where there is one: other programs can then see that it is in use.
  if (device.port) {
    auto opened = openSerialPort(device.port->path, serialSettings());
    if (opened || opened.error().fault != TransportFault::AccessDenied || !device.usb) {
      return opened;
    }
  }
  if (device.usb) {
    return asTransport<Transport>(UsbSerialTransport::open(*device.usb, serialSettings()));
  }
  return std::unexpected(TransportError{TransportFault::Unsupported,
                                        Error{ErrorKind::Instrument, "the device is neither USBTMC nor a serial line",
                                              "choose another connection", m_name}});
}

std::unique_ptr<Transport> BenchSeat::listenedTo(std::unique_ptr<Transport> transport) {
  if (!m_listener) {
    return transport;
  }
  // A connection counts from its success: tries that failed belong to the one that follows.
  return std::make_unique<RecordingTransport>(std::move(transport),
                                              [this, connection = m_opened + 1](const DialogueEntry& entry) {
                                                m_listener({.instrument = m_name,
                                                            .wanted = m_wanted,
                                                            .connection = connection,
                                                            .transport = *m_transport,
                                                            .entry = entry});
                                              });
}

bool BenchSeat::isThere() const {
  const std::lock_guard turn(m_turn);
  return m_instrument != nullptr && !m_gone;
}

std::optional<TransportFault> BenchSeat::lastFault() const {
  const std::lock_guard turn(m_turn);
  return m_lastFault;
}

void BenchSeat::forgetFault() {
  const std::lock_guard turn(m_turn);
  m_lastFault.reset();
}

Result<void> BenchSeat::open(const DeviceLister& list) {
  const std::lock_guard turn(m_turn);
  m_instrument.reset();
  m_transport.reset(); // gives the device back before it is opened again
  m_lastFault.reset();
  ListedDevice device;
  if (m_wanted.serial.empty()) {
    device.port.emplace();
    device.port->path = m_wanted.port;
  } else {
    auto found = find(list);
    if (!found) {
      return std::unexpected(std::move(found.error()));
    }
    device = *std::move(found);
  }
  auto transport = openTransport(device);
  if (!transport) {
    return std::unexpected(named(std::move(transport.error().error)));
  }
  m_transport = listenedTo(*std::move(transport));
  std::unique_ptr<Instrument> instrument;
  if (m_known != nullptr) {
    auto made = m_known->make(*m_transport, m_clock, m_wanted.settings);
    if (!made) {
      return std::unexpected(named(std::move(made.error())));
    }
    instrument = *std::move(made);
  } else {
    instrument = makeProfileInstrument(*m_transport, m_clock, *m_profile);
  }
  if (auto prepared = instrument->prepare(); !prepared) {
    return std::unexpected(named(std::move(prepared.error())));
  }
  InstrumentIdentity identity = instrument->identity();
  if (!m_identity.serial.empty() && identity.serial != m_identity.serial) {
    return fail(ErrorKind::Instrument,
                "it says it has the serial number " + identity.serial + " and not " + m_identity.serial + " as before",
                "plug in the one that the capture began with", m_name);
  }
  m_identity = std::move(identity);
  m_identity.model = m_identity.model.empty() ? m_name : m_identity.model;
  m_instrument = std::move(instrument);
  m_knowsSign = m_instrument->fieldReference() != nullptr && m_instrument->fieldReference()->knowsSign();
  m_measuresElectronics = m_instrument->fieldProbe() != nullptr && m_instrument->fieldProbe()->measuresElectronics();
  m_incrementDeg =
      m_instrument->angleReference() != nullptr ? m_instrument->angleReference()->incrementDeg() : std::nullopt;
  m_gone = false;
  ++m_opened;
  return {};
}

template <typename T>
Result<T> BenchSeat::told(Result<T> outcome) {
  if (outcome) {
    m_lastFault.reset();
    outcome->timeS -= m_wanted.latencyS;
    return outcome;
  }
  m_lastFault = m_instrument->lastFault();
  m_gone = m_gone || m_lastFault == TransportFault::Gone;
  return std::unexpected(named(std::move(outcome.error())));
}

template <typename Role, typename Reading>
Result<Reading> BenchSeat::ask(Role* (Instrument::*role)(), Result<Reading> (Role::*read)()) {
  const std::lock_guard turn(m_turn);
  Role* const asked = m_instrument != nullptr && !m_gone ? (m_instrument.get()->*role)() : nullptr;
  if (asked == nullptr) {
    m_gone = true;
    m_lastFault = TransportFault::Gone;
    return notThere();
  }
  return told((asked->*read)());
}

TransportResult<std::string> BenchSeat::answer(std::string_view question) {
  // On a line what came before, the end of an earlier reply say, is no answer to this. A board that prints without end
  // stays ahead of the reader.
  for (int i = 0; !m_transport->hasMessages() && i < staleReads && m_transport->read(Milliseconds{0}); ++i) {
  }
  if (auto sent = m_transport->write(question, saidWithin); !sent) {
    return std::unexpected(std::move(sent.error()));
  }
  if (m_transport->hasMessages()) { // IEEE 488.2: asking for a message that was not queried is an error
    return question.contains('?') ? m_transport->read(answeredWithin) : std::string();
  }
  std::string all;
  const auto end = std::chrono::steady_clock::now() + lineAnsweredWithin;
  do {
    auto came = m_transport->read(all.empty() ? lineAnsweredWithin : lineQuietAfter);
    if (!came && came.error().fault != TransportFault::TimedOut) {
      return came;
    }
    if (!came) {
      break;
    }
    all += *came;
  } while (!all.ends_with('\n') && std::chrono::steady_clock::now() < end); // a board may print without end
  return all;
}

Result<std::string> BenchSeat::say(std::string_view bytes) {
  const std::lock_guard turn(m_turn);
  if (m_instrument == nullptr || m_gone) {
    return notThere();
  }
  auto said = answer(bytes);
  if (!said) {
    m_gone = said.error().fault == TransportFault::Gone;
    return std::unexpected(named(std::move(said.error().error)));
  }
  return *std::move(said);
}

ReadingStream* BenchSeat::angleReadings(InstrumentRole role) {
  return fills(role) && isThere() ? m_instrument->angleReadings(role) : nullptr;
}

AngleStream* BenchSeat::angleStream() {
  const bool both = fills(InstrumentRole::AngleSensor) && fills(InstrumentRole::AngleReference);
  return both && isThere() ? m_instrument->angleStream() : nullptr;
}

std::unexpected<Error> BenchSeat::streamFault(Error error) {
  const std::lock_guard turn(m_turn);
  m_lastFault = m_instrument->lastFault();
  m_gone = m_gone || m_lastFault == TransportFault::Gone;
  return std::unexpected(named(std::move(error)));
}

std::unexpected<Error> BenchSeat::silent(double seconds) {
  const std::lock_guard turn(m_turn);
  m_lastFault = TransportFault::TimedOut;
  return fail(ErrorKind::Instrument, "nothing that is a reading came for " + formatForPeople(seconds, 3) + " s",
              "check the cable, the instrument's power and what it prints", m_name);
}

std::unexpected<Error> BenchSeat::absent() {
  const std::lock_guard turn(m_turn);
  m_gone = true;
  m_lastFault = TransportFault::Gone;
  return notThere();
}

bool BenchSeat::fills(InstrumentRole role) const {
  return std::ranges::find(m_wanted.roles, role) != m_wanted.roles.end();
}

AngleSensor* BenchSeat::angleSensor() {
  const bool can = fills(InstrumentRole::AngleSensor) && m_instrument && m_instrument->angleSensor() != nullptr;
  return can ? &m_roles->sensor : nullptr;
}
AngleReference* BenchSeat::angleReference() {
  const bool can = fills(InstrumentRole::AngleReference) && m_instrument && m_instrument->angleReference() != nullptr;
  return can ? &m_roles->reference : nullptr;
}
FieldProbe* BenchSeat::fieldProbe() {
  const bool can = fills(InstrumentRole::FieldProbe) && m_instrument && m_instrument->fieldProbe() != nullptr;
  return can ? &m_roles->probe : nullptr;
}
FieldReference* BenchSeat::fieldReference() {
  const bool can = fills(InstrumentRole::FieldReference) && m_instrument && m_instrument->fieldReference() != nullptr;
  return can ? &m_roles->field : nullptr;
}
ResistanceMeter* BenchSeat::resistanceMeter() {
  const bool can = fills(InstrumentRole::Resistance) && m_instrument && m_instrument->resistanceMeter() != nullptr;
  return can ? &m_roles->resistance : nullptr;
}
Thermometer* BenchSeat::thermometer() {
  const bool can = fills(InstrumentRole::Temperature) && m_instrument && m_instrument->thermometer() != nullptr;
  return can ? &m_roles->temperature : nullptr;
}
Thermometer* BenchSeat::chamberThermometer() {
  const bool can = fills(InstrumentRole::ChamberTemperature) && m_instrument && m_instrument->thermometer() != nullptr;
  return can ? &m_roles->temperature : nullptr;
}

} // namespace straightedge::devices
