// Replies of a Metrolab PT2025 NMR teslameter.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace straightedge::devices {

enum class NmrState : std::uint8_t {
  Locked,   ///< "L": the only readings that count
  Signal,   ///< "S": a signal is seen
  NoSignal, ///< "N"
  Wrong,    ///< "W": to be ignored
};

struct Pt2025Reading {
  NmrState state = NmrState::Wrong;
  double value = 0.0;
  bool tesla = true; ///< otherwise MHz
};

/// "L1.0536470T", "N44.914011F"; blanks and line end around it do not count. Nothing where the text is no such reading.
/// Source: a real session in "Rascunho NMR.txt" of lnls-ima and LucasIB.
std::optional<Pt2025Reading> parsePt2025Reading(std::string_view text);

/// "S03": the bits of a status register. Nothing where the text is a reading or anything else.
std::optional<unsigned> parsePt2025Status(std::string_view text);

} // namespace straightedge::devices
