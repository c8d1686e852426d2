// The profiles there are: those that are shipped, built into the program, and those in the user's own folder.
#pragma once

#include "devices/instruments/profile.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

struct ProfileSet {
  std::vector<Profile> profiles; ///< in order of their ids, each id once
  std::vector<Error> problems;   ///< of files that could not be used; the others work all the same
};

struct ShippedProfile {
  std::string_view file; ///< "scpi_multimeter_pt100.json"
  std::string_view text;
};

/// resources/instruments/*.json as they were when the program was built: no installed file to be missed.
std::span<const ShippedProfile> shippedProfileTexts();

/// The shipped profiles together with *.json in `userFolder` ("": none). The user's wins where both have the same id. A
/// folder that is not there is no problem; files that cannot be read, or are no profile, are. Any thread.
ProfileSet readProfiles(const std::string& userFolder);

/// $XDG_DATA_HOME/straightedge/instruments, or its default below $HOME; "" where neither is set.
std::string userProfileFolder();

/// By id; null if there is none.
const Profile* findProfile(const ProfileSet& set, std::string_view id);

} // namespace straightedge::devices
