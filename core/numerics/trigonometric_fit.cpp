#include "core/numerics/trigonometric_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace straightedge::numerics {

namespace {

constexpr double radiansPerDegree = std::numbers::pi / 180.0;
/// A pivot of the scaled normal equations below this says that the points do not determine the next coefficient: with
/// it the solution would keep fewer than about 8 of its 16 digits.
constexpr double smallestPivot = 1e-8;

std::complex<double> unitAt(double deg) { return std::polar(1.0, deg * radiansPerDegree); }

/// Calls use(k, cos(k·x), sin(k·x)) for k = 1 … highest, turning a unit vector step by step.
template <typename Use>
void forEachHarmonic(double deg, int highest, Use use) {
  const std::complex<double> step = unitAt(deg);
  double c = step.real();
  double s = step.imag();
  for (int k = 1; k <= highest; ++k) {
    use(k, c, s);
    const double next = c * step.real() - s * step.imag();
    s = s * step.real() + c * step.imag();
    c = next;
  }
}

/// Column of cos(k·x) is 2k−1, of sin(k·x) 2k: the coefficients of fewer harmonics come first.
Eigen::Index columnsFor(int harmonics) { return 2 * harmonics + 1; }

struct NormalEquations {
  Eigen::MatrixXd gram;       ///< AᵀA/points
  Eigen::VectorXd rightSide;  ///< Aᵀy/points
  Eigen::MatrixXd groupRow;   ///< per group (column): mean of its rows of A
  Eigen::VectorXd groupValue; ///< mean of its values
  Eigen::VectorXd groupCount;
  double squares = 0.0; ///< Σ y²
};

/// AᵀA from the sums of cos(m·x) and sin(m·x), m ≤ 2·highest: products of two harmonics are sums of two others.
void fillGram(const Eigen::VectorXd& meanCosine, const Eigen::VectorXd& meanSine, int highest, Eigen::MatrixXd& gram) {
  const auto sineOf = [&](int order) { return order < 0 ? -meanSine(-order) : meanSine(order); };
  gram.resize(columnsFor(highest), columnsFor(highest));
  gram(0, 0) = 1.0;
  for (int k = 1; k <= highest; ++k) {
    gram(2 * k - 1, 0) = gram(0, 2 * k - 1) = meanCosine(k);
    gram(2 * k, 0) = gram(0, 2 * k) = meanSine(k);
    for (int j = 1; j <= highest; ++j) {
      const int difference = k > j ? k - j : j - k;
      gram(2 * k - 1, 2 * j - 1) = 0.5 * (meanCosine(difference) + meanCosine(k + j));
      gram(2 * k, 2 * j) = 0.5 * (meanCosine(difference) - meanCosine(k + j));
      gram(2 * k, 2 * j - 1) = gram(2 * j - 1, 2 * k) = 0.5 * (meanSine(k + j) + sineOf(k - j));
    }
  }
}

NormalEquations accumulate(const Eigen::VectorXd& deg, const Eigen::VectorXd& values,
                           const std::vector<std::size_t>& group, std::size_t groups, int highest) {
  const Eigen::Index points = deg.size();
  const Eigen::Index columns = columnsFor(highest);
  const auto groupCount = static_cast<Eigen::Index>(groups);
  NormalEquations sums{{},
                       Eigen::VectorXd::Zero(columns),
                       Eigen::MatrixXd::Zero(columns, groupCount),
                       Eigen::VectorXd::Zero(groupCount),
                       Eigen::VectorXd::Zero(groupCount),
                       values.squaredNorm()};
  Eigen::VectorXd cosines = Eigen::VectorXd::Zero(2 * highest + 1);
  Eigen::VectorXd sines = Eigen::VectorXd::Zero(2 * highest + 1);
  Eigen::VectorXd row(columns);
  row(0) = 1.0;
  for (Eigen::Index i = 0; i < points; ++i) {
    forEachHarmonic(deg(i), 2 * highest, [&](int k, double c, double s) {
      cosines(k) += c;
      sines(k) += s;
      if (k <= highest) {
        row(2 * k - 1) = c;
        row(2 * k) = s;
      }
    });
    const auto g = static_cast<Eigen::Index>(group[static_cast<std::size_t>(i)]);
    sums.rightSide += values(i) * row;
    sums.groupRow.col(g) += row;
    sums.groupValue(g) += values(i);
    sums.groupCount(g) += 1.0;
  }
  const auto count = static_cast<double>(points);
  cosines /= count;
  sines /= count;
  cosines(0) = 1.0;
  fillGram(cosines, sines, highest, sums.gram);
  sums.rightSide /= count;
  for (Eigen::Index g = 0; g < groupCount; ++g) {
    assert(sums.groupCount(g) > 0.0);
    sums.groupRow.col(g) /= sums.groupCount(g);
    sums.groupValue(g) /= sums.groupCount(g);
  }
  return sums;
}

/// Lower Cholesky factor of as many leading columns as the points determine; `determined` says how many.
Eigen::MatrixXd choleskyWhileDetermined(const Eigen::MatrixXd& gram, Eigen::Index& determined) {
  const Eigen::Index n = gram.rows();
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(n, n);
  determined = n;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      factor(i, j) = (gram(i, j) - factor.row(i).head(j).dot(factor.row(j).head(j))) / factor(j, j);
    }
    const double pivot = gram(i, i) - factor.row(i).head(i).squaredNorm();
    if (pivot < smallestPivot) {
      determined = i;
      break;
    }
    factor(i, i) = std::sqrt(pivot);
  }
  return factor;
}

