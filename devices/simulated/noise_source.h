// Normally distributed noise that repeats with its seed on every machine.
#pragma once

#include <cstdint>
#include <random>

namespace straightedge::devices {

/// Marsaglia's polar method over mt19937_64: unlike std::normal_distribution the sequence is the same in every library.
class NoiseSource {
public:
  explicit NoiseSource(std::uint64_t seed) : m_generator(seed) {}

  double standardNormal(); ///< mean 0, standard deviation 1

private:
  double uniform(); ///< in (−1, 1)

  std::mt19937_64 m_generator;
  double m_spare = 0.0;
  bool m_hasSpare = false;
};

} // namespace straightedge::devices
