#include "core/field/joint_fit.h"

#include "core/base/number_text.h"
#include "core/field/closest_fit.h"
#include "core/field/joint_weights.h"
#include "core/field/names.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::field {

namespace {

/// One axis's problem: residuals and derivatives of the weighted points at given unknowns.
class AxisProblem {
public:
  AxisProblem(const std::vector<FitPoint>& points, AxisChain start, const Eigen::RowVector3d& rowOfS,
              const Eigen::VectorXd& weights, bool holdRow = false)
      : m_points(points), m_chain(std::move(start)), m_parameters(independentParameters(m_chain)), m_rowOfS(rowOfS),
        m_rootWeights(weights.cwiseSqrt()),
        m_fitsRow(!holdRow && std::any_of(points.begin(), points.end(), [](const FitPoint& point) {
          return point.step == CampaignStep::Orientation;
        })) {}

  Eigen::Index unknowns() const { return static_cast<Eigen::Index>(m_parameters.size()) + (m_fitsRow ? 3 : 0); }
  Eigen::Index points() const { return static_cast<Eigen::Index>(m_points.size()); }
  const std::vector<ChainParameter>& parameters() const { return m_parameters; }
  bool fitsRow() const { return m_fitsRow; }
  const Eigen::VectorXd& rootWeights() const { return m_rootWeights; }
  const AxisChain& chain() const { return m_chain; }
  const Eigen::RowVector3d& rowOfS() const { return m_rowOfS; }

  Eigen::VectorXd values() const;
  void set(const Eigen::VectorXd& values);
  /// Not weighted, tesla; `jacobian` too.
  void evaluate(Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) const;

private:
  const std::vector<FitPoint>& m_points;
  AxisChain m_chain;
  std::vector<ChainParameter> m_parameters;
  Eigen::RowVector3d m_rowOfS;
  Eigen::VectorXd m_rootWeights;
  bool m_fitsRow;
};

Eigen::VectorXd AxisProblem::values() const {
  Eigen::VectorXd values(unknowns());
  AxisChain chain = m_chain;
  for (std::size_t i = 0; i < m_parameters.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] = valueOf(chain, m_parameters[i]);
  }
  if (m_fitsRow) {
    values.tail<3>() = m_rowOfS.transpose();
  }
  return values;
}

void AxisProblem::set(const Eigen::VectorXd& values) {
  for (std::size_t i = 0; i < m_parameters.size(); ++i) {
    valueOf(m_chain, m_parameters[i]) = values[static_cast<Eigen::Index>(i)];
  }
  if (m_fitsRow) {
    m_rowOfS = values.tail<3>().transpose();
  }
}

void AxisProblem::evaluate(Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) const {
  residuals.resize(points());
  jacobian.setZero(points(), unknowns());
  const auto count = static_cast<Eigen::Index>(m_parameters.size());
  Eigen::VectorXd by(count);
  for (Eigen::Index i = 0; i < points(); ++i) {
    const FitPoint& point = m_points[static_cast<std::size_t>(i)];
    const AxisGradient gradient = axisGradient(m_chain, m_parameters, point.rawT, point.probeC, point.electronicsC, by);
    residuals[i] = gradient.valueT - point.targetT - m_rowOfS.dot(point.fieldT);
    jacobian.row(i).head(count) = by.transpose();
    if (m_fitsRow) {
      jacobian.row(i).tail<3>() = -point.fieldT.transpose();
    }
  }
}

struct Outcome {
  int iterations = 0;
  bool converged = false;
};

double costOf(const Eigen::VectorXd& residuals, const Eigen::VectorXd& rootWeights) {
  return residuals.cwiseProduct(rootWeights).norm() / rootWeights.norm();
}

