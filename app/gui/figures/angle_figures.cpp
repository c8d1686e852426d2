#include "app/gui/figures/angle_figures.h"

#include "app/gui/figures/comparison_figures.h"
#include "app/gui/figures/curve_figures.h"
#include "app/gui/figures/figure_parts.h"
#include "app/gui/figures/model_figures.h"
#include "app/gui/figures/sweep_figures.h"
#include "app/gui/figures/verification_figures.h"

#include <algorithm>

namespace straightedge::gui {

namespace {

void add(QList<NamedFigure>& figures, const char* stem, FigureTopic topic, const QString& caption, PlotSpec spec) {
  if (!spec.series.isEmpty()) {
    figures.append({QString::fromLatin1(stem), topic, caption, std::move(spec)});
  }
}

void addData(QList<NamedFigure>& figures, const AngleResults& results) {
  constexpr FigureTopic topic = FigureTopic::Data;
  if (results.sweep && results.sweep->size() > 0) {
    add(figures, "sensor-over-encoder", topic, QStringLiteral("Sensor angle over encoder angle as recorded."),
        sensorOverEncoderFigure(*results.sweep).spec);
    add(figures, "error-over-encoder", topic, QStringLiteral("Angle error, sensor minus encoder, before correction."),
        errorFigure(*results.sweep, results.calibration.direction, ErrorAxis::Encoder, ConstantPart::Kept).spec);
    add(figures, "error-over-sensor", topic,
        QStringLiteral("The same error over the sensor angle, which is what firmware knows."),
        errorFigure(*results.sweep, results.calibration.direction, ErrorAxis::Sensor, ConstantPart::Kept).spec);
  }
  if (results.run) {
    add(figures, "sensor-unwrapped", topic,
        QStringLiteral("Sensor angle with the wrap-around removed: one continuous turn."),
        unwrappedFigure(results.run->aligned).spec);
    add(figures, "noise", topic, QStringLiteral("Spread of the readings."),
        noiseHistogramFigure(results.run->aligned, &results.run->curve));
  }
  add(figures, "hysteresis", topic, QStringLiteral("Difference between rising and falling passes."),
      hysteresisFigure(results.calibration.passes));
}

void addCurve(QList<NamedFigure>& figures, const AngleResults& results) {
  constexpr FigureTopic topic = FigureTopic::Curve;
  if (!results.run) {
    return;
  }
  const angle::AlignedSweep& aligned = results.run->aligned;
  const angle::CorrectionCurve& curve = results.run->curve;
  add(figures, "projection", topic, QStringLiteral("Encoder angle found for every angle of the sensor's regular grid."),
      projectionFigure(aligned, curve));
  add(figures, "correction-curve", topic,
      QStringLiteral("Correction curve: what has to be added to a reading, over one turn of the sensor."),
      correctionCurveFigure(aligned, curve));
  add(figures, "correction-curve-repeated", topic,
      QStringLiteral("The curve over three turns with its three largest harmonics."),
      repeatedCurveFigure(curve, aligned.direction));
  const std::vector<angle::HarmonicTerm> harmonics = curveHarmonics(curve);
  add(figures, "harmonic-amplitudes", topic, QStringLiteral("Amplitudes of the curve's harmonics."),
      harmonicAmplitudesFigure(harmonics));
  add(figures, "harmonic-phases", topic, QStringLiteral("Phases of the curve's harmonics."),
      harmonicPhasesFigure(harmonics));
}

/// Without the curve, the harmonics that a harmonic model keeps are still worth a picture.
void addStoredHarmonics(QList<NamedFigure>& figures, const AngleResults& results) {
  for (const angle::Model& model : results.calibration.models) {
    const auto* harmonic = std::get_if<angle::HarmonicModel>(&model.body);
    if (harmonic == nullptr || harmonic->terms.empty()) {
      continue;
    }
    std::vector<angle::HarmonicTerm> terms = harmonic->terms;
    std::ranges::sort(terms, {}, &angle::HarmonicTerm::order);
    add(figures, "harmonic-amplitudes", FigureTopic::Curve,
        QStringLiteral("Amplitudes of the harmonics of model %1.").arg(modelNameText(model.name)),
        harmonicAmplitudesFigure(terms));
    add(figures, "harmonic-phases", FigureTopic::Curve,
        QStringLiteral("Phases of the harmonics of model %1.").arg(modelNameText(model.name)),
        harmonicPhasesFigure(terms));
    return;
  }
}

void addModels(QList<NamedFigure>& figures, const AngleResults& results) {
  constexpr FigureTopic topic = FigureTopic::Models;
  const angle::AngleCalibration& calibration = results.calibration;
  const angle::AlignedSweep* aligned = results.run ? &results.run->aligned : nullptr;
  const angle::CorrectionCurve* curve = results.run ? &results.run->curve : nullptr;
  add(figures, "models", topic,
      curve != nullptr ? QStringLiteral("Correction curve with all chosen models over it.")
                       : QStringLiteral("Corrections of all models."),
      curveWithModelsFigure(calibration.models, aligned, curve, calibration.direction));
  if (curve == nullptr) {
    return;
  }
  add(figures, "residual", topic, QStringLiteral("Residual of every model against the curve."),
      residualFigure(calibration.models, *curve, calibration.direction));
  add(figures, "residual-at-points", topic, QStringLiteral("Error that remains at the recorded points."),
      pointResidualFigure(calibration.models, *aligned));
  add(figures, "growing-harmonics", topic,
      QStringLiteral("Error that remains at the recorded points with a growing number of harmonics."),
      growingFamilyFigure(GrowingFamily::Harmonics, *aligned, *curve));
  add(figures, "linear-methods", topic,
      QStringLiteral("Linear interpolation with values on the curve, by least squares and for the smallest maximum "
                     "error."),
      linearMethodsFigure(*curve, segmentsShown(calibration), calibration.direction));
  add(figures, "growing-segments", topic,
      QStringLiteral("Error that remains at the recorded points with a growing number of segments."),
      growingFamilyFigure(GrowingFamily::Segments, *aligned, *curve));
  add(figures, "table-steps", topic, QStringLiteral("Lookup table as steps over the correction curve."),
      tableStepsFigure(*curve, entriesShown(calibration), calibration.direction));
  add(figures, "growing-entries", topic,
      QStringLiteral("Error that remains at the recorded points with a growing number of table entries."),
      growingFamilyFigure(GrowingFamily::TableEntries, *aligned, *curve));
}

void addComparison(QList<NamedFigure>& figures, const AngleResults& results) {
  if (!results.comparison || results.comparison->rows.empty()) {
    return;
  }
  ComparisonFigureOptions options{.selected = results.selected,
                                  .targetErrorDeg = results.targetErrorDeg,
                                  .budgetEntries = results.budgetEntries,
                                  .leaveOneOutDeg = results.calibration.leaveOneOutRmsDeg,
                                  .bits = results.bits};
  add(figures, "comparison-maximum", FigureTopic::Comparison,
      QStringLiteral("Maximum residual error of every method and size over its storage."),
      comparisonFigure(*results.comparison, options).spec);
  options.error = ErrorMeasure::Rms;
  add(figures, "comparison-rms", FigureTopic::Comparison,
      QStringLiteral("Root mean square residual error over storage."),
      comparisonFigure(*results.comparison, options).spec);
}

void addVerification(QList<NamedFigure>& figures, const AngleResults& results) {
  if (!results.verification) {
    return;
  }
  add(figures, "verification-before-after", FigureTopic::Verification,
      QStringLiteral("Error of a fresh sweep before and after correction."), beforeAfterFigure(*results.verification));
  add(figures, "verification", FigureTopic::Verification,
      QStringLiteral("Error of the fresh sweep after correction, against the limit."),
      correctedErrorFigure(*results.verification));
}

int firstSize(const angle::AngleCalibration& calibration, angle::ModelKind kind, int otherwise) {
  const auto model =
      std::ranges::find_if(calibration.models, [kind](const angle::Model& each) { return each.name.kind == kind; });
  return model == calibration.models.end() ? otherwise : model->name.size;
}

} // namespace

int segmentsShown(const angle::AngleCalibration& calibration) {
  return firstSize(calibration, angle::ModelKind::Linear, 32);
}

int entriesShown(const angle::AngleCalibration& calibration) {
  return firstSize(calibration, angle::ModelKind::LookupTable, 64);
}

QList<NamedFigure> angleFigures(const AngleResults& results) {
  QList<NamedFigure> figures;
  addData(figures, results);
  if (results.run) {
    addCurve(figures, results);
  } else {
    addStoredHarmonics(figures, results);
  }
  addModels(figures, results);
  addComparison(figures, results);
  addVerification(figures, results);
  return figures;
}

} // namespace straightedge::gui
