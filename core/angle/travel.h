// How the shaft travelled while a sweep was recorded: which turn and which direction every row belongs to.
#pragma once

#include "core/angle/sweep.h"

#include <cstddef>
#include <vector>

namespace straightedge::angle {

struct Travel {
  std::vector<int> turn; ///< per row of `rows`, from 0
  std::vector<int> pass; ///< +1 encoder rising, −1 falling
  int turns = 1;
  bool bothDirections = false;
};

/// Recorded columns count; what is missing is recovered from the order of the rows: the shaft is taken to have turned
/// back only where it went back by 45° or more, and rows that seem to turn back every few rows are taken as shuffled
/// (then one rising pass).
Travel recoverTravel(const Sweep& sweep, const std::vector<std::size_t>& rows);

} // namespace straightedge::angle
