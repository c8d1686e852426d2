// What the step Compare says and does, without widgets: every size of every method, target and budget, the answer to
// "which model?".
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/figures/comparison_figures.h"

#include <QObject>
#include <QString>

#include <optional>

namespace straightedge::gui {

class JobRunner;

/// GUI thread.
class ComparePresenter : public QObject {
  Q_OBJECT
public:
  ComparePresenter(AngleDocument& document, JobRunner& jobs, QObject* parent = nullptr);

  // Plot
  ErrorMeasure errorMeasure() const { return m_error; }
  StorageMeasure storageMeasure() const { return m_storage; }
  void setErrorMeasure(ErrorMeasure measure);
  void setStorageMeasure(StorageMeasure measure);
  std::optional<int> bits() const;
  void setBits(std::optional<int> bits);
  const PlotSpec& figure() const; ///< made anew only when something but the demands changed

  // Demands: set in figures or by dragging a line of the plot
  double targetErrorDeg() const;
  int budgetEntries() const;
  void setTargetErrorDeg(double valueDeg);
  void setBudgetEntries(int entries);
  void dragGuide(const QString& id, double value); ///< "target" in degrees, "budget" on the storage axis
  double guideValue(const QString& id) const;

  // Answers
  angle::Recommendation forTarget() const;
  angle::Recommendation forBudget() const;

  // Choosing
  void choosePoint(int series, int index);        ///< a click in the plot
  void chooseModel(const angle::ModelName& name); ///< becomes the selected model; joins the list of Fit
  QString chosenText() const;                     ///< the selected model, its storage and errors

  std::shared_ptr<const angle::Comparison> comparison() const;
  QString missing() const;
  QString progressText() const; ///< while minimax and the fine grid are still being computed; empty otherwise

signals:
  void figureChanged();
  void demandsChanged(); ///< target, budget or chosen model: sentences and lines
  void progressChanged();

private:
  void onChoices();
  void rebuild();

  AngleDocument& m_document;
  AngleChoices m_known; ///< as last seen, to tell a drag from a new choice
  ErrorMeasure m_error = ErrorMeasure::Maximum;
  StorageMeasure m_storage = StorageMeasure::Entries;
  mutable std::optional<ComparisonFigure> m_figure;
  double m_progress = 0.0;
};

} // namespace straightedge::gui
