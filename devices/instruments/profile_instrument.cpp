#include "devices/instruments/profile_instrument.h"

#include "devices/instruments/field_instruments.h"
#include "devices/instruments/line_stream.h"
#include "devices/instruments/scpi_replies.h"

#include <algorithm>
#include <optional>

namespace straightedge::devices {

namespace {

using Role = InstrumentRole;

/// Values of one reading, or that the instrument says it has none.
struct Answer {
  std::vector<double> values;
  double timeS = 0.0;
  bool noReading = false;
};

class ProfileInstrument;

/// The interfaces have members of the same name: each role is an object of its own that knows the instrument.
class SensorRole : public AngleSensor {
public:
  explicit SensorRole(ProfileInstrument& owner) : m_owner(owner) {}
  InstrumentIdentity identity() const override;
  Result<TimedReading> readDeg() override;

private:
  ProfileInstrument& m_owner;
};

class ReferenceRole : public AngleReference {
public:
  explicit ReferenceRole(ProfileInstrument& owner) : m_owner(owner) {}
  InstrumentIdentity identity() const override;
  Result<TimedReading> readDeg() override;
  std::optional<double> incrementDeg() const override;
  void restart() { m_unwrap.restart(); }
  AngleUnwrap* unwrap() { return &m_unwrap; }

private:
  ProfileInstrument& m_owner;
  AngleUnwrap m_unwrap;
};

class ProbeRole : public FieldProbe {
public:
  explicit ProbeRole(ProfileInstrument& owner) : m_owner(owner) {}
  InstrumentIdentity identity() const override;
  Result<FieldReading> readT() override;

private:
  ProfileInstrument& m_owner;
};

class FieldReferenceRole : public FieldReference {
public:
  explicit FieldReferenceRole(ProfileInstrument& owner) : m_owner(owner) {}
  InstrumentIdentity identity() const override;
  Result<FieldReferenceReading> readT() override;
  bool knowsSign() const override { return true; }

private:
  ProfileInstrument& m_owner;
};

class ResistanceRole : public ResistanceMeter {
public:
  explicit ResistanceRole(ProfileInstrument& owner) : m_owner(owner) {}
  InstrumentIdentity identity() const override;
  Result<TimedReading> readOhm() override;

private:
  ProfileInstrument& m_owner;
};

class ThermometerRole : public Thermometer {
public:
  explicit ThermometerRole(ProfileInstrument& owner) : m_owner(owner) {}
  Result<TimedReading> readC() override;

private:
  ProfileInstrument& m_owner;
};

class ProfileInstrument : public Instrument {
public:
  ProfileInstrument(Transport& transport, BenchClock& clock, const Profile& profile);

  Result<void> prepare() override;
  InstrumentIdentity identity() const override { return m_identity; }
  std::optional<TransportFault> lastFault() const override { return m_talk.lastFault(); }
  AngleSensor* angleSensor() override { return has(Role::AngleSensor) ? &m_sensor : nullptr; }
  AngleReference* angleReference() override { return has(Role::AngleReference) ? &m_reference : nullptr; }
  ReadingStream* angleReadings(Role role) override;
  AngleStream* angleStream() override { return m_bothAngles ? &*m_bothAngles : nullptr; }
  FieldProbe* fieldProbe() override { return has(Role::FieldProbe) ? &m_probe : nullptr; }
  FieldReference* fieldReference() override { return has(Role::FieldReference) ? &m_fieldReference : nullptr; }
  ResistanceMeter* resistanceMeter() override { return has(Role::Resistance) ? &m_resistance : nullptr; }
  Thermometer* thermometer() override { return has(Role::Temperature) ? &m_thermometer : nullptr; }

  Result<Answer> answer(Role role);
  bool keepsZero() const {
    return std::ranges::any_of(m_profile.readings, [](const ProfileReading& reading) {
      return reading.role == Role::AngleReference && reading.keepsZero;
    });
  }
  /// One value; no reading is an error.
  Result<TimedReading> value(Role role);

private:
  /// A role's reading, and its lines where the instrument prints by itself.
  struct Reading {
    ProfileReading profile;
    std::optional<LineSource> lines;
    std::optional<LineReadings> stream = {}; ///< of an angle's lines
  };
  Reading* find(Role role) {
    const auto found = std::ranges::find(m_readings, role, [](const Reading& reading) { return reading.profile.role; });
    return found == m_readings.end() ? nullptr : &*found;
  }
  bool has(Role role) { return find(role) != nullptr; }
  void makeStreams();
  Result<void> sendAll(const std::vector<std::string>& commands);
  Result<Answer> ask(const ProfileReading& reading);

