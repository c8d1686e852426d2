// The one reply in which a Metrolab THM1176 gives field, time, temperature and status.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace straightedge::devices {

struct Thm1176Reply {
  std::array<double, 3> fieldT = {0.0, 0.0, 0.0};
  bool overload = false;        ///< an axis gave SCPI's 9.9e37
  std::uint64_t stampNs = 0;    ///< the instrument's own clock
  std::int64_t temperature = 0; ///< counts, not degrees
  int status = 0;               ///< IEEE 488.2; bit 2: the error queue is not empty
};

/// "0.012345 T;-0.5 T;1.2 T;0x0000000012345678;23456;0" for one measurement. Units T and mT (as the instrument writes
/// them: "T", "MT") are understood, others refused. Nothing where the text is no such reply. Source:
/// Hyperfine/pyTHM1176 thm_usbtmc_api.py. Not yet tried on hardware.
std::optional<Thm1176Reply> parseThm1176Reply(std::string_view text);

} // namespace straightedge::devices
