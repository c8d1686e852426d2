// Names of models as the command line, the files and the window spell them: KIND:SIZE[@METHOD][/BITS].
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::angle {

enum class ModelKind : std::uint8_t { Harmonic, Linear, LookupTable };
enum class FitMethod : std::uint8_t {
  ByAmplitude,
  Ordered, // harmonic
  LeastSquares,
  OnCurve,
  Minimax, // linear
  Mean,
  MidRange // lookup table
};

struct ModelName {
  ModelKind kind = ModelKind::Harmonic;
  int size = 4; ///< harmonics, segments or entries
  FitMethod method = FitMethod::ByAmplitude;
  std::optional<int> bits; ///< 8 to 16: stored as integers; without: float, 4 bytes an entry

  bool operator==(const ModelName&) const = default;
  int storageEntries() const { return kind == ModelKind::Harmonic ? 2 * size + 1 : size; }
  int storageBytes() const;     ///< entries times 4, or times bits/8 rounded up to whole bytes in all
  std::string text() const;     ///< canonical: the default method is left out
  std::string fileStem() const; ///< e.g. "linear-32", "linear-32-minimax-12bit"
};

/// Errors (kind Usage) name the wrong part and what is allowed.
Result<ModelName> parseModelName(std::string_view text);

/// harmonic:4, linear:32, lut:64
std::vector<ModelName> defaultModels();

const char* kindText(ModelKind kind); ///< "harmonic", "linear", "lut"
const char*
methodText(FitMethod method); ///< "amplitude", "ordered", "least-squares", "on-curve", "minimax", "mean", "midrange"
FitMethod defaultMethod(ModelKind kind);

} // namespace straightedge::angle
