// What a chain of fewer coefficients costs in accuracy: orders of the blocks against what they leave, as the paper
// compares them (Electronics 2020, 9, 151, Tables 1, 2 and 4).
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/field/field_fit.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace straightedge::field {

/// Coefficients to store and multiplications for one reading of three axes, by the chain's formula and Horner's rule;
/// coefficients that are 0 are neither stored nor multiplied with, temperatures are converted once.
struct ChainSize {
  std::size_t coefficients = 0;
  std::size_t multiplications = 0;
};
ChainSize sizeOf(const CorrectionChain& chain);

struct StorageChoice {
  std::string name;             ///< "order 5, slope 3", "without electronics sensitivity"
  int order = 0;                ///< of the nonlinearity
  int slopeOrder = 0;           ///< of the sensitivity's slope; 0 where that block is off
  std::optional<Block> without; ///< the block left out, if it is about one
  CorrectionChain chain;
  ChainSize size;
  std::array<double, 3> peakPercent = {0.0, 0.0, 0.0}; ///< by axis, of full scale, over the rows measured with
  std::array<double, 3> rmsPercent = {0.0, 0.0, 0.0};
  double largestPeakPercent = 0.0;
  bool isBest = false; ///< no other choice leaves as small a peak with as few coefficients
};

struct StorageComparison {
  std::vector<StorageChoice> choices; ///< orders 1 to 7 by slope orders 1 to 3, then each block left out
  std::string measuredWith;           ///< "verification", or "plateaus" where there is no verification
};

/// Each choice is fitted anew with all its blocks together (joint_fit.h), from the chain of `run`: what its
/// coefficients can leave, whatever the way to them. Measured over the verification (the axes' own chains, as in Table
/// 3), or the nonlinearity's plateaus where there is none. Choices that the data do not determine are left out. Errors:
/// Cancelled.
Result<StorageComparison> compareStorage(const FieldRun& run, const JobControl& job = {});

} // namespace straightedge::field
