#include "core/angle/harmonic_spectrum.h"

#include "core/angle/curve.h"
#include "core/angle/trigonometry_table.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <numeric>

namespace straightedge::angle {

namespace {

constexpr std::size_t grid = gridSize;
constexpr std::size_t columns = 32;          // interleaved transforms
constexpr std::size_t rows = grid / columns; // samples of each: 128, just enough for harmonics 0 to 64

using Row = Eigen::Array<double, columns, 1>; // one sample of every interleaved transform
struct ComplexRow {
  Row re, im;
};

struct Workspace {
  std::array<Row, rows / 2> sum;
  std::array<Row, rows / 2> difference;
  std::array<ComplexRow, rows / 4> odd;
  std::array<ComplexRow, rows / 2 + 1> output; // harmonics 0 to 64 of every interleaved transform
};

void rotate(ComplexRow& value, std::complex<double> by) {
  const Row re = value.re * by.real() - value.im * by.imag();
  value.im = value.re * by.imag() + value.im * by.real();
  value.re = re;
}

/// Decimation in frequency, in place: output q is found at the bit-reversed place.
void transform(std::array<ComplexRow, rows / 4>& z, std::size_t length, const TrigonometryTable& table) {
  for (std::size_t span = length; span > 1; span /= 2) {
    const std::size_t half = span / 2;
    for (std::size_t block = 0; block < length; block += span) {
      for (std::size_t j = 0; j < half; ++j) {
        ComplexRow& upper = z[block + j];
        ComplexRow& lower = z[block + j + half];
        const ComplexRow difference{upper.re - lower.re, upper.im - lower.im};
        upper.re += lower.re;
        upper.im += lower.im;
        lower = difference;
        if (j != 0) {
          rotate(lower, std::conj(table.unit(j * (grid / span))));
        }
      }
    }
  }
}

std::size_t bitReversed(std::size_t value, std::size_t length) {
  std::size_t reversed = 0;
  for (std::size_t bit = 1; bit < length; bit *= 2) {
    reversed = reversed * 2 + ((value & bit) != 0 ? 1 : 0);
  }
  return reversed;
}

/// One real transform of `length` samples gives a real one of half the length (the even outputs) and a complex one of
/// a quarter (outputs 1, 5, 9, …; 3, 7, 11, … are conjugates of these).
void transformColumns(const double* samples, Workspace& work, const TrigonometryTable& table) {
  const auto sample = [samples](std::size_t row) { return Eigen::Map<const Row>(samples + row * columns); };
  for (std::size_t a = 0; a < rows / 2; ++a) {
    work.difference[a] = sample(a) - sample(a + rows / 2);
    work.sum[a] = sample(a) + sample(a + rows / 2);
  }
  for (std::size_t length = rows; length >= 4; length /= 2) {
    const std::size_t quarter = length / 4;
    const std::size_t stride = rows / length;
    for (std::size_t a = 0; a < quarter; ++a) {
      work.odd[a].re = work.difference[a];
      work.odd[a].im = -work.difference[a + quarter];
      if (a != 0) {
        rotate(work.odd[a], std::conj(table.unit(a * (grid / length))));
      }
    }
    transform(work.odd, quarter, table);
    for (std::size_t q = 0; q < quarter; ++q) {
      const std::size_t order = stride * (4 * q + 1);
      const ComplexRow& value = work.odd[bitReversed(q, quarter)];
      if (order <= rows / 2) {
        work.output[order] = value;
      } else {
        work.output[rows - order].re = value.re;
        work.output[rows - order].im = -value.im;
      }
    }
    for (std::size_t a = 0; a < quarter; ++a) {
      const Row upper = work.sum[a];
      work.difference[a] = upper - work.sum[a + quarter];
      work.sum[a] = upper + work.sum[a + quarter];
    }
  }
  // Two samples are left: their sum is the mean, their difference harmonic 64.
  work.output[0] = {work.sum[0], Row::Zero()};
  work.output[rows / 2] = {work.difference[0], Row::Zero()};
}

} // namespace

std::vector<int> HarmonicSpectrum::ordersByAmplitude(int limit) const {
  std::vector<int> orders(static_cast<std::size_t>(std::clamp(limit, 0, largestHarmonic)));
  std::iota(orders.begin(), orders.end(), 1);
  std::stable_sort(orders.begin(), orders.end(), [this](int left, int right) {
    return std::norm(coefficient[static_cast<std::size_t>(left)]) >
           std::norm(coefficient[static_cast<std::size_t>(right)]);
  });
  return orders;
}

HarmonicSpectrum spectrumOf(const Eigen::VectorXd& gridDeg, int limit) {
  assert(gridDeg.size() == gridSize);
  const TrigonometryTable& table = TrigonometryTable::instance();
  Workspace work;
  transformColumns(gridDeg.data(), work, table);

  HarmonicSpectrum spectrum;
  const auto last = static_cast<std::size_t>(std::clamp(limit, 0, largestHarmonic));
  for (std::size_t order = 0; order <= last; ++order) {
    double re = 0.0;
    double im = 0.0;
    const ComplexRow& value = work.output[order];
    for (std::size_t column = 0; column < columns; ++column) {
      const double c = table.cosine(order * column);
      const double s = table.sine(order * column);
      const auto at = static_cast<Eigen::Index>(column);
      re += value.re[at] * c + value.im[at] * s;
      im += value.im[at] * c - value.re[at] * s;
    }
    spectrum.coefficient[order] = std::complex<double>(re, im) / static_cast<double>(grid);
  }
  return spectrum;
}

} // namespace straightedge::angle
