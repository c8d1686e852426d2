// The first 64 harmonics of a curve on the 4096 grid.
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <vector>

namespace straightedge::angle {

inline constexpr int largestHarmonic = 64;

/// Coefficient k is (1/4096)·Σ c[i]·exp(−j·2π·k·i/4096): the mean for k = 0, half the amplitude with its phase beyond.
struct HarmonicSpectrum {
  std::array<std::complex<double>, largestHarmonic + 1> coefficient;

  /// Orders 1 to `limit`, largest amplitude first; equal amplitudes in ascending order.
  std::vector<int> ordersByAmplitude(int limit) const;
};

/// `gridDeg` has 4096 entries; coefficients above `limit` are left zero. A transform pruned to the outputs that are
/// wanted: 32 interleaved transforms of 128 samples side by side, joined by twiddle factors.
HarmonicSpectrum spectrumOf(const Eigen::VectorXd& gridDeg, int limit = largestHarmonic);

} // namespace straightedge::angle