/// Levenberg and Marquardt, damping relative to the columns' lengths.
Outcome minimise(AxisProblem& problem, int mostIterations) {
  constexpr double enough = 1e-10;      // of a column's share of the residuals, relative to the unknown
  constexpr double leastDamping = 1e-9; // the problem is nearly linear: the first step nearly hits
  Outcome outcome;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  problem.evaluate(residuals, jacobian);
  double damping = leastDamping;
  double cost = costOf(residuals, problem.rootWeights());
  const Eigen::Index unknowns = problem.unknowns();
  Eigen::MatrixXd system(problem.points() + unknowns, unknowns);
  Eigen::VectorXd right(problem.points() + unknowns);
  while (outcome.iterations < mostIterations && !outcome.converged) {
    ++outcome.iterations;
    system.topRows(problem.points()) = problem.rootWeights().asDiagonal() * jacobian;
    Eigen::VectorXd lengths = system.topRows(problem.points()).colwise().norm();
    lengths = (lengths.array() > 0.0).select(lengths, 1.0);
    system.topRows(problem.points()) *= lengths.cwiseInverse().asDiagonal();
    right.head(problem.points()) = -problem.rootWeights().cwiseProduct(residuals);
    right.tail(unknowns).setZero();
    const Eigen::VectorXd before = problem.values();
    while (true) {
      system.bottomRows(unknowns) = Eigen::MatrixXd::Identity(unknowns, unknowns) * std::sqrt(damping);
      const Eigen::VectorXd step = system.householderQr().solve(right);
      problem.set(before + step.cwiseQuotient(lengths));
      problem.evaluate(residuals, jacobian);
      const double stepped = costOf(residuals, problem.rootWeights());
      const bool small = step.norm() <= enough * before.cwiseProduct(lengths).norm();
      if (stepped <= cost || small) {
        outcome.converged = small || cost - stepped <= enough * cost;
        cost = std::min(cost, stepped);
        damping = std::max(leastDamping, 0.1 * damping);
        break;
      }
      damping *= 10.0;
      if (!(damping < 1e6)) { // no step makes it better: not converged, and the report says so
        problem.set(before);
        return outcome;
      }
    }
  }
  return outcome;
}

/// Of the unknowns from the noise of the points; nothing where the points do not determine them.
bool findCovariance(const AxisProblem& problem, const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& variances,
                    Eigen::MatrixXd& covariance) {
  Eigen::MatrixXd scaled = problem.rootWeights().asDiagonal() * jacobian;
  const Eigen::VectorXd lengths = scaled.colwise().norm();
  if (!(lengths.minCoeff() > 0.0)) {
    return false;
  }
  scaled *= lengths.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> decomposition(scaled);
  const Eigen::Index n = problem.unknowns();
  const Eigen::VectorXd diagonal = decomposition.matrixQR().diagonal().cwiseAbs();
  constexpr double undetermined = 1e-12;
  if (!(diagonal.minCoeff() > undetermined * diagonal.maxCoeff())) {
    return false;
  }
  const Eigen::MatrixXd q = decomposition.householderQ() * Eigen::MatrixXd::Identity(problem.points(), n);
  Eigen::MatrixXd influence = q.transpose();
  decomposition.matrixQR().topRows(n).triangularView<Eigen::Upper>().solveInPlace(influence);
  influence = lengths.cwiseInverse().asDiagonal() * influence;
  const Eigen::VectorXd weighted = problem.rootWeights().cwiseAbs2().cwiseProduct(variances);
  covariance = influence * weighted.asDiagonal() * influence.transpose();
  return true;
}

