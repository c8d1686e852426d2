#include "core/field/chain.h"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace straightedge::field {

namespace {

constexpr std::array<const char*, 3> axisNames = {"x", "y", "z"};
constexpr std::size_t chunk = 1024; ///< readings corrected between looks at what is missing; stays in the first cache

double horner(std::span<const double> ascending, double x) {
  double sum = 0.0;
  for (std::size_t power = ascending.size(); power-- > 0;) {
    sum = sum * x + ascending[power];
  }
  return sum;
}

double horner(const ChainPolynomial& polynomial, double x) {
  return horner(std::span(static_cast<const double*>(polynomial.values), polynomial.count), x);
}

/// V1 to V5.
AxisStages stagesOf(const AxisCoefficients& axis, double rawT, double probeC, double electronicsC) {
  AxisStages v;
  v.nonlinearityT = horner(axis.nonlinearity, rawT);
  v.offsetT = v.nonlinearityT - (axis.offset0 + axis.offset1 * probeC);
  v.sensitivityT = v.offsetT - (horner(axis.slope, v.offsetT) * probeC + horner(axis.intercept, v.offsetT));
  v.electronicsT = v.sensitivityT - (axis.electronics0 + axis.electronics1 * electronicsC);
  v.electronicsSensitivityT = v.electronicsT - (axis.sensitivity0 + axis.sensitivity1 * v.electronicsT) * electronicsC;
  return v;
}

bool areNumbers(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// False if there are too many coefficients or one is no number.
bool fill(ChainPolynomial& to, std::span<const double> from) {
  if (from.size() > mostChainCoefficients || !areNumbers(from)) {
    return false;
  }
  std::copy(from.begin(), from.end(), static_cast<double*>(to.values));
  to.count = std::max<std::size_t>(1, from.size());
  return true;
}

bool fill(double& first, double& second, const std::optional<std::array<double, 2>>& from) {
  if (!from) {
    return true;
  }
  first = (*from)[0];
  second = (*from)[1];
  return areNumbers(*from);
}

/// False as fill().
bool fill(AxisCoefficients& to, const AxisChain& from) {
  static constexpr std::array<double, 2> unchanged = {0.0, 1.0};
  const std::span<const double> nonlinearity =
      from.nonlinearity.empty() ? std::span<const double>(unchanged) : std::span<const double>(from.nonlinearity);
  return fill(to.nonlinearity, nonlinearity) && fill(to.offset0, to.offset1, from.offsetT) &&
         (!from.sensitivitySlope || fill(to.slope, *from.sensitivitySlope)) &&
         (!from.sensitivityIntercept || fill(to.intercept, *from.sensitivityIntercept)) &&
         fill(to.electronics0, to.electronics1, from.electronicsT) &&
         fill(to.sensitivity0, to.sensitivity1, from.electronicsSensitivity);
}

AxisCoefficients coefficientsOf(const AxisChain& axis) {
  AxisCoefficients coefficients;
  [[maybe_unused]] const bool filled = fill(coefficients, axis);
  return coefficients;
}

/// Part of the columns; what no block needs comes from `zeros`.
ChainColumns part(const ReadingColumns& readings, const FieldColumns& fields, std::size_t at, const double* zeros,
                  bool probe, bool electronics) {
  ChainColumns columns;
  columns.pt100Ohm = probe ? readings.pt100Ohm.data() + at : zeros;
  columns.electronicsC = electronics ? readings.electronicsC.data() + at : zeros;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns.rawT[axis] = readings.rawT[axis].data() + at;
    columns.fieldT[axis] = fields.fieldT[axis].data() + at;
  }
  return columns;
}

using ColumnLoop = void (*)(const ChainCoefficients&, const ChainColumns&);

bool hasAvx2() {
#ifdef STRAIGHTEDGE_AVX2
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return false;
#endif
}

ColumnLoop columnLoop() {
#ifdef STRAIGHTEDGE_AVX2
  if (hasAvx2()) {
    return correctColumnsAvx2;
  }
#endif
  return correctColumnsBaseline;
}

/// The last few readings, filled up to a whole step in memory of their own.
void correctRest(const ChainCoefficients& coefficients, const ChainColumns& columns, std::size_t count,
                 ColumnLoop loop) {
  std::array<std::array<double, chainStep>, 8> copies{};
  const std::array<const double*, 5> from = {columns.pt100Ohm, columns.electronicsC, columns.rawT[0], columns.rawT[1],
                                             columns.rawT[2]};
  for (std::size_t column = 0; column < from.size(); ++column) {
    std::copy_n(from[column], count, copies[column].begin());
  }
  ChainColumns filled;
  filled.pt100Ohm = copies[0].data();
  filled.electronicsC = copies[1].data();
  filled.count = chainStep;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    filled.rawT[axis] = copies[2 + axis].data();
    filled.fieldT[axis] = copies[5 + axis].data();
  }
  loop(coefficients, filled);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy_n(copies[5 + axis].begin(), count, columns.fieldT[axis]);
  }
}

} // namespace

AxisStages axisStages(const AxisChain& axis, double rawT, double probeC, double electronicsC) {
  return stagesOf(coefficientsOf(axis), rawT, probeC, electronicsC);
}

