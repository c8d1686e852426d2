// What every processor of this kind has: two numbers at a time on x86-64 and ARM.
#include "core/field/chain_loop.h"

namespace straightedge::field {

void correctColumnsBaseline(const ChainCoefficients& coefficients, const ChainColumns& columns) {
  correctColumns<Lanes<16>>(coefficients, columns);
}

} // namespace straightedge::field
