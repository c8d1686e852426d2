// Drives an instrument as its profile says.
#pragma once

#include "devices/instruments/angle_unwrap.h"
#include "devices/instruments/conversation.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/line_source.h"
#include "devices/instruments/profile.h"

#include <memory>
#include <vector>

namespace straightedge::devices {

/// A reading that a profile calls none ("no_reading") is: for a field reference one that is not locked, for a field
/// probe one beyond its range, for the others an error. Angles of a sensor are wrapped, those of a reference followed
/// over turns.
std::unique_ptr<Instrument> makeProfileInstrument(Transport& transport, BenchClock& clock, const Profile& profile);

/// The roles that the profile fills.
std::vector<InstrumentRole> rolesOf(const Profile& profile);

/// Whether the reply to the profile's identification is this instrument's.
bool identifies(const Profile& profile, std::string_view reply);

} // namespace straightedge::devices
