#include "core/angle/lookup_table_model.h"

#include "core/angle/linear_model.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace straightedge::angle {

Eigen::VectorXd lookupTableValues(const Eigen::VectorXd& gridDeg, int size, FitMethod method) {
  assert(size >= 1 && gridDeg.size() >= size);
  const int count = static_cast<int>(gridDeg.size());
  Eigen::VectorXd values(size);
  for (int k = 0; k < size; ++k) {
    const int first = firstOfBin(k, size, count);
    const int end = firstOfBin(k + 1, size, count);
    const double* const bin = gridDeg.data() + first;
    if (method == FitMethod::MidRange) {
      const auto [least, most] = std::minmax_element(bin, bin + (end - first));
      values[k] = 0.5 * (*least + *most);
    } else {
      double sum = 0.0;
      for (int j = 0; j < end - first; ++j) {
        sum += bin[j];
      }
      values[k] = sum / (end - first);
    }
  }
  return values;
}

void evaluateLookupTable(std::span<const double> valuesDeg, double* out, int count) {
  const int size = static_cast<int>(valuesDeg.size());
  for (int k = 0; k < size; ++k) {
    std::fill(out + firstOfBin(k, size, count), out + firstOfBin(k + 1, size, count),
              valuesDeg[static_cast<std::size_t>(k)]);
  }
}

double lookupTableAt(std::span<const double> valuesDeg, double readingDeg) {
  const std::size_t size = valuesDeg.size();
  const auto bin = static_cast<std::size_t>(readingDeg * static_cast<double>(size) / 360.0);
  return valuesDeg[std::min(bin, size - 1)]; // just below 360° the quotient may round up to the size itself
}

} // namespace straightedge::angle
