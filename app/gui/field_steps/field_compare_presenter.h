// What the step Compare of a field calibration says and does, without widgets: orders against the error they leave.
#pragma once

#include "app/gui/document/field_document.h"
#include "app/gui/figures/field_cost_figures.h"
#include "app/gui/figures/report_content.h"

#include <QObject>
#include <QString>

#include <optional>
#include <vector>

namespace straightedge::gui {

class JobRunner;

/// GUI thread. The comparison takes many fits: it is made only while the step is shown.
class FieldComparePresenter : public QObject {
  Q_OBJECT
public:
  FieldComparePresenter(FieldDocument& document, JobRunner& jobs, QObject* parent = nullptr);

  void setShown(bool shown);

  ChainCost cost() const { return m_cost; }
  void setCost(ChainCost cost);
  bool onlyBest() const { return m_onlyBest; }
  void setOnlyBest(bool only); ///< of the table: choices that nothing with as few coefficients beats

  PlotSpec figure() const;
  ReportTable table() const;                                        ///< a row for each of shownChoices()
  std::optional<std::size_t> choiceAt(int series, int index) const; ///< of the figure
  std::optional<std::size_t> choiceOfRow(int row) const;            ///< of the table
  /// Its order of the nonlinearity is fitted from now on; of a block left out, that block is switched off.
  void choose(std::size_t choice);
  QString chosenText() const; ///< order and size of the present calibration and what it leaves

  QString missing() const;
  QString progressText() const; ///< while orders are being compared; empty otherwise

signals:
  void changed();
  void progressChanged();

private:
  std::vector<std::size_t> shownChoices() const; ///< by coefficients, then by error

  FieldDocument& m_document;
  JobRunner& m_jobs;
  ChainCost m_cost = ChainCost::Coefficients;
  bool m_onlyBest = false;
  double m_progress = 0.0;
};

} // namespace straightedge::gui
