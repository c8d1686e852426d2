#include "core/numerics/cyclic_tridiagonal.h"

#include <cassert>

namespace straightedge::numerics {

CyclicTridiagonal::CyclicTridiagonal(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& offDiagonal)
    : m_diagonal(diagonal), m_offDiagonal(offDiagonal) {
  const Eigen::Index n = diagonal.size();
  assert(n >= 3 && offDiagonal.size() == n);
  const double corner = offDiagonal(n - 1);
  m_gamma = -diagonal(0);
  m_cornerRatio = corner / m_gamma;
  m_diagonal(0) -= m_gamma;
  m_diagonal(n - 1) -= corner * m_cornerRatio;

  m_pivotInverse.resize(n);
  m_multiplier.resize(n);
  m_pivotInverse(0) = 1.0 / m_diagonal(0);
  for (Eigen::Index i = 1; i < n; ++i) {
    m_multiplier(i - 1) = m_offDiagonal(i - 1) * m_pivotInverse(i - 1);
    m_pivotInverse(i) = 1.0 / (m_diagonal(i) - m_multiplier(i - 1) * m_offDiagonal(i - 1));
  }
  m_multiplier(n - 1) = 0.0;

  Eigen::VectorXd v = Eigen::VectorXd::Zero(n);
  v(0) = 1.0;
  v(n - 1) = m_cornerRatio;
  m_z = solveTridiagonal(std::move(v));
  m_scale = m_gamma / (1.0 + m_gamma * (m_z(0) + m_cornerRatio * m_z(n - 1)));
}

Eigen::VectorXd CyclicTridiagonal::solveTridiagonal(Eigen::VectorXd rightSide) const {
  const Eigen::Index n = rightSide.size();
  for (Eigen::Index i = 1; i < n; ++i) {
    rightSide(i) -= m_multiplier(i - 1) * rightSide(i - 1);
  }
  rightSide(n - 1) *= m_pivotInverse(n - 1);
  for (Eigen::Index i = n - 2; i >= 0; --i) {
    rightSide(i) = rightSide(i) * m_pivotInverse(i) - m_multiplier(i) * rightSide(i + 1);
  }
  return rightSide;
}

Eigen::VectorXd CyclicTridiagonal::solve(const Eigen::VectorXd& rightSide) const {
  const Eigen::Index n = m_diagonal.size();
  Eigen::VectorXd x = solveTridiagonal(rightSide);
  const double weight = m_scale * (x(0) + m_cornerRatio * x(n - 1));
  x -= weight * m_z;
  return x;
}

CyclicTridiagonal::InverseBand CyclicTridiagonal::inverseBand() const {
  const Eigen::Index n = m_diagonal.size();
  // Inverse of the tridiagonal part, from its last entry upwards: T⁻¹ = D⁻¹·L⁻¹ + (I − Lᵀ)·T⁻¹ read row by row
  // (Takahashi, Fagan and Chin).
  Eigen::VectorXd diagonal(n);
  diagonal(n - 1) = m_pivotInverse(n - 1);
  for (Eigen::Index i = n - 2; i >= 0; --i) {
    diagonal(i) = m_pivotInverse(i) + m_multiplier(i) * m_multiplier(i) * diagonal(i + 1);
  }
  InverseBand band{diagonal, Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    band.next(i) = -m_multiplier(i) * diagonal(i + 1);
  }
  for (Eigen::Index i = 0; i + 2 < n; ++i) {
    band.afterNext(i) = -m_multiplier(i) * band.next(i + 1);
  }
  // Entries that reach round the corner: (n−1,0), (n−2,0) and (n−1,1), by the same recurrence up a whole column.
  double fromLast = diagonal(n - 1);
  for (Eigen::Index i = n - 2; i >= 1; --i) {
    fromLast *= -m_multiplier(i);
  }
  double fromLastButOne = 0.0;
  if (n > 3) {
    fromLastButOne = band.next(n - 3);
    // T⁻¹(i, n−2) for i ≤ n−3 follows row by row as well
    for (Eigen::Index i = n - 4; i >= 0; --i) {
      fromLastButOne *= -m_multiplier(i);
    }
  } else {
    fromLastButOne = band.next(0);
  }
  band.afterNext(n - 1) = fromLast; // (n−1, 1)
  band.next(n - 1) = -m_multiplier(0) * fromLast;
  band.afterNext(n - 2) = fromLastButOne; // (n−2, 0)

  for (Eigen::Index i = 0; i < n; ++i) {
    band.diagonal(i) -= m_scale * m_z(i) * m_z(i);
    band.next(i) -= m_scale * m_z(i) * m_z((i + 1) % n);
    band.afterNext(i) -= m_scale * m_z(i) * m_z((i + 2) % n);
  }
  return band;
}

} // namespace straightedge::numerics
