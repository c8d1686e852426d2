#include "app/gui/steps/fit_presenter.h"

#include "app/gui/figures/curve_figures.h"
#include "app/gui/figures/figure_parts.h"
#include "app/gui/figures/model_figures.h"
#include "app/gui/figures/report_tables.h"
#include "core/angle/model_limits.h"

#include <algorithm>

namespace straightedge::gui {

FitPresenter::FitPresenter(AngleDocument& document, QObject* parent) : QObject(parent), m_document(document) {
  connect(&document, &AngleDocument::opened, this, [this] {
    m_hidden.clear();
    emit changed();
  });
  connect(&document, &AngleDocument::runChanged, this, &FitPresenter::changed);
  connect(&document, &AngleDocument::choicesChanged, this, &FitPresenter::changed);
}

QList<FitView> FitPresenter::views() {
  return {FitView::CurveAndModels,  FitView::Residuals,      FitView::Harmonics,     FitView::GrowingHarmonics,
          FitView::GrowingSegments, FitView::GrowingEntries, FitView::LinearMethods, FitView::TableSteps,
          FitView::ThreeTurns,      FitView::Projection};
}

QString FitPresenter::viewTitle(FitView view) {
  switch (view) {
  case FitView::CurveAndModels:
    return tr("Curve and models");
  case FitView::Residuals:
    return tr("Residuals");
  case FitView::Harmonics:
    return tr("Harmonics");
  case FitView::GrowingHarmonics:
    return tr("Growing number of harmonics");
  case FitView::GrowingSegments:
    return tr("Growing number of segments");
  case FitView::GrowingEntries:
    return tr("Growing number of table entries");
  case FitView::LinearMethods:
    return tr("Linear methods compared");
  case FitView::TableSteps:
    return tr("Lookup table as steps");
  case FitView::ThreeTurns:
    return tr("Curve over three turns");
  case FitView::Projection:
    return tr("Projection onto the sensor's grid");
  }
  return {};
}

PlotSpec FitPresenter::upperFigure(FitView view) const {
  const std::shared_ptr<const angle::CalibrationRun> run = m_document.run();
  if (!run) {
    return emptyFigure(viewTitle(view), turnAxis(tr("Sensor angle (°)")), dataAxis(tr("Correction (°)")), missing());
  }
  const angle::AlignedSweep& aligned = run->aligned;
  const angle::CorrectionCurve& curve = run->curve;
  PlotSpec spec;
  switch (view) {
  case FitView::CurveAndModels:
    spec = curveWithModelsFigure(fittedModels(), &aligned, &curve, aligned.direction);
    applyShown(spec);
    break;
  case FitView::Residuals:
    spec = residualFigure(fittedModels(), curve, aligned.direction);
    applyShown(spec);
    break;
  case FitView::Harmonics:
    spec = harmonicAmplitudesFigure(curveHarmonics(curve));
    break;
  case FitView::GrowingHarmonics:
    spec = growingFamilyFigure(GrowingFamily::Harmonics, aligned, curve);
    break;
  case FitView::GrowingSegments:
    spec = growingFamilyFigure(GrowingFamily::Segments, aligned, curve);
    break;
  case FitView::GrowingEntries:
    spec = growingFamilyFigure(GrowingFamily::TableEntries, aligned, curve);
    break;
  case FitView::LinearMethods:
    spec = linearMethodsFigure(curve, segmentsShown(run->result), aligned.direction);
    break;
  case FitView::TableSteps:
    spec = tableStepsFigure(curve, entriesShown(run->result), aligned.direction);
    break;
  case FitView::ThreeTurns:
    spec = repeatedCurveFigure(curve, aligned.direction);
    break;
  case FitView::Projection:
    spec = projectionFigure(aligned, curve);
    break;
  }
  return spec;
}

std::optional<PlotSpec> FitPresenter::lowerFigure(FitView view) const {
  const std::shared_ptr<const angle::CalibrationRun> run = m_document.run();
  if (!run) {
    return std::nullopt;
  }
  PlotSpec spec;
  switch (view) {
  case FitView::CurveAndModels:
    spec = residualFigure(fittedModels(), run->curve, run->aligned.direction);
    break;
  case FitView::Residuals:
    spec = pointResidualFigure(fittedModels(), run->aligned);
    break;
  case FitView::Harmonics:
    return harmonicPhasesFigure(curveHarmonics(run->curve));
  default:
    return std::nullopt;
  }
  applyShown(spec);
  return spec;
}

angle::CurveMethod FitPresenter::curveMethod() const { return m_document.choices().curveMethod; }

void FitPresenter::setCurveMethod(angle::CurveMethod method) {
  AngleChoices choices = m_document.choices();
  if (choices.curveMethod != method) {
    choices.curveMethod = method;
    m_document.setChoices(choices, tr("Choose the curve"));
  }
}

QString FitPresenter::curveText() const {
  const std::shared_ptr<const angle::CalibrationRun> run = m_document.run();
  if (!run) {
    return {};
  }
  const angle::CorrectionCurve& curve = run->curve;
  QString made = tr("Periodic cubic spline through %1 points.").arg(run->aligned.readingDeg.size());
  if (curve.method == angle::CurveMethod::Regress) {
    made = tr("Least squares with %1 harmonics over %2 points; the number was chosen by cross-validation.")
               .arg(curve.harmonics)
               .arg(run->aligned.readingDeg.size());
    if (curve.residualSigmaDeg) {
      made += QLatin1Char(' ') + tr("Points scatter about it by %1 (1 σ).").arg(degrees(*curve.residualSigmaDeg, 3));
    }
  }
  return made + QLatin1Char(' ') +
         tr("Leave-one-out error: %1 rms, %2 at most. Claims below it are not supported by the points.")
             .arg(degrees(curve.leaveOneOutRmsDeg, 3), degrees(curve.leaveOneOutMaxDeg, 3));
}

const std::vector<angle::ModelName>& FitPresenter::models() const { return m_document.choices().models; }

QString FitPresenter::addProblem(const angle::ModelName& name) const {
  if (const Result<angle::ModelName> checked = angle::checkedModelName(name); !checked) {
    return fromText(checked.error().message());
  }
  if (std::ranges::find(models(), name) != models().end()) {
    return tr("%1 is in the list already.").arg(modelNameText(name));
  }
  const std::shared_ptr<const angle::CalibrationRun> run = m_document.run();
  if (run && name.kind == angle::ModelKind::Harmonic && name.size > run->curve.resolvableHarmonics) {
    return tr("The points resolve %1 harmonics, not %2: record more points or choose fewer harmonics.")
        .arg(run->curve.resolvableHarmonics)
        .arg(name.size);
  }
  return {};
}

void FitPresenter::addModel(const angle::ModelName& name) {
  if (!addProblem(name).isEmpty()) {
    return;
  }
  AngleChoices choices = m_document.choices();
  choices.models.push_back(name);
  m_document.setChoices(choices, tr("Add %1").arg(modelNameText(name)));
}

void FitPresenter::removeModel(int place) {
  AngleChoices choices = m_document.choices();
  if (place < 0 || place >= static_cast<int>(choices.models.size())) {
    return;
  }
  const angle::ModelName name = choices.models[static_cast<std::size_t>(place)];
  choices.models.erase(choices.models.begin() + place);
  if (choices.selected == name && !choices.models.empty()) {
    choices.selected = choices.models.front();
  }
  m_hidden.remove(modelNameText(name));
  m_document.setChoices(choices, tr("Remove %1").arg(modelNameText(name)));
}

bool FitPresenter::isShown(int place) const {
  return !m_hidden.contains(modelNameText(models().at(static_cast<std::size_t>(place))));
}

void FitPresenter::setShown(int place, bool shown) {
  if (isShown(place) == shown) {
    return;
  }
  const QString name = modelNameText(models().at(static_cast<std::size_t>(place)));
  if (shown) {
    m_hidden.remove(name);
  } else {
    m_hidden.insert(name);
  }
  emit changed();
}

int FitPresenter::selectedModel() const {
  const auto found = std::ranges::find(models(), m_document.choices().selected);
  return found == models().end() ? -1 : static_cast<int>(found - models().begin());
}

void FitPresenter::selectModel(int place) {
  if (place < 0 || place >= static_cast<int>(models().size())) {
    return;
  }
  AngleChoices choices = m_document.choices();
  const angle::ModelName name = choices.models[static_cast<std::size_t>(place)];
  if (choices.selected != name) {
    choices.selected = name;
    m_document.setChoices(choices, tr("Choose %1").arg(modelNameText(name)));
  }
}

std::vector<angle::Model> FitPresenter::fittedModels() const {
  std::vector<angle::Model> fitted;
  const std::shared_ptr<const angle::CalibrationRun> run = m_document.run();
  if (run) {
    for (const angle::ModelName& name : models()) {
      const auto model = std::ranges::find(run->result.models, name, &angle::Model::name);
      if (model != run->result.models.end()) {
        fitted.push_back(*model);
      }
    }
  }
  return fitted;
}

void FitPresenter::applyShown(PlotSpec& spec) const {
  for (const angle::ModelName& name : models()) {
    if (!m_hidden.contains(modelNameText(name))) {
      continue;
    }
    const QString title = modelTitle(name);
    for (PlotSeries& series : spec.series) {
      series.visible = series.visible && series.name != title;
    }
  }
}

ReportTable FitPresenter::modelsTable() const {
  angle::AngleCalibration shown;
  const std::shared_ptr<const angle::CalibrationRun> run = m_document.run();
  if (run) {
    shown = run->result;
  }
  shown.models = fittedModels();
  const ReportTable fitted = gui::modelsTable(shown);
  ReportTable table = fitted;
  table.rows.clear();
  for (const angle::ModelName& name : models()) {
    const QString text = modelNameText(name);
    const auto row =
        std::ranges::find_if(fitted.rows, [&text](const QStringList& each) { return each.front() == text; });
    if (row != fitted.rows.end()) {
      table.rows.append(*row);
    } else {
      QStringList waiting{text, QString::number(name.storageEntries()), QString::number(name.storageBytes())};
      while (waiting.size() < table.header.size()) {
        waiting << QStringLiteral("–");
      }
      table.rows.append(waiting);
    }
  }
  return table;
}

QString FitPresenter::missing() const {
  if (m_document.run()) {
    return {};
  }
  if (m_document.runError()) {
    return fromText(m_document.runError()->message());
  }
  return m_document.sweep().size() == 0 ? tr("There are no readings yet: capture a sweep or import a CSV file.")
                                        : tr("The curve is being computed.");
}

QStringList FitPresenter::warnings() const {
  QStringList sentences;
  if (const std::shared_ptr<const angle::CalibrationRun> run = m_document.run()) {
    for (const angle::Warning& warning : run->result.warnings) {
      sentences << fromText(warning.text);
    }
  }
  sentences.removeDuplicates();
  return sentences;
}

} // namespace straightedge::gui
