// Instruments that are added by a file, without C++: what a profile says, and reading it. The format is described in
// resources/instruments/instrument.schema.json, and by the profiles there.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_table.h"
#include "devices/instruments/line_parser.h"

#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

/// What is sent and how the reply becomes numbers, for one role.
struct ProfileReading {
  InstrumentRole role = InstrumentRole::AngleSensor;
  std::string command;            ///< empty: the instrument prints lines by itself
  std::vector<std::string> setUp; ///< sent before the first reading, and again after a reading of another role
  Milliseconds deadline{2000};
  double latencyS = 0.0;
  bool keepsZero = false; ///< an angle reference that knows its angle also after it was without power
  LineFormat format;      ///< columns in the role's unit: degrees, tesla, ohms, °C; three of them for a field probe
  std::shared_ptr<const std::regex>
      regex;                          ///< may be null. Its groups are the columns, in place of separators and labels
  std::vector<std::string> noReading; ///< replies that contain one of these say that there is no reading
};

struct Profile {
  std::string id;   ///< the file's name without folder and ending
  std::string file; ///< where it was read from, for messages
  std::string name; ///< for people
  bool notYetTried = true;
  std::string unconfirmed;
  std::vector<Connection> connections;
  std::vector<UsbIds> usb;
  std::optional<SerialSettings> serial;
  std::string commandEnd = "\n";
  std::string replyEnd = "\n";
  Milliseconds deadline{1000};            ///< for commands and the identification
  double pauseS = 0.0;                    ///< after every command that is not answered
  std::string identityCommand;            ///< empty: it cannot be asked
  std::vector<std::string> identityParts; ///< one of them must be in the reply
  std::vector<std::string> setUp;
  std::string errorQuery;               ///< of a SCPI error queue, asked after the set-up; empty: none
  std::vector<ProfileReading> readings; ///< one a role
};

/// The profile in `text`, which stands in `file`. Errors (Input): FILE:LINE, what is wrong, and what would be right.
/// Any thread.
Result<Profile> parseProfile(std::string_view text, const std::string& file);

/// What one reply or line says. Errors in words: what is wrong with it.
std::expected<std::vector<double>, std::string> parseReading(const ProfileReading& reading, std::string_view reply);

/// All keys that a profile may have, by the object they stand in ("profile", "reading", "column", …): the schema has
/// the same.
struct ProfileKeys {
  std::string_view object;
  std::vector<std::string_view> keys;
};
const std::vector<ProfileKeys>& profileKeys();

} // namespace straightedge::devices