/// How far leaving out a group moves its own residuals: residual + weight·(mean residual of the group).
/// From (I − H_gg)⁻¹ with H_gg = (leverage/count)·1·1ᵀ. Not finite where the other points cannot stand in.
double leavingOutWeight(double leverageOfGroup) {
  constexpr double mostLeverage = 1.0 - 1e-9;
  return leverageOfGroup < mostLeverage ? leverageOfGroup / (1.0 - leverageOfGroup)
                                        : std::numeric_limits<double>::infinity();
}

struct CrossValidation {
  std::vector<double> rms;                ///< per number of harmonics
  std::vector<Eigen::VectorXd> leverages; ///< per number of harmonics, per group
};

CrossValidation crossValidate(const NormalEquations& sums, const Eigen::MatrixXd& factor, int highest,
                              Eigen::Index points) {
  const Eigen::Index columns = columnsFor(highest);
  const auto triangle = factor.topLeftCorner(columns, columns).triangularView<Eigen::Lower>();
  const auto count = static_cast<double>(points);
  // In the basis made orthonormal by the factor, coefficients do not depend on how many there are.
  const Eigen::VectorXd coefficients = triangle.solve(sums.rightSide.head(columns));
  const Eigen::MatrixXd rows = triangle.solve(sums.groupRow.topRows(columns));

  CrossValidation result;
  Eigen::VectorXd residual = sums.groupValue;
  Eigen::VectorXd leverage = Eigen::VectorXd::Zero(sums.groupCount.size());
  double explained = 0.0;
  const bool repeats = sums.groupCount.size() < points;
  for (int harmonics = 0; harmonics <= highest; ++harmonics) {
    for (Eigen::Index c = harmonics == 0 ? 0 : columnsFor(harmonics - 1); c < columnsFor(harmonics); ++c) {
      residual -= coefficients(c) * rows.row(c).transpose();
      leverage += sums.groupCount.cwiseProduct(rows.row(c).transpose().cwiseAbs2()) / count;
      explained += coefficients(c) * coefficients(c) * count;
    }
    double betweenGroups = 0.0;
    double leftOut = 0.0;
    for (Eigen::Index g = 0; g < residual.size(); ++g) {
      const double square = sums.groupCount(g) * residual(g) * residual(g);
      const double weight = 1.0 + leavingOutWeight(leverage(g));
      betweenGroups += square;
      leftOut += weight * weight * square;
    }
    if (harmonics > 0 && !std::isfinite(leftOut)) {
      break; // some group alone holds up a coefficient: the others do not determine it
    }
    // What remains inside the groups is not touched by leaving them out.
    const double insideGroups = repeats ? std::max(0.0, sums.squares - explained - betweenGroups) : 0.0;
    result.rms.push_back(std::sqrt((leftOut + insideGroups) / count));
    result.leverages.push_back(leverage);
  }
  return result;
}

int smallestOfTheBest(const std::vector<double>& rms) {
  const double best = *std::min_element(rms.begin(), rms.end());
  const auto asGood = std::find_if(rms.begin(), rms.end(), [&](double r) { return r <= best * 1.0001 + 1e-9; });
  return static_cast<int>(asGood - rms.begin());
}

} // namespace

