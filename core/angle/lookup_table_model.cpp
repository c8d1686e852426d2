#include "core/angle/lookup_table_model.h"

#include "core/angle/bin_walk.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace straightedge::angle {

namespace {

/// Short bins are not worth a vector loop's start.
constexpr int shortBin = 16;

double meanOf(const double* bin, int samples) {
  if (samples >= shortBin) {
    return Eigen::Map<const Eigen::VectorXd>(bin, samples).mean();
  }
  double sum = 0.0;
  for (int j = 0; j < samples; ++j) {
    sum += bin[j];
  }
  return sum / samples;
}

double middleOf(const double* bin, int samples) {
  if (samples >= shortBin) {
    const Eigen::Map<const Eigen::VectorXd> values(bin, samples);
    return 0.5 * (values.minCoeff() + values.maxCoeff());
  }
  double least = bin[0];
  double most = bin[0];
  for (int j = 1; j < samples; ++j) {
    least = bin[j] < least ? bin[j] : least;
    most = bin[j] > most ? bin[j] : most;
  }
  return 0.5 * (least + most);
}

} // namespace

Eigen::VectorXd lookupTableValues(const Eigen::VectorXd& gridDeg, int size, FitMethod method) {
  assert(size >= 1 && gridDeg.size() >= size);
  const int count = static_cast<int>(gridDeg.size());
  Eigen::VectorXd values(size);
  BinWalk walk(size, count);
  for (int k = 0; k < size; ++k, walk.next()) {
    const double* const bin = gridDeg.data() + walk.first();
    values[k] = method == FitMethod::MidRange ? middleOf(bin, walk.samples()) : meanOf(bin, walk.samples());
  }
  return values;
}

void evaluateLookupTable(std::span<const double> valuesDeg, double* out, int count) {
  const int size = static_cast<int>(valuesDeg.size());
  BinWalk bin(size, count);
  for (const double value : valuesDeg) {
    std::fill_n(out + bin.first(), bin.samples(), value);
    bin.next();
  }
}

double lookupTableAt(std::span<const double> valuesDeg, double readingDeg) {
  const std::size_t size = valuesDeg.size();
  const auto bin = static_cast<std::size_t>(readingDeg * static_cast<double>(size) / 360.0);
  return valuesDeg[std::min(bin, size - 1)]; // should the quotient just below 360° round up to the size
}

} // namespace straightedge::angle
