// A chain with every block on, of the size that the teslameter of the paper has.
#pragma once

#include "core/field/chain.h"

#include <vector>

namespace straightedge::testing {

field::CorrectionChain sampleChain();

/// Readings of random fields within full scale at random temperatures between 10 and 40 °C.
struct SampleReadings {
  std::vector<double> pt100Ohm, electronicsC, x, y, z;

  field::ReadingColumns columns() const { return {pt100Ohm, electronicsC, {x, y, z}}; }
};
SampleReadings sampleReadings(std::size_t count, unsigned seed = 1);

} // namespace straightedge::testing
