// Built with -mavx2 -mfma whatever the rest is built for; called only where the processor has them.
#include "core/field/chain_loop.h"

namespace straightedge::field {

void correctColumnsAvx2(const ChainCoefficients& coefficients, const ChainColumns& columns) {
  correctColumns<Lanes<32>>(coefficients, columns);
}

} // namespace straightedge::field
