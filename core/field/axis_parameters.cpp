#include "core/field/axis_parameters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace straightedge::field {

namespace {

struct ValueAndSlope {
  double value = 0.0;
  double slope = 0.0;
};

template <typename Coefficients>
ValueAndSlope horner(const Coefficients& ascending, double x) {
  ValueAndSlope at;
  for (std::size_t power = ascending.size(); power-- > 0;) {
    at.slope = at.slope * x + at.value;
    at.value = at.value * x + ascending[power];
  }
  return at;
}

template <typename Coefficients>
ValueAndSlope horner(const std::optional<Coefficients>& ascending, double x) {
  return ascending ? horner(*ascending, x) : ValueAndSlope{};
}

double first(const std::optional<std::array<double, 2>>& pair) { return pair ? (*pair)[0] : 0.0; }
double second(const std::optional<std::array<double, 2>>& pair) { return pair ? (*pair)[1] : 0.0; }

double power(double x, std::size_t exponent) {
  double product = 1.0;
  for (; exponent > 0; --exponent) {
    product *= x;
  }
  return product;
}

} // namespace

double& valueOf(AxisChain& axis, const ChainParameter& parameter) {
  switch (parameter.block) {
  case ChainBlock::Nonlinearity:
    return axis.nonlinearity[parameter.index];
  case ChainBlock::Offset:
    return (*axis.offsetT)[parameter.index];
  case ChainBlock::SensitivitySlope:
    return (*axis.sensitivitySlope)[parameter.index];
  case ChainBlock::SensitivityIntercept:
    return (*axis.sensitivityIntercept)[parameter.index];
  case ChainBlock::Electronics:
    return (*axis.electronicsT)[parameter.index];
  case ChainBlock::ElectronicsSensitivity:
    break;
  }
  return (*axis.electronicsSensitivity)[parameter.index];
}

std::vector<ChainParameter> independentParameters(const AxisChain& axis) {
  std::vector<ChainParameter> parameters;
  parameters.reserve(axis.nonlinearity.size());
  for (std::size_t k = 0; k < axis.nonlinearity.size(); ++k) {
    parameters.push_back({ChainBlock::Nonlinearity, k});
  }
  if (axis.offsetT) {
    parameters.push_back({ChainBlock::Offset, 1});
  }
  for (std::size_t k = axis.offsetT ? 1 : 0; axis.sensitivitySlope && k < axis.sensitivitySlope->size(); ++k) {
    parameters.push_back({ChainBlock::SensitivitySlope, k});
  }
  if (axis.electronicsT) {
    parameters.push_back({ChainBlock::Electronics, 1});
  }
  for (std::size_t k = axis.electronicsT ? 1 : 0; axis.electronicsSensitivity && k < 2; ++k) {
    parameters.push_back({ChainBlock::ElectronicsSensitivity, k});
  }
  return parameters;
}

AxisChain inIndependentParameters(const AxisChain& axis) {
  AxisChain moved = axis;
  if (moved.nonlinearity.size() < 2) {
    moved.nonlinearity = {0.0, 1.0};
  }
  if (moved.sensitivityIntercept) {
    const double factor = moved.sensitivityIntercept->size() > 1 ? 1.0 - (*moved.sensitivityIntercept)[1] : 1.0;
    for (double& coefficient : moved.nonlinearity) {
      coefficient *= factor;
    }
    moved.nonlinearity[0] -= moved.sensitivityIntercept->empty() ? 0.0 : moved.sensitivityIntercept->front();
    std::fill(moved.sensitivityIntercept->begin(), moved.sensitivityIntercept->end(), 0.0);
  }
  moved.nonlinearity[0] -= first(moved.offsetT) + first(moved.electronicsT);
  if (moved.offsetT) {
    (*moved.offsetT)[0] = 0.0;
    if (moved.sensitivitySlope && !moved.sensitivitySlope->empty()) {
      (*moved.offsetT)[1] += std::exchange(moved.sensitivitySlope->front(), 0.0);
    }
  }
  if (moved.electronicsT) {
    (*moved.electronicsT)[0] = 0.0;
    if (moved.electronicsSensitivity) {
      (*moved.electronicsT)[1] += std::exchange(moved.electronicsSensitivity->front(), 0.0);
    }
  }
  return moved;
}

AxisGradient axisGradient(const AxisChain& axis, const std::vector<ChainParameter>& parameters, double rawT,
                          double probeC, double electronicsC, Eigen::Ref<Eigen::VectorXd> byParameter) {
  assert(byParameter.size() == static_cast<Eigen::Index>(parameters.size()));
  const ValueAndSlope nonlinearity =
      axis.nonlinearity.empty() ? ValueAndSlope{rawT, 1.0} : horner(axis.nonlinearity, rawT);
  const double v2 = nonlinearity.value - (first(axis.offsetT) + second(axis.offsetT) * probeC);
  const ValueAndSlope slope = horner(axis.sensitivitySlope, v2);
  const ValueAndSlope intercept = horner(axis.sensitivityIntercept, v2);
  const double v3 = v2 - (slope.value * probeC + intercept.value);
  const double v4 = v3 - (first(axis.electronicsT) + second(axis.electronicsT) * electronicsC);
  const double by4 = 1.0 - second(axis.electronicsSensitivity) * electronicsC; // V5 by V4, and by V3
  const double by2 = by4 * (1.0 - (slope.slope * probeC + intercept.slope));   // V5 by V2, and by V1
  AxisGradient gradient;
  gradient.valueT = v4 - (first(axis.electronicsSensitivity) + second(axis.electronicsSensitivity) * v4) * electronicsC;
  gradient.byRaw = by2 * nonlinearity.slope;
  gradient.byProbe = -by2 * second(axis.offsetT) - by4 * slope.value;
  gradient.byElectronics = -by4 * second(axis.electronicsT) -
                           (first(axis.electronicsSensitivity) + second(axis.electronicsSensitivity) * v4);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::size_t k = parameters[i].index;
    double& by = byParameter[static_cast<Eigen::Index>(i)];
    switch (parameters[i].block) {
    case ChainBlock::Nonlinearity:
      by = by2 * power(rawT, k);
      break;
    case ChainBlock::Offset:
      by = -by2 * power(probeC, k);
      break;
    case ChainBlock::SensitivitySlope:
      by = -by4 * power(v2, k) * probeC;
      break;
    case ChainBlock::SensitivityIntercept:
      by = -by4 * power(v2, k);
      break;
    case ChainBlock::Electronics:
      by = -by4 * power(electronicsC, k);
      break;
    case ChainBlock::ElectronicsSensitivity:
      by = -power(v4, k) * electronicsC;
      break;
    }
  }
  return gradient;
}

} // namespace straightedge::field
