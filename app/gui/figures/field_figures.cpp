#include "app/gui/figures/field_figures.h"

#include "app/gui/figures/field_axis_figures.h"
#include "app/gui/figures/field_campaign_figures.h"
#include "app/gui/figures/field_cost_figures.h"
#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/field_nonlinearity_figures.h"
#include "app/gui/figures/field_scene_figures.h"
#include "app/gui/figures/field_sensitivity_figures.h"
#include "app/gui/figures/field_surface_figures.h"
#include "app/gui/figures/field_temperature_figures.h"
#include "app/gui/figures/field_verification_figures.h"
#include "app/gui/figures/field_words.h"
#include "core/field/names.h"

#include <algorithm>
#include <array>

namespace straightedge::gui {

namespace {

using SharedFieldResults = std::shared_ptr<const FieldResults>;

/// Collects figures; every plot keeps the results alive.
class FieldFigureList {
public:
  explicit FieldFigureList(SharedFieldResults results) : m_results(std::move(results)) {}

  template <typename Make>
  void add(const QString& stem, FigureTopic topic, const QString& caption, Make make) {
    figures.append(
        {stem, topic, caption, [results = m_results, make = std::move(make)] { return make(*results); }, {}});
  }
  template <typename Make>
  void addScene(const QString& stem, FigureTopic topic, const QString& caption, Make make) {
    figures.append({stem, topic, caption, {}, [results = m_results, make = std::move(make)]() -> SceneSpec {
                      return make(*results);
                    }});
  }
  const FieldResults& results() const { return *m_results; }

  QList<NamedFigure> figures;

private:
  SharedFieldResults m_results;
};

QString ofAxis(const char* stem, field::Axis axis) {
  return QString::fromLatin1(stem) + QLatin1Char('-') + axisLetter(axis);
}

void addCampaign(FieldFigureList& list) {
  if (!list.results().campaign) {
    return;
  }
  for (const field::CampaignStep step : field::allSteps) {
    if (std::ranges::none_of(list.results().campaign->rows,
                             [step](const field::CampaignRow& row) { return row.step == step; })) {
      continue;
    }
    const std::string_view name = field::stepName(step);
    list.add(QStringLiteral("campaign-") + QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())),
             FigureTopic::Data, QStringLiteral("%1: readings in the order they were recorded.").arg(stepTitle(step)),
             [step](const FieldResults& r) { return campaignStepFigure(*r.campaign, step).spec; });
  }
}

void addNonlinearity(FieldFigureList& list) {
  constexpr FigureTopic topic = FigureTopic::Nonlinearity;
  if (!list.results().calibration.orders.empty()) {
    list.add(QStringLiteral("nonlinearity-orders"), topic,
             QStringLiteral("Largest error of each order of the polynomial; dashed, what a fit to the other plateaus "
                            "foretells for each plateau."),
             [](const FieldResults& r) { return largestErrorsFigure(r.calibration.orders, r.calibration.order); });
  }
  if (!list.results().run) {
    return;
  }
  for (const field::Axis axis : field::allAxes) {
    const std::size_t place = field::indexOf(axis);
    if (!list.results().run->reports.nonlinearity.at(place)) {
      continue;
    }
    list.add(ofAxis("nonlinearity-residuals", axis), topic,
             QStringLiteral("Axis %1: what polynomials of each order leave at the plateaus.").arg(axisLetter(axis)),
             [place](const FieldResults& r) { return orderResidualsFigure(*r.run->reports.nonlinearity.at(place)); });
    list.add(ofAxis("nonlinearity-fit", axis), topic,
             QStringLiteral("Axis %1: plateau means with the polynomial through them.").arg(axisLetter(axis)),
             [place](const FieldResults& r) { return plateauFitFigure(*r.run->reports.nonlinearity.at(place)); });
  }
}

template <typename Reports>
bool someAxis(const Reports& reports) {
  return std::ranges::any_of(reports, [](const auto& report) { return report.has_value(); });
}

void addProbeAndOffset(FieldFigureList& list) {
  const field::FieldReports& reports = list.results().run->reports;
  if (reports.probeTemperature) {
    list.add(QStringLiteral("probe-temperature"), FigureTopic::ProbeTemperature,
             QStringLiteral("Chamber temperature over the resistance of the PT100, heating and cooling."),
             [](const FieldResults& r) {
               return probeLoopFigure(*r.run->reports.probeTemperature, stepwiseChain(*r.run).referenceTemperatureC);
             });
    list.add(QStringLiteral("probe-temperature-hysteresis"), FigureTopic::ProbeTemperature,
             QStringLiteral(
                 "What scatters about the line, with a band of two standard uncertainties; where a lag was found, "
                 "with the lag taken away."),
             [](const FieldResults& r) {
               return probeResidualFigure(*r.run->reports.probeTemperature,
                                          stepwiseChain(*r.run).referenceTemperatureC);
             });
  }
  if (someAxis(reports.offset)) {
    list.add(QStringLiteral("offset"), FigureTopic::Offset,
             QStringLiteral("Linearised readings in the zero-field chamber over the probe's temperature."),
             [](const FieldResults& r) {
               return zeroFieldFigure(r.run->reports.offset, stepwiseChain(*r.run).referenceTemperatureC,
                                      ZeroFieldOver::Probe);
             });
  }
}

