// Symmetric positive definite systems that are tridiagonal but for the two corners: what splines on a circle lead to.
#pragma once

#include <Eigen/Core>

namespace straightedge::numerics {

/// Factors of the cyclic matrix with `diagonal` (n values) and `offDiagonal` (n values: i couples rows i and i+1, the
/// last couples row n−1 and row 0). n ≥ 3. The corners are taken out by a symmetric rank-one term (Sherman, Morrison),
/// R = T + γ·v·vᵀ, which leaves T tridiagonal and still positive definite.
class CyclicTridiagonal {
public:
  CyclicTridiagonal(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& offDiagonal);

  Eigen::VectorXd solve(const Eigen::VectorXd& rightSide) const;

  /// Entries of the inverse near its diagonal: (i,i), (i,i+1) and (i,i+2), indices cyclic; O(n) in all.
  struct InverseBand {
    Eigen::VectorXd diagonal, next, afterNext;
  };
  InverseBand inverseBand() const;

private:
  Eigen::VectorXd solveTridiagonal(Eigen::VectorXd rightSide) const;

  Eigen::VectorXd m_diagonal; ///< of T
  Eigen::VectorXd m_offDiagonal;
  Eigen::VectorXd m_pivotInverse; ///< of the LDLᵀ factors of T
  Eigen::VectorXd m_multiplier;   ///< L(i+1,i)
  double m_gamma = 0.0;
  double m_cornerRatio = 0.0; ///< last entry of v; the first is 1
  Eigen::VectorXd m_z;        ///< T⁻¹·v
  double m_scale = 0.0;       ///< γ/(1 + γ·vᵀ·z)
};

} // namespace straightedge::numerics