Result<void> fitAxis(const std::vector<FitPoint>& points, std::size_t axis, const JointOptions& options,
                     const std::string& name, CorrectionChain& chain, JointAxisReport& report) {
  const RowNoise noise = rowNoise(points, axis);
  const Eigen::VectorXd weights =
      options.weights == JointWeights::EvenError ? evenErrorWeights(points) : noiseWeights(points, axis, noise);
  const auto row = static_cast<Eigen::Index>(axis);
  const Eigen::Matrix3d s = chain.axisMatrix.value_or(Eigen::Matrix3d::Identity());
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  if (!points.empty()) {
    AxisProblem(points, chain.axes[axis], s.row(row), weights).evaluate(residuals, jacobian);
    report.costBefore = costOf(residuals, weights.cwiseSqrt());
    report.peakBeforeT = residuals.cwiseAbs().maxCoeff();
  }
  AxisProblem problem(points, inIndependentParameters(chain.axes[axis]), s.row(row), weights, options.holdAxisMatrix);
  const std::string who = "axis " + std::string(axisName(allAxes[axis]));
  if (problem.points() <= problem.unknowns()) {
    return fail(ErrorKind::Input,
                who + " has " + std::to_string(problem.points()) + " points for the " +
                    std::to_string(problem.unknowns()) + " coefficients of a joint fit",
                "record more fields and temperatures, or fit step by step", name);
  }
  const Outcome outcome = minimise(problem, options.mostIterations);
  problem.evaluate(residuals, jacobian);
  Eigen::VectorXd variances(problem.points());
  for (std::size_t i = 0; i < points.size(); ++i) {
    variances[static_cast<Eigen::Index>(i)] =
        noise.varianceT2(ownFieldT(points[i], axis)) / static_cast<double>(points[i].rows);
    report.rows += points[i].rows;
  }
  if (!residuals.allFinite() || !findCovariance(problem, jacobian, variances, report.covariance)) {
    return fail(ErrorKind::Input, "the rows of " + who + " do not determine all coefficients of the chain together",
                "record more fields and temperatures, or fit step by step", name);
  }
  report.parameters = problem.parameters();
  report.fitsAxisRow = problem.fitsRow();
  report.values = problem.values();
  report.noiseT = noise.constantT;
  report.noisePerTesla = noise.perTesla;
  report.iterations = outcome.iterations;
  report.converged = outcome.converged;
  report.costAfter = costOf(residuals, problem.rootWeights());
  report.peakAfterT = residuals.cwiseAbs().maxCoeff();
  report.points = points.size();
  if (variances.minCoeff() > 0.0) {
    const auto freedom = static_cast<double>(problem.points() - problem.unknowns());
    report.excess = std::sqrt((residuals.array().square() / variances.array()).sum() / freedom);
    if (report.excess * report.excess > 1.0 + 3.0 * std::sqrt(2.0 / freedom)) {
      report.restT = std::sqrt(std::max(0.0, residuals.squaredNorm() / freedom - variances.mean()));
    }
  }
  chain.axes[axis] = problem.chain();
  if (problem.fitsRow()) {
    chain.axisMatrix = s;
    chain.axisMatrix->row(row) = problem.rowOfS();
  }
  return {};
}

} // namespace

Result<JointReport> fitJointly(const FitPoints& points, const CorrectionChain& start, const JointOptions& options,
                               const std::string& name) {
  JointReport report;
  report.chain = start;
  std::size_t count = 0;
  std::size_t rows = 0;
  for (std::size_t axis = 0; axis < report.axes.size(); ++axis) {
    if (start.axes[axis].nonlinearity.empty()) {
      return fail(ErrorKind::Input,
                  "the nonlinearity of axis " + std::string(axisName(allAxes[axis])) +
                      " is off, and all blocks together rest on it",
                  "record the step nonlinearity for every axis, or fit step by step", name);
    }
    if (auto done = fitAxis(points.axes[axis], axis, options, name, report.chain, report.axes[axis]); !done) {
      return std::unexpected(std::move(done.error()));
    }
    count += report.axes[axis].points;
    rows += report.axes[axis].rows;
  }
  report.how = "all blocks of an axis together by nonlinear least squares over " + std::to_string(rows) +
               " readings in " + std::to_string(count) + " points";
  return report;
}

Result<JointReport> fitJointly(const CampaignParts& parts, const CorrectionChain& start, const JointOptions& options,
                               const std::string& name) {
  const FitPoints points = fitPoints(parts, start);
  CorrectionChain better = start;
  JointOptions chosen = options;
  if (options.weights == JointWeights::EvenError && start.axisMatrix && !options.holdAxisMatrix) {
    // Too few data for it: S is fitted with the rest, as well as it goes.
    if (const auto closest = fitClosely(points, start, name)) {
      better.axisMatrix = closest->chain.axisMatrix;
      chosen.holdAxisMatrix = true;
    }
  }
  return fitJointly(points, better, chosen, name);
}

} // namespace straightedge::field