void addSweeps(FieldFigureList& list, FigureTopic topic, SweptTemperature over, const char* stem) {
  for (const field::Axis axis : field::allAxes) {
    const std::size_t place = field::indexOf(axis);
    const field::FieldReports& reports = list.results().run->reports;
    const bool on = over == SweptTemperature::Probe ? reports.sensitivity.at(place).has_value()
                                                    : reports.electronicsSensitivity.at(place).has_value();
    if (on) {
      list.add(ofAxis(stem, axis), topic,
               QStringLiteral("Axis %1: error over temperature at every locked field, with the line through each.")
                   .arg(axisLetter(axis)),
               [axis, over](const FieldResults& r) { return sweepErrorsFigure(*r.run, axis, over); });
    }
  }
}

void addSensitivity(FieldFigureList& list) {
  constexpr FigureTopic topic = FigureTopic::Sensitivity;
  if (!someAxis(list.results().run->reports.sensitivity)) {
    return;
  }
  addSweeps(list, topic, SweptTemperature::Probe, "sensitivity-errors");
  list.add(QStringLiteral("sensitivity-slopes"), topic,
           QStringLiteral("Slopes of the error against probe temperature over the field, with the polynomial that is "
                          "kept; dashed, a straight line."),
           [](const FieldResults& r) { return sweepSlopesFigure(*r.run, SweptTemperature::Probe); });
  list.add(QStringLiteral("sensitivity-intercepts"), topic,
           QStringLiteral("Error at the reference temperature over the field, with the line that is kept."),
           [](const FieldResults& r) { return sweepInterceptsFigure(*r.run); });
  for (const field::Axis axis : field::allAxes) {
    if (list.results().run->reports.sensitivity.at(field::indexOf(axis))) {
      list.add(
          ofAxis("blocks", axis), topic,
          QStringLiteral("Axis %1: error over probe temperature before and after each block.").arg(axisLetter(axis)),
          [axis](const FieldResults& r) { return blockAfterBlockFigure(*r.run, axis); });
    }
  }
}

void addElectronics(FieldFigureList& list) {
  constexpr FigureTopic topic = FigureTopic::Electronics;
  const field::FieldReports& reports = list.results().run->reports;
  if (someAxis(reports.electronics)) {
    list.add(QStringLiteral("electronics-offset"), topic,
             QStringLiteral("Readings in the zero-field chamber over the temperature of the electronics."),
             [](const FieldResults& r) {
               return zeroFieldFigure(r.run->reports.electronics, stepwiseChain(*r.run).referenceTemperatureC,
                                      ZeroFieldOver::Electronics);
             });
  }
  if (someAxis(reports.electronicsSensitivity)) {
    addSweeps(list, topic, SweptTemperature::Electronics, "electronics-errors");
    list.add(QStringLiteral("electronics-slopes"), topic,
             QStringLiteral("Slopes of the error against electronics temperature over the field, with the line that "
                            "is kept."),
             [](const FieldResults& r) { return sweepSlopesFigure(*r.run, SweptTemperature::Electronics); });
  }
}

/// Errors to be drawn: of a fresh campaign where there is one, else of the calibration's own verification rows.
const field::FieldVerification* verifiedErrors(const FieldResults& results) {
  if (results.verification) {
    return &results.verification->verification;
  }
  return results.run ? &results.run->verification : nullptr;
}

/// Error over field and temperature, before and after on one scale, and after on a scale of its own.
void addSurfaces(FieldFigureList& list) {
  const field::FieldVerification* verified = verifiedErrors(list.results());
  if (verified == nullptr) {
    return;
  }
  struct Kind {
    const char* stem;
    const char* what;
    CorrectionState state;
    SurfaceScale scale;
  };
  constexpr std::array<Kind, 3> kinds{{
      {"surface-before", "before correction", CorrectionState::Before, SurfaceScale::Shared},
      {"surface-after", "after correction, on the scale of the one before", CorrectionState::After,
       SurfaceScale::Shared},
      {"surface-after-enlarged", "after correction, on a scale of its own", CorrectionState::After, SurfaceScale::Own},
  }};
  for (std::size_t i = 0; i < verified->errors.size(); ++i) {
    const auto make = [i](const FieldResults& r, const Kind& kind) {
      const field::CorrectionChain& chain = r.calibration.chain;
      return residualSurface(verifiedErrors(r)->errors[i], chain.fullScaleT, chain.referenceTemperatureC, kind.state,
                             kind.scale);
    };
    if (make(list.results(), kinds.front()).isEmpty()) {
      continue;
    }
    const field::Axis axis = verified->errors[i].axis;
    for (const Kind& kind : kinds) {
      list.addScene(
          ofAxis(kind.stem, axis), FigureTopic::Verification,
          QStringLiteral("Axis %1: mean error over field and probe temperature %2; blue below zero, red above.")
              .arg(axisLetter(axis), QLatin1String(kind.what)),
          [make, kind](const FieldResults& r) { return make(r, kind); });
    }
  }
}

