// The numbers of a correction chain as its loops want them. Plain memory and no functions: also included where code is
// built for newer processors, whose inline functions must not reach the rest of the program.
#pragma once

#include <cstddef>

namespace straightedge::field {

inline constexpr std::size_t mostChainCoefficients = 16;

/// Ascending powers. Its count is at least 1.
struct ChainPolynomial {
  double values[mostChainCoefficients] = {};
  std::size_t count = 1;
};

struct AxisCoefficients {
  ChainPolynomial nonlinearity;
  ChainPolynomial slope;
  ChainPolynomial intercept;
  double offset0 = 0.0;
  double offset1 = 0.0;
  double electronics0 = 0.0;
  double electronics1 = 0.0;
  double sensitivity0 = 0.0; ///< of the electronics
  double sensitivity1 = 0.0;
};

struct ChainCoefficients {
  double pt100Slope = 0.0;
  double pt100Intercept = 0.0;
  double referenceC = 0.0;
  AxisCoefficients axes[3];
  double inverse[3][3] = {}; ///< S⁻¹
};

/// Columns of readings for the loops; lengths are multiples of chainStep.
struct ChainColumns {
  const double* pt100Ohm = nullptr;
  const double* electronicsC = nullptr;
  const double* rawT[3] = {};
  double* fieldT[3] = {};
  std::size_t count = 0;
};

/// Readings corrected together by the widest loop.
inline constexpr std::size_t chainStep = 16;

void correctColumnsBaseline(const ChainCoefficients& coefficients, const ChainColumns& columns);
#ifdef STRAIGHTEDGE_AVX2
/// Only where the processor has AVX2 and FMA.
void correctColumnsAvx2(const ChainCoefficients& coefficients, const ChainColumns& columns);
#endif

} // namespace straightedge::field
