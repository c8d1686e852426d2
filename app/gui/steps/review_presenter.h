// What the step Review says and does, without widgets: figures of the sweep's quality, plots, points switched off.
#pragma once

#include "app/gui/figures/sweep_figures.h"
#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/review_table_model.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace straightedge::gui {

class AngleDocument;
class JobRunner;

/// GUI thread; what takes long runs as a job and arrives with analysisChanged().
class ReviewPresenter : public QObject {
  Q_OBJECT
public:
  enum class View : std::uint8_t { Error, Unwrapped, Residual, Hysteresis, Noise, Coverage };
  struct Fact {
    QString caption, value, hint;
  };

  ReviewPresenter(AngleDocument& document, JobRunner& jobs, QObject* parent = nullptr);

  bool hasSweep() const;
  QString missing() const; ///< empty once there is a sweep
  QList<Fact> facts() const;
  QList<Notice> notices() const; ///< the refusal first, then the warnings
  const std::vector<std::size_t>& outliers() const;
  ReviewTableModel& table() { return m_table; }

  // Plots
  PlotSpec plot(View view) const;
  std::optional<std::size_t> rowAt(View view, int series, int index) const;

  // Rows
  void setSelection(std::vector<std::size_t> rows); ///< marked in the plots
  const std::vector<std::size_t>& selection() const { return m_selection; }
  void setEnabled(const std::vector<std::size_t>& rows, bool enabled);
  void toggle(const std::vector<std::size_t>& rows); ///< off if any of them is on, otherwise on
  std::size_t switchedOff() const;
  void switchAllOn();

signals:
  void analysisChanged(); ///< table, facts, notices and plots
  void plotsChanged();    ///< only what is marked in them
  void missingChanged();

private:
  void refresh();
  void startAnalysis();
  RowFigure figure(View view) const;
  RowFigure residualFigure() const;
  void markRows(RowFigure& figure) const;

  AngleDocument& m_document;
  JobRunner& m_jobs;
  ReviewTableModel m_table;
  std::shared_ptr<const ReviewAnalysis> m_analysis;
  std::vector<std::size_t> m_selection;
  mutable std::optional<View> m_figureView; ///< of m_figure, so that a click costs no new figure
  mutable RowFigure m_figure;
};

} // namespace straightedge::gui
