#include "core/angle/harmonic_model.h"

#include "core/angle/trigonometry_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace straightedge::angle {

namespace {

constexpr double radPerDeg = std::numbers::pi / 180.0;
constexpr std::size_t blockSize = 64;

/// Grid of 4096 or 4096·2^n angles: cos(k·(p + q)) by one rotation per block of 64 neighbours, so that the inner loop
/// is two multiplications and two additions on contiguous numbers.
void addInBlocks(const HarmonicTerm& term, double* out, std::size_t count) {
  const auto order = static_cast<std::size_t>(term.order);
  const TrigonometryTable& table = TrigonometryTable::instance();
  const std::size_t finer = count / static_cast<std::size_t>(gridSize);
  std::array<double, blockSize> cosine{};
  std::array<double, blockSize> sine{};
  const std::complex<double> start = std::polar(term.amplitudeDeg, term.phaseRad);
  for (std::size_t q = 0; q < blockSize; ++q) {
    std::complex<double> value = start;
    if (finer == 1) {
      value *= table.unit(order * q);
    } else {
      value *= std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>((order * q) % count) /
                                   static_cast<double>(count));
    }
    cosine[q] = value.real();
    sine[q] = value.imag();
  }
  for (std::size_t block = 0; block < count; block += blockSize) {
    // 64 fine steps are a whole number of grid steps only up to 64 times finer: block/finer would not be whole beyond.
    const std::complex<double> turn =
        finer <= blockSize ? table.unit(order * (block / finer))
                           : std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>((order * block) % count) /
                                                 static_cast<double>(count));
    const double c = turn.real();
    const double s = turn.imag();
    double* const target = out + block;
    for (std::size_t q = 0; q < blockSize; ++q) {
      target[q] += c * cosine[q] - s * sine[q];
    }
  }
}

} // namespace

HarmonicModel harmonicModelOf(const HarmonicSpectrum& spectrum, std::span<const int> orders) {
  HarmonicModel model;
  model.offsetDeg = spectrum.coefficient[0].real();
  model.terms.reserve(orders.size());
  for (const int order : orders) {
    const std::complex<double> value = spectrum.coefficient[static_cast<std::size_t>(order)];
    model.terms.push_back({order, 2.0 * std::abs(value), std::arg(value)});
  }
  return model;
}

void addHarmonic(const HarmonicTerm& term, double* out, int count) {
  if (count % gridSize == 0 && (count & (count - 1)) == 0) {
    addInBlocks(term, out, static_cast<std::size_t>(count));
    return;
  }
  for (int i = 0; i < count; ++i) {
    const auto step = (static_cast<long long>(i) * term.order) % count;
    out[i] += term.amplitudeDeg *
              std::cos(2.0 * std::numbers::pi * static_cast<double>(step) / static_cast<double>(count) + term.phaseRad);
  }
}

void evaluateHarmonics(const HarmonicModel& model, double* out, int count) {
  std::fill(out, out + count, model.offsetDeg);
  for (const HarmonicTerm& term : model.terms) {
    addHarmonic(term, out, count);
  }
}

double harmonicAt(const HarmonicModel& model, double readingDeg) {
  double sum = model.offsetDeg;
  for (const HarmonicTerm& term : model.terms) {
    sum += term.amplitudeDeg * std::cos(term.order * (readingDeg * radPerDeg) + term.phaseRad);
  }
  return sum;
}

} // namespace straightedge::angle
