#include "core/numerics/polynomial.h"

#include <Eigen/QR>

#include <cmath>
#include <limits>

namespace straightedge::numerics {

namespace {

/// Powers of (x − middle)/half as sums of powers of x: column k holds the coefficients of power k.
Eigen::MatrixXd expansion(Eigen::Index size, double middle, double half) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  result(0, 0) = 1.0;
  for (Eigen::Index k = 1; k < size; ++k) {
    for (Eigen::Index i = 0; i <= k; ++i) {
      const double lower = i > 0 ? result(i - 1, k - 1) : 0.0;
      const double same = i < k ? result(i, k - 1) : 0.0;
      result(i, k) = (lower - middle * same) / half;
    }
  }
  return result;
}

} // namespace

Eigen::VectorXd polynomialAt(std::span<const double> coefficients, const Eigen::VectorXd& x) {
  Eigen::ArrayXd value = Eigen::ArrayXd::Zero(x.size());
  for (std::size_t i = coefficients.size(); i > 0; --i) {
    value = value * x.array() + coefficients[i - 1];
  }
  return value;
}

double PolynomialFit::sigma(Eigen::Index coefficient) const { return std::sqrt(covariance(coefficient, coefficient)); }

std::optional<PolynomialFit> fitPolynomial(const Eigen::VectorXd& x, const Eigen::VectorXd& values, int order,
                                           PolynomialDetail detail) {
  const Eigen::Index size = order + 1;
  if (x.size() < size || !x.allFinite() || !values.allFinite()) {
    return std::nullopt;
  }
  const double middle = (x.maxCoeff() + x.minCoeff()) / 2.0;
  const double range = (x.maxCoeff() - x.minCoeff()) / 2.0;
  const double half = range > 0.0 ? range : 1.0;
  if (order > 0 && !(range > 0.0)) {
    return std::nullopt;
  }
  Eigen::MatrixXd powers(x.size(), size);
  powers.col(0).setOnes();
  for (Eigen::Index k = 1; k < size; ++k) {
    powers.col(k) = powers.col(k - 1).array() * (x.array() - middle) / half;
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(powers);
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(size).triangularView<Eigen::Upper>();
  const Eigen::ArrayXd diagonal = triangle.diagonal().array().abs();
  constexpr double smallestPivot = 1e-10; // of the largest: beyond it two powers cannot be told apart
  if (diagonal.minCoeff() <= smallestPivot * diagonal.maxCoeff()) {
    return std::nullopt;
  }
  PolynomialFit fit;
  fit.points = x.size();
  const Eigen::VectorXd scaled = qr.solve(values);
  const Eigen::MatrixXd inverse = triangle.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(size, size));
  const Eigen::MatrixXd orthogonal = powers * inverse;
  const Eigen::MatrixXd expand = expansion(size, middle, half);
  fit.coefficients = expand * scaled;
  fit.residuals = values - powers * scaled;
  const Eigen::ArrayXd kept = 1.0 - orthogonal.rowwise().squaredNorm().array();
  // A point that alone decides a coefficient foretells nothing: its left-out residual is not known.
  constexpr double decidesAlone = 1e-9;
  fit.leftOutResiduals =
      (kept > decidesAlone).select(fit.residuals.array() / kept, std::numeric_limits<double>::infinity());
  const Eigen::MatrixXd root = expand * inverse;
  if (fit.freedom() > 0) {
    fit.residualSigma = std::sqrt(fit.residuals.squaredNorm() / static_cast<double>(fit.freedom()));
  }
  fit.covariance = fit.residualSigma * fit.residualSigma * root * root.transpose();
  if (detail == PolynomialDetail::Full) {
    fit.influence = root * orthogonal.transpose();
  }
  return fit;
}

} // namespace straightedge::numerics