  BenchClock& m_clock;
  Profile m_profile;
  Conversation m_talk;
  std::vector<Reading> m_readings;
  InstrumentIdentity m_identity;
  std::optional<Role> m_setUpFor; ///< the role whose set-up was sent last
  bool m_streaming = false;
  SensorRole m_sensor{*this};
  ReferenceRole m_reference{*this};
  ProbeRole m_probe{*this};
  FieldReferenceRole m_fieldReference{*this};
  ResistanceRole m_resistance{*this};
  ThermometerRole m_thermometer{*this};
  std::optional<LineSource> m_bothLines; ///< where sensor and reference stand in the same lines
  std::optional<LineAngles> m_bothAngles;
};

ProfileInstrument::ProfileInstrument(Transport& transport, BenchClock& clock, const Profile& profile)
    : m_clock(clock), m_profile(profile),
      m_talk(transport, clock,
             {.commandEnd = profile.commandEnd, .replyEnd = profile.replyEnd, .deadline = profile.deadline}),
      m_identity{.model = profile.name, .serial = {}, .firmware = {}} {
  for (const ProfileReading& reading : profile.readings) {
    m_readings.push_back({reading, reading.command.empty() ? std::optional(LineSource(reading.format, reading.latencyS))
                                                           : std::nullopt});
  }
  makeStreams();
}

/// Two readings whose lines are the same but for their columns.
bool areOneLine(const ProfileReading& one, const ProfileReading& other) {
  return one.command.empty() && other.command.empty() && !one.regex && !other.regex &&
         one.format.separators == other.format.separators && one.format.decimalPoint == other.format.decimalPoint &&
         one.format.prefix == other.format.prefix && one.format.fieldCount == other.format.fieldCount &&
         one.latencyS == other.latencyS;
}

void ProfileInstrument::makeStreams() {
  for (Reading& reading : m_readings) {
    const bool reference = reading.profile.role == Role::AngleReference;
    if (reading.lines && (reference || reading.profile.role == Role::AngleSensor)) {
      reading.stream.emplace(StreamedLines{&m_talk, &*reading.lines, &m_streaming}, 0U,
                             reference ? m_reference.unwrap() : nullptr);
    }
  }
  const Reading* sensor = find(Role::AngleSensor);
  const Reading* reference = find(Role::AngleReference);
  if (sensor != nullptr && reference != nullptr && areOneLine(sensor->profile, reference->profile)) {
    LineFormat both = sensor->profile.format;
    both.columns = {reference->profile.format.columns.front(), sensor->profile.format.columns.front()};
    m_bothLines.emplace(std::move(both), sensor->profile.latencyS);
    m_bothAngles.emplace(StreamedLines{&m_talk, &*m_bothLines, &m_streaming}, 0U, 1U, m_reference.unwrap());
  }
}

Result<void> ProfileInstrument::sendAll(const std::vector<std::string>& commands) {
  for (const std::string& command : commands) {
    if (auto sent = m_talk.send(command); !sent) {
      return sent;
    }
    m_clock.sleepS(m_profile.pauseS);
  }
  return {};
}

Result<void> ProfileInstrument::prepare() {
  m_streaming = false;
  m_setUpFor.reset();
  m_reference.restart();
  if (auto cleared = m_talk.clear(); !cleared) {
    return cleared;
  }
  if (!m_profile.identityCommand.empty()) {
    const auto reply = m_talk.ask(m_profile.identityCommand);
    if (!reply) {
      return std::unexpected(reply.error());
    }
    if (!identifies(m_profile, reply->text)) {
      return m_talk.misunderstood(m_profile.identityCommand, reply->text,
                                  "one with '" + m_profile.identityParts.front() + "' in it");
    }
    m_identity = parseIdentity(reply->text).value_or(InstrumentIdentity{reply->text, {}, {}});
  }
  if (auto sent = sendAll(m_profile.setUp); !sent) {
    return sent;
  }
  if (!m_profile.errorQuery.empty()) {
    if (auto checked = checkErrorQueue(m_talk, m_profile.errorQuery, "while it was set up"); !checked) {
      return checked;
    }
  }
  // An instrument that prints by itself proves so now: a wrong baud rate shows at once.
  if (!m_readings.empty() && m_readings.front().lines) {
    const auto first = m_readings.front().lines->fresh(m_talk, m_readings.front().profile.deadline);
    return first ? Result<void>{} : std::unexpected(first.error());
  }
  return {};
}

Result<Answer> ProfileInstrument::ask(const ProfileReading& reading) {
  if (m_setUpFor != reading.role && !reading.setUp.empty()) {
    m_setUpFor.reset();
    if (auto sent = sendAll(reading.setUp); !sent) {
      return std::unexpected(std::move(sent.error()));
    }
  }
  m_setUpFor = reading.role;
  const auto reply = m_talk.ask(reading.command, reading.deadline);
  if (!reply) {
    m_setUpFor.reset(); // it may have been switched off and on
    return std::unexpected(reply.error());
  }
  const bool none =
      std::ranges::any_of(reading.noReading, [&](const std::string& text) { return reply->text.contains(text); });
  if (none) {
    return Answer{.values = {}, .timeS = reply->timeS - reading.latencyS, .noReading = true};
  }
  auto values = parseReading(reading, reply->text);
  if (!values) {
    return m_talk.misunderstood(reading.command, reply->text, "a reading (" + values.error() + ")");
  }
  return Answer{.values = *std::move(values), .timeS = reply->timeS - reading.latencyS, .noReading = false};
}

Result<Answer> ProfileInstrument::answer(Role role) {
  Reading* reading = find(role);
  if (reading == nullptr) {
    return m_talk.refused("the profile has no reading for this role", "choose another role");
  }
  if (m_streaming) {
    return m_talk.refused("the instrument is streaming", "stop the stream before asking for single readings");
  }
  if (!reading->lines) {
    return ask(reading->profile);
  }
  auto fresh = reading->lines->fresh(m_talk, reading->profile.deadline);
  if (!fresh) {
    return std::unexpected(std::move(fresh.error()));
  }
  return Answer{.values = std::move(fresh->values), .timeS = fresh->timeS, .noReading = false};
}

Result<TimedReading> ProfileInstrument::value(Role role) {
  const auto got = answer(role);
  if (!got) {
    return std::unexpected(got.error());
  }
  if (got->noReading) {
    return m_talk.refused("the instrument says that it has no reading", "check its input and its range");
  }
  return TimedReading{got->values.front(), got->timeS};
}

ReadingStream* ProfileInstrument::angleReadings(Role role) {
  Reading* reading = find(role);
  return reading != nullptr && reading->stream ? &*reading->stream : nullptr;
}

InstrumentIdentity SensorRole::identity() const { return m_owner.identity(); }
InstrumentIdentity ReferenceRole::identity() const { return m_owner.identity(); }
InstrumentIdentity ProbeRole::identity() const { return m_owner.identity(); }
InstrumentIdentity FieldReferenceRole::identity() const { return m_owner.identity(); }
InstrumentIdentity ResistanceRole::identity() const { return m_owner.identity(); }

std::optional<double> ReferenceRole::incrementDeg() const {
  return m_owner.keepsZero() ? std::nullopt : std::optional(0.0);
}

Result<TimedReading> SensorRole::readDeg() {
  auto reading = m_owner.value(Role::AngleSensor);
  if (reading) {
    reading->value = wrapTurn(reading->value);
  }
  return reading;
}

Result<TimedReading> ReferenceRole::readDeg() {
  auto reading = m_owner.value(Role::AngleReference);
  if (reading) {
    reading->value = m_unwrap.follow(reading->value);
  }
  return reading;
}

Result<FieldReading> ProbeRole::readT() {
  const auto got = m_owner.answer(Role::FieldProbe);
  if (!got) {
    return std::unexpected(got.error());
  }
  FieldReading reading{.timeS = got->timeS, .overRange = got->noReading, .electronicsC = {}};
  if (!got->noReading) {
    std::ranges::copy_n(got->values.begin(), 3, reading.rawT.begin());
  }
  return reading;
}

Result<FieldReferenceReading> FieldReferenceRole::readT() {
  const auto got = m_owner.answer(Role::FieldReference);
  if (!got) {
    return std::unexpected(got.error());
  }
  return FieldReferenceReading{.fieldT = got->noReading ? std::nullopt : std::optional(got->values.front()),
                               .locked = !got->noReading,
                               .timeS = got->timeS};
}

Result<TimedReading> ResistanceRole::readOhm() { return m_owner.value(Role::Resistance); }

Result<TimedReading> ThermometerRole::readC() { return m_owner.value(Role::Temperature); }

} // namespace

std::unique_ptr<Instrument> makeProfileInstrument(Transport& transport, BenchClock& clock, const Profile& profile) {
  return std::make_unique<ProfileInstrument>(transport, clock, profile);
}

std::vector<InstrumentRole> rolesOf(const Profile& profile) {
  std::vector<InstrumentRole> roles;
  std::ranges::transform(profile.readings, std::back_inserter(roles), &ProfileReading::role);
  return roles;
}

bool identifies(const Profile& profile, std::string_view reply) {
  return std::ranges::any_of(profile.identityParts, [&](const std::string& part) { return reply.contains(part); });
}

} // namespace straightedge::devices