double probeAboveReference(const CorrectionChain& chain, double pt100Ohm) {
  return chain.pt100 ? chain.pt100->slopeCPerOhm * pt100Ohm + chain.pt100->interceptC : 0.0;
}

Result<AppliedChain> AppliedChain::prepare(const CorrectionChain& chain) {
  AppliedChain applied;
  ChainCoefficients& c = applied.m_coefficients;
  for (std::size_t i = 0; i < chain.axes.size(); ++i) {
    const AxisChain& axis = chain.axes[i];
    if (!fill(c.axes[i], axis)) {
      return fail(ErrorKind::Input,
                  std::string("the coefficients of axis ") + axisNames[i] + " are not numbers or more than " +
                      std::to_string(mostChainCoefficients) + " in one polynomial",
                  "fit the calibration again");
    }
    applied.m_needsProbe = applied.m_needsProbe || axis.offsetT || axis.sensitivitySlope;
    applied.m_needsElectronics = applied.m_needsElectronics || axis.electronicsT || axis.electronicsSensitivity;
    if (applied.m_needsProbe && !chain.pt100) {
      return fail(ErrorKind::Input,
                  std::string("the ") + (axis.offsetT ? "offset" : "sensitivity") + " of axis " + axisNames[i] +
                      " needs the probe's temperature, but the calibration has no line for the PT100",
                  "fit the calibration again, with the step probe-temperature");
    }
  }
  if (chain.pt100) {
    c.pt100Slope = chain.pt100->slopeCPerOhm;
    c.pt100Intercept = chain.pt100->interceptC;
  }
  // A temperature that no block needs is not even looked at: it is 0 above reference then.
  if (!applied.m_needsProbe) {
    c.pt100Slope = c.pt100Intercept = 0.0;
  }
  c.referenceC = applied.m_needsElectronics ? chain.referenceTemperatureC : 0.0;
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();
  if (chain.axisMatrix) {
    const Eigen::FullPivLU<Eigen::Matrix3d> decomposition(*chain.axisMatrix);
    if (!chain.axisMatrix->allFinite() || !decomposition.isInvertible()) {
      return fail(ErrorKind::Input, "the matrix of the axes cannot be inverted",
                  "measure the orientations again: every axis has to point along the field once");
    }
    inverse = decomposition.inverse();
  }
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      c.inverse[row][column] = inverse(row, column);
    }
  }
  return applied;
}

Eigen::Vector3d AppliedChain::correct(const Reading& reading) const {
  const ChainCoefficients& c = m_coefficients;
  const double probe = m_needsProbe ? c.pt100Slope * reading.pt100Ohm + c.pt100Intercept : 0.0;
  const double electronics = m_needsElectronics ? reading.electronicsC - c.referenceC : 0.0;
  const double x = stagesOf(c.axes[0], reading.rawT[0], probe, electronics).electronicsSensitivityT;
  const double y = stagesOf(c.axes[1], reading.rawT[1], probe, electronics).electronicsSensitivityT;
  const double z = stagesOf(c.axes[2], reading.rawT[2], probe, electronics).electronicsSensitivityT;
  return {(c.inverse[0][0] * x + c.inverse[0][1] * y) + c.inverse[0][2] * z,
          (c.inverse[1][0] * x + c.inverse[1][1] * y) + c.inverse[1][2] * z,
          (c.inverse[2][0] * x + c.inverse[2][1] * y) + c.inverse[2][2] * z};
}

void AppliedChain::correctPlainly(const ReadingColumns& readings, const FieldColumns& fields) const {
  for (std::size_t i = 0; i < readings.rawT[0].size(); ++i) {
    const Eigen::Vector3d field = correct({m_needsProbe ? readings.pt100Ohm[i] : 0.0,
                                           m_needsElectronics ? readings.electronicsC[i] : 0.0,
                                           {readings.rawT[0][i], readings.rawT[1][i], readings.rawT[2][i]}});
    fields.fieldT[0][i] = field[0];
    fields.fieldT[1][i] = field[1];
    fields.fieldT[2][i] = field[2];
  }
}

void AppliedChain::correct(const ReadingColumns& readings, const FieldColumns& fields) const {
  const std::size_t count = readings.rawT[0].size();
  assert(!m_needsProbe || readings.pt100Ohm.size() == count);
  assert(!m_needsElectronics || readings.electronicsC.size() == count);
  static const std::array<double, chunk> zeros{};
  const ColumnLoop loop = columnLoop();
  for (std::size_t at = 0; at < count; at += chunk) {
    const std::size_t here = std::min(chunk, count - at);
    ChainColumns columns = part(readings, fields, at, zeros.data(), m_needsProbe, m_needsElectronics);
    columns.count = here - here % chainStep;
    loop(m_coefficients, columns);
    if (columns.count < here) {
      const ChainColumns rest =
          part(readings, fields, at + columns.count, zeros.data(), m_needsProbe, m_needsElectronics);
      correctRest(m_coefficients, rest, here - columns.count, loop);
    }
  }
}

const char* chainInstructions() { return hasAvx2() ? "AVX2 and FMA" : "baseline"; }

} // namespace straightedge::field
