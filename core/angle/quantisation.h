// Models stored as signed integers of 8 to 16 bits.
#pragma once

#include "core/angle/model.h"

#include <utility>

namespace straightedge::angle {

using ModelBody = std::variant<HarmonicModel, LinearModel, LookupTableModel>;

/// Integers for a model, and the model that these integers stand for.
/// Values: bias = (largest + smallest)/2, so that the integers use their range to both sides; lsb = half the range
/// divided by the largest integer, the smallest step with which both extremes are met. All values equal: lsb 0.
/// Harmonics: the bias is the offset; amplitude = lsb·integer, lsb likewise from the largest amplitude; phases in
/// fractions of a turn, phaseLsb = 2π/2^bits, so that firmware may let them overflow (integer −2^(bits−1) is −π).
std::pair<StoredIntegers, ModelBody> quantised(const ModelBody& body, int bits);

/// The model that stored integers stand for. `body` gives its kind and the harmonics' orders.
ModelBody bodyOf(const StoredIntegers& stored, const ModelBody& body);

} // namespace straightedge::angle