double trigonometricAt(double offset, const Eigen::VectorXd& cosine, const Eigen::VectorXd& sine, double deg) {
  double sum = offset;
  forEachHarmonic(deg, static_cast<int>(cosine.size()),
                  [&](int k, double c, double s) { sum += cosine(k - 1) * c + sine(k - 1) * s; });
  return sum;
}

Eigen::VectorXd trigonometricSampled(double offset, const Eigen::VectorXd& cosine, const Eigen::VectorXd& sine,
                                     int count) {
  // cos(2π·j/count) once; harmonic k at point i is entry k·i modulo count.
  Eigen::VectorXd table(count);
  for (int j = 0; j < count; ++j) {
    table(j) = std::cos(2.0 * std::numbers::pi * j / count);
  }
  Eigen::VectorXd sineTable(count);
  for (int j = 0; j < count; ++j) {
    sineTable(j) = std::sin(2.0 * std::numbers::pi * j / count);
  }
  Eigen::VectorXd result = Eigen::VectorXd::Constant(count, offset);
  for (Eigen::Index k = 1; k <= cosine.size(); ++k) {
    const int step = static_cast<int>(k % count);
    int phase = 0;
    for (int i = 0; i < count; ++i) {
      result(i) += cosine(k - 1) * table(phase) + sine(k - 1) * sineTable(phase);
      phase += step;
      phase -= phase >= count ? count : 0;
    }
  }
  return result;
}

TrigonometricFit fitTrigonometric(const Eigen::VectorXd& deg, const Eigen::VectorXd& values,
                                  const std::vector<std::size_t>& group, std::size_t groups, int maxHarmonics) {
  assert(deg.size() > 0 && deg.size() == values.size());
  assert(group.size() == static_cast<std::size_t>(deg.size()));
  // About their mean the values lose fewer digits in sums of squares.
  const double centre = values.mean();
  const Eigen::VectorXd centred = values.array() - centre;
  const NormalEquations sums = accumulate(deg, centred, group, groups, maxHarmonics);
  Eigen::Index determined = 0;
  const Eigen::MatrixXd factor = choleskyWhileDetermined(sums.gram, determined);
  const int highest = std::min(maxHarmonics, static_cast<int>((determined - 1) / 2));
  const CrossValidation validation = crossValidate(sums, factor, highest, deg.size());

  TrigonometricFit fit;
  fit.leftOutRms = validation.rms;
  fit.harmonics = smallestOfTheBest(validation.rms);
  const Eigen::Index columns = columnsFor(fit.harmonics);
  const auto triangle = factor.topLeftCorner(columns, columns).triangularView<Eigen::Lower>();
  Eigen::VectorXd solution = triangle.solve(sums.rightSide.head(columns));
  triangle.transpose().solveInPlace(solution);
  fit.offset = centre + solution(0);
  fit.cosine.resize(fit.harmonics);
  fit.sine.resize(fit.harmonics);
  for (int k = 1; k <= fit.harmonics; ++k) {
    fit.cosine(k - 1) = solution(2 * k - 1);
    fit.sine(k - 1) = solution(2 * k);
  }

  fit.residuals.resize(deg.size());
  Eigen::VectorXd groupMean = Eigen::VectorXd::Zero(sums.groupCount.size());
  for (Eigen::Index i = 0; i < deg.size(); ++i) {
    fit.residuals(i) = values(i) - trigonometricAt(fit.offset, fit.cosine, fit.sine, deg(i));
    const auto g = static_cast<Eigen::Index>(group[static_cast<std::size_t>(i)]);
    groupMean(g) += fit.residuals(i) / sums.groupCount(g);
  }
  fit.leftOutResiduals.resize(deg.size());
  const Eigen::VectorXd& leverage = validation.leverages[static_cast<std::size_t>(fit.harmonics)];
  for (Eigen::Index i = 0; i < deg.size(); ++i) {
    const auto g = static_cast<Eigen::Index>(group[static_cast<std::size_t>(i)]);
    fit.leftOutResiduals(i) = fit.residuals(i) + leavingOutWeight(leverage(g)) * groupMean(g);
  }
  const auto freedom = static_cast<double>(deg.size() - fit.coefficients());
  fit.residualSigma = freedom > 0.0 ? std::sqrt(fit.residuals.squaredNorm() / freedom) : 0.0;
  return fit;
}

} // namespace straightedge::numerics
