// A bench as a file: which instruments fill its roles, by serial number and not by port, and how they are set.
//
//   { "format": "straightedge-bench", "version": 1, "name": "desk",
//     "pairing": { "rule": "interpolate", "max_age_s": 0.05 },
//     "instruments": [
//       { "instrument": "usdigital-qsb", "roles": ["angle-reference"], "serial": "FT1A2B3C",
//         "settings": { "counts_per_turn": "10000" }, "latency_s": 0.001 },
//       { "instrument": "ascii-board", "roles": ["angle-sensor", "temperature"], "serial": "ACM-1",
//         "settings": { "temperature_column": "2" }, "baud": 115200 } ] }
//
// "instrument" is an id of the instrument table or of a profile; "serial" is that of the USB device, as
// `straightedge-cli devices` prints it; "port" ("/dev/ttyS0", "/dev/serial/by-id/…") stands in its place where there is
// none. "pairing", "settings", "latency_s" and "baud" may be left out.
#pragma once

#include "core/base/error.h"
#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/instruments/pairing_rule.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::devices {

struct BenchInstrument {
  std::string instrument; ///< id
  std::vector<InstrumentRole> roles;
  std::string serial; ///< of the USB device
  std::string port;   ///< path of a serial port; only where there is no serial number
  SettingValues settings;
  double latencyS = 0.0;   ///< from measuring to the time stamp of the reading, beside what the driver knows itself
  std::optional<int> baud; ///< other than the instrument is delivered with

  friend bool operator==(const BenchInstrument&, const BenchInstrument&) = default;
};

struct SavedBench {
  std::string name;
  std::vector<BenchInstrument> instruments; ///< each role once
  PairingRule pairing = {};

  /// Null where nothing fills the role.
  const BenchInstrument* filling(InstrumentRole role) const;
  friend bool operator==(const SavedBench&, const SavedBench&) = default;
};

/// `file` is the text's name in messages. Errors (Input): FILE:LINE, what is wrong. Any thread, all of them.
Result<SavedBench> benchFromJson(std::string_view text, const std::string& file);
std::string benchToJson(const SavedBench& bench);

/// $XDG_CONFIG_HOME/straightedge/benches, or its default below $HOME; "" where neither is set.
std::string userBenchFolder();

/// The file that `name` means: a path where it has a '/' or ends with ".json", else NAME.json in the user's folder.
std::string benchFile(const std::string& name);

/// Errors: Instrument (there is no such bench), Input (it cannot be read).
Result<SavedBench> readBench(const std::string& name);

/// Writes it whole into the user's folder, under its name; returns the file. Errors (Storage).
Result<std::string> saveBench(const SavedBench& bench);

} // namespace straightedge::devices
