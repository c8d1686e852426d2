// What the step Verify of a field calibration says and does, without widgets: limit, fresh campaign, verdict.
#pragma once

#include "app/gui/document/field_document.h"
#include "app/gui/figures/field_figures.h"
#include "app/gui/figures/report_content.h"
#include "app/gui/steps/verify_presenter.h"

#include <QList>
#include <QObject>
#include <QString>

namespace straightedge::gui {

class JobRunner;

/// GUI thread. The limit is compared with the largest error of the fresh campaign, or of the calibration's own
/// verification rows while there is none.
class FieldVerifyPresenter : public QObject {
  Q_OBJECT
public:
  using Outcome = VerifyPresenter::Outcome;

  FieldVerifyPresenter(FieldDocument& document, JobRunner& jobs, QObject* parent = nullptr);

  // Limit
  double limitPercent() const { return m_document.choices().limitPercent; }
  void setLimitPercent(double percent);
  field::PercentOf percentOf() const { return m_document.choices().percentOf; }
  void setPercentOf(field::PercentOf of);

  // Campaign
  void loadCsv(const QString& file);
  void forgetFresh(); ///< back to the campaign's own verification rows
  bool hasFresh() const;
  QString campaignText() const; ///< what is verified with, and which rows were left out

  // Verdict
  Outcome outcome() const;
  QString verdictText() const; ///< one line: passed, failed, or what to do
  QString ruleText() const;    ///< how it is judged
  QList<NamedFigure> figures() const;
  PlotSpec emptyPlot() const;
  ReportTable table() const;

  QString missing() const;                      ///< a calibration is needed first
  QString problem() const { return m_problem; } ///< the last thing that went wrong, with its remedy

signals:
  void changed();

private:
  void setProblem(const QString& problem);

  FieldDocument& m_document;
  JobRunner& m_jobs;
  QString m_problem;
};

} // namespace straightedge::gui
