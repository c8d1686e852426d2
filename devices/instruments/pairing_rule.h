// How readings of two instruments that answer one after the other become one pair.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace straightedge::devices {

enum class PairingKind : std::uint8_t {
  AsRead,      ///< one after the other, as they come: for a shaft that stands still
  Interpolate, ///< the sensor's value at the time of the reference's reading, on a line between two readings around it
};

struct PairingRule {
  PairingKind kind = PairingKind::AsRead;
  double maxAgeS = 0.1; ///< Interpolate: a sensor reading farther than this from the reference's makes no pair

  friend bool operator==(const PairingRule&, const PairingRule&) = default;
};

/// "as-read", "interpolate": in plans, saved benches and on the command line.
inline std::string_view pairingWord(PairingKind kind) {
  return kind == PairingKind::Interpolate ? "interpolate" : "as-read";
}
inline std::optional<PairingKind> pairingFromWord(std::string_view word) {
  return word == "interpolate" ? std::optional(PairingKind::Interpolate)
         : word == "as-read"   ? std::optional(PairingKind::AsRead)
                               : std::nullopt;
}

} // namespace straightedge::devices
