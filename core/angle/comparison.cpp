#include "core/angle/comparison.h"

#include "core/angle/harmonic_model.h"
#include "core/angle/linear_model.h"
#include "core/angle/lookup_table_model.h"
#include "core/angle/minimax_linear.h"
#include "core/angle/model_limits.h"
#include "core/angle/quantisation.h"
#include "core/angle/residual_errors.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

namespace straightedge::angle {

namespace {

constexpr int finePast = 256; ///< sizes above this are judged on the fine grid too

std::span<const double> spanOf(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// A sampled curve and one buffer for the models drawn over it, used again for every row.
class Judge {
public:
  explicit Judge(Eigen::VectorXd curve) : m_curve(std::move(curve)), m_model(m_curve.size()) {}

  ResidualErrors measure(const ModelBody& body) {
    const int count = static_cast<int>(m_model.size());
    if (const auto* harmonics = std::get_if<HarmonicModel>(&body)) {
      evaluateHarmonics(*harmonics, m_model.data(), count);
    } else if (const auto* linear = std::get_if<LinearModel>(&body)) {
      evaluateLinear(spanOf(linear->valuesDeg), m_model.data(), count);
    } else {
      evaluateLookupTable(spanOf(std::get<LookupTableModel>(body).valuesDeg), m_model.data(), count);
    }
    return residualErrors(m_model.data(), m_curve.data(), static_cast<std::size_t>(count));
  }

private:
  Eigen::VectorXd m_curve;
  Eigen::VectorXd m_model;
};

std::vector<int> minimaxSizes() {
  std::vector<int> sizes;
  const SizeRange range = sizeRange(ModelKind::Linear);
  for (int size = range.smallest; size <= range.largest; size = size < 64 ? size + 1 : 2 * size) {
    sizes.push_back(size);
  }
  return sizes;
}

/// Fills a comparison row by row. With a job it judges large sizes on the fine grid too, reports and can be stopped.
class Comparing {
public:
  Comparing(const CorrectionCurve& curve, const ComparisonOptions& options)
      : m_curve(&curve), m_bits(options.bits), m_coarse(curve.gridDeg) {
    assert(!m_bits || (*m_bits >= smallestBits && *m_bits <= largestBits));
  }

  void judgeFinely(const JobControl& job) {
    m_job = &job;
    m_fine.emplace(m_curve->sampled(fineGridSize));
  }

  void addHarmonics() {
    const int most = std::min(m_curve->resolvableHarmonics, sizeRange(ModelKind::Harmonic).largest);
    const HarmonicSpectrum spectrum = spectrumOf(m_curve->gridDeg, most);
    const std::vector<int> orders = spectrum.ordersByAmplitude(most);
    for (int size = 0; size <= most && !stopped(); ++size) {
      add({ModelKind::Harmonic, size, FitMethod::ByAmplitude, m_bits},
          harmonicModelOf(spectrum, std::span(orders).first(static_cast<std::size_t>(size))));
    }
  }

  void addEverySize(ModelKind kind, FitMethod method) {
    const SizeRange sizes = sizeRange(kind);
    for (int size = sizes.smallest; size <= sizes.largest && !stopped(); ++size) {
      add({kind, size, method, m_bits}, fit(method, size));
    }
  }

  void addMinimax() {
    for (const int size : minimaxSizes()) {
      auto fitted = linearMinimax(m_curve->gridDeg, size, *m_job);
      if (!fitted) {
        return; // stopped: the caller asks the job
      }
      add({ModelKind::Linear, size, FitMethod::Minimax, m_bits}, LinearModel{std::move(fitted->valuesDeg)});
    }
  }

  Comparison take() { return std::move(m_comparison); }

private:
  bool stopped() const { return m_job != nullptr && m_job->stopRequested(); }

  ModelBody fit(FitMethod method, int size) const {
    switch (method) {
    case FitMethod::LeastSquares:
      return LinearModel{linearLeastSquares(m_curve->gridDeg, size)};
    case FitMethod::OnCurve:
      return LinearModel{m_curve->sampled(size)};
    default:
      return LookupTableModel{lookupTableValues(m_curve->gridDeg, size, method)};
    }
  }

  void add(const ModelName& name, const ModelBody& fitted) {
    const ModelBody body = m_bits ? quantised(fitted, *m_bits).second : fitted;
    const ResidualErrors errors = m_coarse.measure(body);
    ComparisonRow row{name, name.storageEntries(), name.storageBytes(), errors.maxAbs, errors.rms, {}};
    if (m_fine && name.size > finePast) {
      row.maxErrorFineDeg = m_fine->measure(body).maxAbs;
    }
    m_comparison.rows.push_back(row);
    if (m_job != nullptr && m_comparison.rows.size() % rowsPerReport == 0) {
      m_job->report(std::min(1.0, static_cast<double>(m_comparison.rows.size()) / rowsExpected));
    }
  }

  static constexpr std::size_t rowsPerReport = 32;
  static constexpr double rowsExpected = 4.0 * 1023 + 65 + 67; ///< fewer where the points resolve fewer harmonics

  const CorrectionCurve* m_curve;
  std::optional<int> m_bits;
  Judge m_coarse;
  std::optional<Judge> m_fine;
  const JobControl* m_job = nullptr;
  Comparison m_comparison;
};

} // namespace

Comparison compareQuick(const CorrectionCurve& curve, const ComparisonOptions& options) {
  Comparing comparing(curve, options);
  comparing.addHarmonics();
  comparing.addEverySize(ModelKind::Linear, FitMethod::LeastSquares);
  comparing.addEverySize(ModelKind::Linear, FitMethod::OnCurve);
  comparing.addEverySize(ModelKind::LookupTable, FitMethod::Mean);
  comparing.addEverySize(ModelKind::LookupTable, FitMethod::MidRange);
  return comparing.take();
}

Result<Comparison> compareFully(const CorrectionCurve& curve, const ComparisonOptions& options, const JobControl& job) {
  Comparing comparing(curve, options);
  comparing.judgeFinely(job);
  comparing.addHarmonics();
  comparing.addEverySize(ModelKind::Linear, FitMethod::LeastSquares);
  comparing.addEverySize(ModelKind::Linear, FitMethod::OnCurve);
  comparing.addMinimax();
  comparing.addEverySize(ModelKind::LookupTable, FitMethod::Mean);
  comparing.addEverySize(ModelKind::LookupTable, FitMethod::MidRange);
  if (job.stopRequested()) {
    return fail(ErrorKind::Cancelled, "the comparison was stopped", "");
  }
  job.report(1.0);
  return comparing.take();
}

} // namespace straightedge::angle
