#include "core/angle/quantisation.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace straightedge::angle {

namespace {

int largestInteger(int bits) { return (1 << (bits - 1)) - 1; }

int nearest(double value, double lsb) { return lsb == 0.0 ? 0 : static_cast<int>(std::lround(value / lsb)); }

StoredIntegers storedValues(const Eigen::VectorXd& values, int bits) {
  StoredIntegers stored;
  stored.bits = bits;
  const double least = values.minCoeff();
  const double most = values.maxCoeff();
  stored.biasDeg = 0.5 * (most + least);
  stored.lsbDeg = 0.5 * (most - least) / largestInteger(bits);
  stored.integers.reserve(static_cast<std::size_t>(values.size()));
  for (const double value : values) {
    stored.integers.push_back(nearest(value - stored.biasDeg, stored.lsbDeg));
  }
  return stored;
}

StoredIntegers storedHarmonics(const HarmonicModel& model, int bits) {
  StoredIntegers stored;
  stored.bits = bits;
  stored.biasDeg = model.offsetDeg;
  stored.phaseLsbRad = std::ldexp(2.0 * std::numbers::pi, -bits);
  for (const HarmonicTerm& term : model.terms) {
    stored.lsbDeg = std::max(stored.lsbDeg, term.amplitudeDeg / largestInteger(bits));
  }
  for (const HarmonicTerm& term : model.terms) {
    stored.integers.push_back(nearest(term.amplitudeDeg, stored.lsbDeg));
  }
  for (const HarmonicTerm& term : model.terms) {
    const int phase = nearest(term.phaseRad, *stored.phaseLsbRad);
    stored.integers.push_back(phase > largestInteger(bits) ? phase - (1 << bits) : phase);
  }
  return stored;
}

Eigen::VectorXd valuesOf(const StoredIntegers& stored) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(stored.integers.size()));
  for (std::size_t k = 0; k < stored.integers.size(); ++k) {
    values[static_cast<Eigen::Index>(k)] = stored.biasDeg + stored.lsbDeg * stored.integers[k];
  }
  return values;
}

HarmonicModel harmonicsOf(const StoredIntegers& stored, const HarmonicModel& orders) {
  HarmonicModel model;
  model.offsetDeg = stored.biasDeg;
  const std::size_t count = orders.terms.size();
  for (std::size_t k = 0; k < count; ++k) {
    model.terms.push_back({orders.terms[k].order, stored.lsbDeg * stored.integers[k],
                           stored.phaseLsbRad.value_or(0.0) * stored.integers[count + k]});
  }
  return model;
}

} // namespace

ModelBody bodyOf(const StoredIntegers& stored, const ModelBody& body) {
  if (const auto* harmonics = std::get_if<HarmonicModel>(&body)) {
    return harmonicsOf(stored, *harmonics);
  }
  if (std::holds_alternative<LinearModel>(body)) {
    return LinearModel{valuesOf(stored)};
  }
  return LookupTableModel{valuesOf(stored)};
}

std::pair<StoredIntegers, ModelBody> quantised(const ModelBody& body, int bits) {
  StoredIntegers stored;
  if (const auto* harmonics = std::get_if<HarmonicModel>(&body)) {
    stored = storedHarmonics(*harmonics, bits);
  } else if (const auto* linear = std::get_if<LinearModel>(&body)) {
    stored = storedValues(linear->valuesDeg, bits);
  } else {
    stored = storedValues(std::get<LookupTableModel>(body).valuesDeg, bits);
  }
  ModelBody rebuilt = bodyOf(stored, body);
  return {std::move(stored), std::move(rebuilt)};
}

} // namespace straightedge::angle
