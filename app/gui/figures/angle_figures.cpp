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

using Results = std::shared_ptr<const AngleResults>;

/// `make` gets the results back, so that every plot keeps them alive.
template <typename Make>
void add(QList<NamedFigure>& figures, const Results& results, const char* stem, FigureTopic topic,
         const QString& caption, Make make) {
  figures.append(
      {QString::fromLatin1(stem), topic, caption, [results, make = std::move(make)] { return make(*results); }});
}

void addData(QList<NamedFigure>& figures, const Results& results) {
  constexpr FigureTopic topic = FigureTopic::Data;
  if (results->sweep && results->sweep->size() > 0) {
    add(figures, results, "sensor-over-encoder", topic, QStringLiteral("Sensor angle over encoder angle as recorded."),
        [](const AngleResults& r) { return sensorOverEncoderFigure(*r.sweep).spec; });
    add(figures, results, "error-over-encoder", topic,
        QStringLiteral("Angle error, sensor minus encoder, before correction."), [](const AngleResults& r) {
          return errorFigure(*r.sweep, r.calibration.direction, ErrorAxis::Encoder, ConstantPart::Kept).spec;
        });
    add(figures, results, "error-over-sensor", topic,
        QStringLiteral("The same error over the sensor angle, which is what firmware knows."),
        [](const AngleResults& r) {
          return errorFigure(*r.sweep, r.calibration.direction, ErrorAxis::Sensor, ConstantPart::Kept).spec;
        });
  }
  if (results->run) {
    add(figures, results, "sensor-unwrapped", topic,
        QStringLiteral("Sensor angle with the wrap-around removed: one continuous turn."),
        [](const AngleResults& r) { return unwrappedFigure(r.run->aligned).spec; });
    if (results->calibration.passes.noiseDeg || results->calibration.curveMethod == angle::CurveMethod::Regress) {
      add(figures, results, "noise", topic, QStringLiteral("Spread of the readings."),
          [](const AngleResults& r) { return noiseHistogramFigure(r.run->aligned, &r.run->curve); });
    }
  }
  if (!results->calibration.passes.hysteresisDeg.empty()) {
    add(figures, results, "hysteresis", topic, QStringLiteral("Difference between rising and falling passes."),
        [](const AngleResults& r) { return hysteresisFigure(r.calibration.passes); });
  }
}

void addCurve(QList<NamedFigure>& figures, const Results& results) {
  constexpr FigureTopic topic = FigureTopic::Curve;
  add(figures, results, "projection", topic,
      QStringLiteral("Encoder angle found for every angle of the sensor's regular grid."),
      [](const AngleResults& r) { return projectionFigure(r.run->aligned, r.run->curve); });
  add(figures, results, "correction-curve", topic,
      QStringLiteral("Correction curve: what has to be added to a reading, over one turn of the sensor."),
      [](const AngleResults& r) { return correctionCurveFigure(r.run->aligned, r.run->curve); });
  add(figures, results, "correction-curve-repeated", topic,
      QStringLiteral("The curve over three turns with its three largest harmonics."),
      [](const AngleResults& r) { return repeatedCurveFigure(r.run->curve, r.run->aligned.direction); });
  add(figures, results, "harmonic-amplitudes", topic, QStringLiteral("Amplitudes of the curve's harmonics."),
      [](const AngleResults& r) { return harmonicAmplitudesFigure(curveHarmonics(r.run->curve)); });
  add(figures, results, "harmonic-phases", topic, QStringLiteral("Phases of the curve's harmonics."),
      [](const AngleResults& r) { return harmonicPhasesFigure(curveHarmonics(r.run->curve)); });
}

/// Without the curve, the harmonics that a harmonic model keeps are still worth a picture.
void addStoredHarmonics(QList<NamedFigure>& figures, const Results& results) {
  for (const angle::Model& model : results->calibration.models) {
    const auto* harmonic = std::get_if<angle::HarmonicModel>(&model.body);
    if (harmonic == nullptr || harmonic->terms.empty()) {
      continue;
    }
    std::vector<angle::HarmonicTerm> terms = harmonic->terms;
    std::ranges::sort(terms, {}, &angle::HarmonicTerm::order);
    add(figures, results, "harmonic-amplitudes", FigureTopic::Curve,
        QStringLiteral("Amplitudes of the harmonics of model %1.").arg(modelNameText(model.name)),
        [terms](const AngleResults&) { return harmonicAmplitudesFigure(terms); });
    add(figures, results, "harmonic-phases", FigureTopic::Curve,
        QStringLiteral("Phases of the harmonics of model %1.").arg(modelNameText(model.name)),
        [terms](const AngleResults&) { return harmonicPhasesFigure(terms); });
    return;
  }
}

