#include "app/gui/steps/review_analysis.h"

#include "core/angle/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace straightedge::gui {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
// Of normally distributed residuals fewer than one in 10⁸ lies beyond six standard deviations.
constexpr double outlierSigmas = 6.0;
constexpr double madToSigma = 1.4826;
// Rounding alone must not make outliers of noise-free data.
constexpr double leastLimitDeg = 1e-6;
constexpr std::size_t reportEvery = 8192;

double readingOf(const angle::Sweep& sweep, std::size_t row, angle::SensorDirection direction) {
  return direction == angle::SensorDirection::Decreasing ? 360.0 - sweep.sensorDeg[row] : sweep.sensorDeg[row];
}

/// Value at `x` of the cubic through four points.
double lagrange(const std::array<double, 4>& xs, const std::array<double, 4>& ys, double x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    double term = ys[i];
    for (std::size_t k = 0; k < 4; ++k) {
      term *= k == i ? 1.0 : (x - xs[k]) / (xs[i] - xs[k]);
    }
    sum += term;
  }
  return sum;
}

void residualsFromNeighbours(const angle::AlignedSweep& aligned, std::vector<ReviewRow>& rows) {
  const Eigen::Index count = aligned.readingDeg.size();
  if (count < 5) {
    return;
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    std::array<double, 4> xs{};
    std::array<double, 4> ys{};
    std::size_t place = 0;
    for (const Eigen::Index step : {-2, -1, 1, 2}) {
      const Eigen::Index at = i + step;
      const double turn = at < 0 ? -360.0 : at >= count ? 360.0 : 0.0;
      const Eigen::Index wrapped = (at + count) % count;
      xs[place] = aligned.readingDeg[wrapped] + turn;
      ys[place] = aligned.correctionDeg[wrapped];
      ++place;
    }
    const double foretold = lagrange(xs, ys, aligned.readingDeg[i]);
    rows[aligned.row[static_cast<std::size_t>(i)]].residualDeg =
        std::isfinite(foretold) ? aligned.correctionDeg[i] - foretold : unknown;
  }
}

/// An outlier bends what its neighbours are foretold; only the worst of a neighbourhood is to blame.
bool worstNearby(const angle::AlignedSweep& aligned, const std::vector<ReviewRow>& rows, Eigen::Index i) {
  const Eigen::Index count = aligned.readingDeg.size();
  const auto residual = [&](Eigen::Index at) {
    return std::abs(rows[aligned.row[static_cast<std::size_t>((at + count) % count)]].residualDeg);
  };
  const double own = residual(i);
  return own >= residual(i - 1) && own >= residual(i + 1) && own >= residual(i - 2) && own >= residual(i + 2);
}

double medianOf(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void markOutliers(const angle::Sweep& sweep, const angle::AlignedSweep& aligned, ReviewAnalysis& analysis) {
  std::vector<double> sizes;
  for (const std::size_t row : aligned.row) {
    if (std::isfinite(analysis.rows[row].residualDeg)) {
      sizes.push_back(std::abs(analysis.rows[row].residualDeg));
    }
  }
  if (sizes.empty()) {
    return;
  }
  analysis.spreadDeg = madToSigma * medianOf(std::move(sizes));
  analysis.outlierLimitDeg = std::max(outlierSigmas * analysis.spreadDeg, leastLimitDeg);
  for (Eigen::Index i = 0; i < aligned.readingDeg.size(); ++i) {
    const std::size_t row = aligned.row[static_cast<std::size_t>(i)];
    ReviewRow& reviewed = analysis.rows[row];
    reviewed.outlier = sweep.isEnabled(row) && std::abs(reviewed.residualDeg) > analysis.outlierLimitDeg &&
                       (!analysis.fromNeighbours || worstNearby(aligned, analysis.rows, i));
    if (reviewed.outlier) {
      analysis.outliers.push_back(row);
    }
  }
  std::ranges::sort(analysis.outliers);
}

} // namespace

Result<ReviewAnalysis> analyseForReview(const angle::Sweep& sweep, const angle::CalibrationRun* run,
                                        const JobControl& job) {
  ReviewAnalysis analysis;
  analysis.rows.resize(sweep.size());
  const angle::SensorDirection direction = run == nullptr ? angle::SensorDirection::Increasing : run->aligned.direction;
  analysis.fromNeighbours = run != nullptr && run->curve.method == angle::CurveMethod::Interpolate;
  for (std::size_t row = 0; row < sweep.size(); ++row) {
    if (row % reportEvery == 0) {
      if (job.stopRequested()) {
        return fail(ErrorKind::Cancelled, "the review was cancelled", "");
      }
      job.report(static_cast<double>(row) / static_cast<double>(sweep.size()));
    }
    const double reading = readingOf(sweep, row, direction);
    ReviewRow& reviewed = analysis.rows[row];
    reviewed.errorDeg = angle::wrap180(reading - sweep.encoderDeg[row]);
    // Rows that are switched off are compared with the curve of the others in either case.
    const bool aboutCurve = run != nullptr && (!analysis.fromNeighbours || !sweep.isEnabled(row));
    reviewed.residualDeg =
        aboutCurve ? angle::wrap180(-reviewed.errorDeg - run->curve.at(angle::wrap360(reading))) : unknown;
  }
  const bool aligned =
      run != nullptr && std::ranges::all_of(run->aligned.row, [&sweep](std::size_t row) { return row < sweep.size(); });
  if (aligned && analysis.fromNeighbours) {
    residualsFromNeighbours(run->aligned, analysis.rows);
  }
  if (aligned) {
    markOutliers(sweep, run->aligned, analysis);
  }
  return analysis;
}

} // namespace straightedge::gui
