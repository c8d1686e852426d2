#include "core/angle/comparison.h"

#include "core/angle/harmonic_model.h"
#include "core/angle/linear_model.h"
#include "core/angle/lookup_table_model.h"
#include "core/angle/minimax_linear.h"
#include "core/angle/model_limits.h"
#include "core/angle/quantisation.h"
#include "core/angle/residual_errors.h"

#include <algorithm>
#include <span>

namespace straightedge::angle {

namespace {

constexpr int finePast = 256; ///< sizes above this are judged on the fine grid too

/// The curve and one buffer for the model drawn over it, used again for every row.
class Judge {
public:
  Judge(const Eigen::VectorXd& curve, std::optional<int> bits) : m_curve(&curve), m_model(curve.size()), m_bits(bits) {}

  ComparisonRow row(ModelKind kind, FitMethod method, int size, const ModelBody& body) {
    ComparisonRow row;
    row.name = ModelName{kind, size, method, m_bits};
    row.storageEntries = row.name.storageEntries();
    row.bytes = row.name.storageBytes();
    const ResidualErrors errors = measure(m_bits ? quantised(body, *m_bits).second : body);
    row.maxErrorDeg = errors.maxAbs;
    row.rmsErrorDeg = errors.rms;
    return row;
  }

  ResidualErrors measure(const ModelBody& body) {
    const int count = static_cast<int>(m_model.size());
    double* const out = m_model.data();
    if (const auto* harmonics = std::get_if<HarmonicModel>(&body)) {
      evaluateHarmonics(*harmonics, out, count);
    } else if (const auto* linear = std::get_if<LinearModel>(&body)) {
      evaluateLinear({linear->valuesDeg.data(), static_cast<std::size_t>(linear->valuesDeg.size())}, out, count);
    } else {
      const Eigen::VectorXd& values = std::get<LookupTableModel>(body).valuesDeg;
      evaluateLookupTable({values.data(), static_cast<std::size_t>(values.size())}, out, count);
    }
    return residualErrors(out, m_curve->data(), static_cast<std::size_t>(count));
  }

private:
  const Eigen::VectorXd* m_curve;
  Eigen::VectorXd m_model;
  std::optional<int> m_bits;
};

void addHarmonicRows(Comparison& comparison, Judge& judge, const CorrectionCurve& curve) {
  const HarmonicSpectrum spectrum = spectrumOf(curve.gridDeg);
  const int most = std::min(curve.resolvableHarmonics, sizeRange(ModelKind::Harmonic).largest);
  const std::vector<int> orders = spectrum.ordersByAmplitude(most);
  for (int size = 0; size <= most; ++size) {
    const HarmonicModel model = harmonicModelOf(spectrum, std::span(orders).first(static_cast<std::size_t>(size)));
    comparison.rows.push_back(judge.row(ModelKind::Harmonic, FitMethod::ByAmplitude, size, model));
  }
}

void addLinearRows(Comparison& comparison, Judge& judge, const CorrectionCurve& curve, FitMethod method) {
  const SizeRange sizes = sizeRange(ModelKind::Linear);
  for (int size = sizes.smallest; size <= sizes.largest; ++size) {
    const LinearModel model{method == FitMethod::OnCurve ? curve.sampled(size)
                                                         : linearLeastSquares(curve.gridDeg, size)};
    comparison.rows.push_back(judge.row(ModelKind::Linear, method, size, model));
  }
}

void addLookupTableRows(Comparison& comparison, Judge& judge, const CorrectionCurve& curve, FitMethod method) {
  const SizeRange sizes = sizeRange(ModelKind::LookupTable);
  for (int size = sizes.smallest; size <= sizes.largest; ++size) {
    const LookupTableModel model{lookupTableValues(curve.gridDeg, size, method)};
    comparison.rows.push_back(judge.row(ModelKind::LookupTable, method, size, model));
  }
}

} // namespace

Comparison compareQuick(const CorrectionCurve& curve, const ComparisonOptions& options) {
  Comparison comparison;
  Judge judge(curve.gridDeg, options.bits);
  addHarmonicRows(comparison, judge, curve);
  addLinearRows(comparison, judge, curve, FitMethod::LeastSquares);
  addLinearRows(comparison, judge, curve, FitMethod::OnCurve);
  addLookupTableRows(comparison, judge, curve, FitMethod::Mean);
  addLookupTableRows(comparison, judge, curve, FitMethod::MidRange);
  return comparison;
}

} // namespace straightedge::angle