void addGrowingFamily(QList<NamedFigure>& figures, const Results& results, const char* stem, GrowingFamily family,
                      const QString& of) {
  add(figures, results, stem, FigureTopic::Models,
      QStringLiteral("Error that remains at the recorded points with a growing number of %1.").arg(of),
      [family](const AngleResults& r) { return growingFamilyFigure(family, r.run->aligned, r.run->curve); });
}

void addModels(QList<NamedFigure>& figures, const Results& results) {
  constexpr FigureTopic topic = FigureTopic::Models;
  add(figures, results, "models", topic,
      results->run ? QStringLiteral("Correction curve with all chosen models over it.")
                   : QStringLiteral("Corrections of all models."),
      [](const AngleResults& r) {
        return curveWithModelsFigure(r.calibration.models, r.run ? &r.run->aligned : nullptr,
                                     r.run ? &r.run->curve : nullptr, r.calibration.direction);
      });
  if (!results->run) {
    return;
  }
  add(figures, results, "residual", topic, QStringLiteral("Residual of every model against the curve."),
      [](const AngleResults& r) {
        return residualFigure(r.calibration.models, r.run->curve, r.calibration.direction);
      });
  add(figures, results, "residual-at-points", topic, QStringLiteral("Error that remains at the recorded points."),
      [](const AngleResults& r) { return pointResidualFigure(r.calibration.models, r.run->aligned); });
  addGrowingFamily(figures, results, "growing-harmonics", GrowingFamily::Harmonics, QStringLiteral("harmonics"));
  add(figures, results, "linear-methods", topic,
      QStringLiteral("Linear interpolation with values on the curve, by least squares and for the smallest maximum "
                     "error."),
      [](const AngleResults& r) {
        return linearMethodsFigure(r.run->curve, segmentsShown(r.calibration), r.calibration.direction);
      });
  addGrowingFamily(figures, results, "growing-segments", GrowingFamily::Segments, QStringLiteral("segments"));
  add(figures, results, "table-steps", topic, QStringLiteral("Lookup table as steps over the correction curve."),
      [](const AngleResults& r) {
        return tableStepsFigure(r.run->curve, entriesShown(r.calibration), r.calibration.direction);
      });
  addGrowingFamily(figures, results, "growing-entries", GrowingFamily::TableEntries, QStringLiteral("table entries"));
}

PlotSpec comparisonSpec(const AngleResults& results, ErrorMeasure measure) {
  const bool maximum = measure == ErrorMeasure::Maximum;
  std::optional<double> leaveOneOut;
  if (results.run) {
    leaveOneOut = maximum ? results.calibration.leaveOneOutMaxDeg : results.calibration.leaveOneOutRmsDeg;
  }
  return comparisonFigure(*results.comparison,
                          {.error = measure,
                           .selected = results.selected,
                           .targetErrorDeg = maximum ? results.targetErrorDeg : std::nullopt, // a demand on the maximum
                           .budgetEntries = results.budgetEntries,
                           .leaveOneOutDeg = leaveOneOut,
                           .bits = results.bits})
      .spec;
}

void addComparison(QList<NamedFigure>& figures, const Results& results) {
  if (!results->comparison || results->comparison->rows.empty()) {
    return;
  }
  add(figures, results, "comparison-maximum", FigureTopic::Comparison,
      QStringLiteral("Maximum residual error of every method and size over its storage."),
      [](const AngleResults& r) { return comparisonSpec(r, ErrorMeasure::Maximum); });
  add(figures, results, "comparison-rms", FigureTopic::Comparison,
      QStringLiteral("Root mean square residual error over storage."),
      [](const AngleResults& r) { return comparisonSpec(r, ErrorMeasure::Rms); });
}

void addVerification(QList<NamedFigure>& figures, const Results& results) {
  if (!results->verification) {
    return;
  }
  add(figures, results, "verification-before-after", FigureTopic::Verification,
      QStringLiteral("Error of a fresh sweep before and after correction."),
      [](const AngleResults& r) { return beforeAfterFigure(*r.verification); });
  add(figures, results, "verification", FigureTopic::Verification,
      QStringLiteral("Error of the fresh sweep after correction, against the limit."),
      [](const AngleResults& r) { return correctedErrorFigure(*r.verification); });
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

QList<NamedFigure> angleFigures(const std::shared_ptr<const AngleResults>& results) {
  QList<NamedFigure> figures;
  addData(figures, results);
  if (results->run) {
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
