// Doubles as their shortest decimal text, quickly, for numbers of everyday size. Everything else is for formatDouble(),
// which begins with this.
#pragma once

namespace straightedge {

/// Writes what std::to_chars(out, …, value) writes and gives the end; room as for formatDouble(). nullptr, then only
/// the room is touched: whole numbers, powers of two, nan and infinities, and what is not between 1e-22 and 1e14 in
/// size.
char* formatEveryday(double value, char* out);

} // namespace straightedge
