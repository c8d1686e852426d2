// What the step Fit says and does, without widgets: correction curve, chosen models, views of both.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/figures/report_content.h"
#include "app/gui/plots/plot_spec.h"

#include <QList>
#include <QObject>
#include <QSet>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>

namespace straightedge::gui {

/// What the plots of the step show.
enum class FitView : std::uint8_t {
  CurveAndModels,
  Residuals,
  Harmonics,
  GrowingHarmonics,
  GrowingSegments,
  GrowingEntries,
  LinearMethods,
  TableSteps,
  ThreeTurns,
  Projection
};

/// GUI thread. Reads the document's results; every change goes through the document.
class FitPresenter : public QObject {
  Q_OBJECT
public:
  explicit FitPresenter(AngleDocument& document, QObject* parent = nullptr);

  // Views
  static QList<FitView> views();
  static QString viewTitle(FitView view);
  PlotSpec upperFigure(FitView view) const;
  std::optional<PlotSpec> lowerFigure(FitView view) const; ///< residuals under the curve, phases under amplitudes

  // Curve
  angle::CurveMethod curveMethod() const;
  void setCurveMethod(angle::CurveMethod method);
  QString curveText() const; ///< how the curve was made and how well the points foretell each other

  // Models
  const std::vector<angle::ModelName>& models() const;
  /// Why this model cannot be added, as a sentence; empty where it can.
  QString addProblem(const angle::ModelName& name) const;
  void addModel(const angle::ModelName& name);
  void removeModel(int place);
  bool isShown(int place) const;
  void setShown(int place, bool shown); ///< of this window only, not kept in the file
  int selectedModel() const;            ///< place of the one that Verify uses; −1 where it is not among the shown ones
  void selectModel(int place);
  ReportTable modelsTable() const; ///< a row per model; dashes while a new one is being fitted

  QString missing() const;      ///< empty when there is a curve; otherwise what to do
  QStringList warnings() const; ///< of the data and the models, whole sentences

signals:
  void changed(); ///< results or choices: read everything anew

private:
  std::vector<angle::Model> fittedModels() const; ///< in the order of models()
  void applyShown(PlotSpec& spec) const;

  AngleDocument& m_document;
  QSet<QString> m_hidden; ///< names of models switched off in the plots
};

} // namespace straightedge::gui
