// Polynomials in ascending powers, fitted by linear least squares on a scaled argument.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <span>

namespace straightedge::numerics {

/// c[0] + c[1]·x + … (Horner); 0 for no coefficients.
template <typename Coefficients>
double polynomialAt(const Coefficients& coefficients, double x) {
  double value = 0.0;
  for (auto i = coefficients.size(); i > 0; --i) {
    value = value * x + coefficients[i - 1];
  }
  return value;
}

/// The same for every element of `x`.
Eigen::VectorXd polynomialAt(std::span<const double> coefficients, const Eigen::VectorXd& x);

struct PolynomialFit {
  Eigen::VectorXd coefficients;     ///< ascending powers of x
  Eigen::MatrixXd covariance;       ///< of the coefficients; zero without freedom
  Eigen::MatrixXd influence;        ///< coefficients = influence·values; to propagate what is known of single values
  Eigen::VectorXd residuals;        ///< value − polynomial at every point
  Eigen::VectorXd leftOutResiduals; ///< the same with that point left out of the fit (residual/(1 − leverage), PRESS)
  double residualSigma = 0.0;       ///< √(Σ residual²/(points − coefficients)); 0 without freedom
  Eigen::Index points = 0;

  Eigen::Index freedom() const { return points - coefficients.size(); }
  double sigma(Eigen::Index coefficient) const; ///< standard uncertainty of a coefficient
};

enum class PolynomialDetail { Full, WithoutInfluence };

/// Least squares by Householder QR in u = (x − middle)/half range, which keeps high orders well conditioned; the
/// coefficients are then expanded to powers of x. `influence` is left empty on request: it is as long as the data.
/// Nothing where the x do not determine the polynomial: fewer than order + 1 distinct values, or one not finite.
std::optional<PolynomialFit> fitPolynomial(const Eigen::VectorXd& x, const Eigen::VectorXd& values, int order,
                                           PolynomialDetail detail = PolynomialDetail::Full);

} // namespace straightedge::numerics