void addFieldVerification(FieldFigureList& list) {
  constexpr FigureTopic topic = FigureTopic::Verification;
  if (const field::FieldVerification* verified = verifiedErrors(list.results())) {
    for (std::size_t i = 0; i < verified->errors.size(); ++i) {
      const field::Axis axis = verified->errors[i].axis;
      list.add(ofAxis("verification", axis), topic,
               QStringLiteral("Axis %1: error over the reference field before and after correction, at all "
                              "temperatures.")
                   .arg(axisLetter(axis)),
               [i](const FieldResults& r) {
                 std::optional<double> limit;
                 if (r.verification && r.verification->of == field::PercentOf::FullScale) {
                   limit = r.verification->limitPercent;
                 }
                 return fieldBeforeAfterFigure(verifiedErrors(r)->errors[i], r.calibration.chain.fullScaleT, limit);
               });
    }
  }
  if (!list.results().calibration.verification.empty()) {
    list.add(QStringLiteral("verification-blocks"), topic,
             QStringLiteral("Largest error before and after each block, all temperatures."),
             [](const FieldResults& r) { return blockPeaksFigure(r.calibration.verification); });
  }
  addSurfaces(list);
}

void addAxisMatrix(FieldFigureList& list) {
  constexpr FigureTopic topic = FigureTopic::AxisMatrix;
  if (list.results().calibration.chain.axisMatrix) {
    list.add(QStringLiteral("axis-tilts"), topic,
             QStringLiteral("How far each axis of the probe points away from its axis of the package."),
             [](const FieldResults& r) { return axisTiltsFigure(*r.calibration.chain.axisMatrix); });
    list.addScene(QStringLiteral("axis-directions"), topic,
                  QStringLiteral("The same in space: axes of the probe as arrows, axes of the package thin."),
                  [](const FieldResults& r) { return axisDirections(*r.calibration.chain.axisMatrix); });
  }
  if (list.results().campaign && !orientationSphere(orientationsCovered(*list.results().campaign)).isEmpty()) {
    list.addScene(
        QStringLiteral("orientations"), topic,
        QStringLiteral("Directions of the package that pointed along the field, with the locked rows of each: "
                       "a filled cap was measured, a ring was not."),
        [](const FieldResults& r) { return orientationSphere(orientationsCovered(*r.campaign)); });
  }
}

int slopeOrderOf(const field::CorrectionChain& chain) {
  int order = 0;
  for (const field::AxisChain& axis : chain.axes) {
    if (axis.sensitivitySlope) {
      order = std::max(order, static_cast<int>(axis.sensitivitySlope->size()) - 1);
    }
  }
  return order;
}

void addFieldComparison(FieldFigureList& list) {
  if (!list.results().comparison || list.results().comparison->choices.empty()) {
    return;
  }
  const auto add = [&list](const char* stem, const char* what, ChainCost cost) {
    list.add(QString::fromLatin1(stem), FigureTopic::Comparison,
             QStringLiteral("Largest error that remains over %1, orders of the nonlinearity along each line.")
                 .arg(QLatin1String(what)),
             [cost](const FieldResults& r) {
               return storageFigure(*r.comparison, cost, r.calibration.order, slopeOrderOf(r.calibration.chain)).spec;
             });
  };
  add("storage-coefficients", "the number of coefficients", ChainCost::Coefficients);
  add("storage-multiplications", "the multiplications for one reading", ChainCost::Multiplications);
}

} // namespace

QList<NamedFigure> fieldFigures(const std::shared_ptr<const FieldResults>& results) {
  FieldFigureList list(results);
  addCampaign(list);
  addNonlinearity(list);
  if (results->run) {
    addProbeAndOffset(list);
    addSensitivity(list);
    addElectronics(list);
  }
  addAxisMatrix(list);
  addFieldVerification(list);
  if (results->calibration.uncertainty && !results->calibration.uncertainty->grid.empty()) {
    list.add(QStringLiteral("uncertainty"), FigureTopic::Uncertainty,
             QStringLiteral("Expanded uncertainty (95 %) of one component over the field along it; dashed, the "
                            "largest over the temperatures covered."),
             [](const FieldResults& r) { return expandedUncertaintyFigure(*r.calibration.uncertainty); });
  }
  addFieldComparison(list);
  return list.figures;
}

} // namespace straightedge::gui
