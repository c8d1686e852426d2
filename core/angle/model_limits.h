// What sizes, methods and widths a model may have.
#pragma once

#include "core/angle/model_name.h"
#include "core/base/error.h"

namespace straightedge::angle {

struct SizeRange {
  int smallest = 0;
  int largest = 0;
};

inline constexpr int smallestBits = 8;
inline constexpr int largestBits = 16;

/// Harmonics 0 to 64; segments and entries 2 to 1024.
constexpr SizeRange sizeRange(ModelKind kind) {
  return kind == ModelKind::Harmonic ? SizeRange{0, 64} : SizeRange{2, 1024};
}

bool methodBelongsTo(FitMethod method, ModelKind kind);

/// `name` itself when kind, method, size and bits fit together. Errors: Usage, naming the wrong part.
Result<ModelName> checkedModelName(const ModelName& name);

} // namespace straightedge::angle
