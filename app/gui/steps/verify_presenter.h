// What the step Verify says and does, without widgets: a fresh sweep through the chosen model, limit and verdict.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/document/bench_link.h"
#include "app/gui/figures/report_content.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <cstdint>

namespace straightedge::gui {

class JobRunner;

/// GUI thread.
class VerifyPresenter : public QObject {
  Q_OBJECT
public:
  enum class Outcome : std::uint8_t { None, Passed, PassedInDoubt, Failed, FailedInDoubt };

  VerifyPresenter(AngleDocument& document, BenchLink& bench, JobRunner& jobs, QObject* parent = nullptr);

  // Model and limit
  QStringList models() const; ///< canonical names; the selected one is among them
  int selectedModel() const;
  void selectModel(int place);
  double limitDeg() const;
  void setLimitDeg(double limitDeg);

  // Fresh sweep
  int points() const { return m_points; }
  void setPoints(int points);
  /// Its points lie between those of the calibration sweep's plan, so that the curve is judged where it was not pinned.
  devices::AnglePlan plan() const;
  QString captureProblem() const; ///< why no sweep can be taken now; empty where it can
  void capture();
  void stopCapture();
  bool isCapturing() const;
  QString progressText() const;
  double progress() const; ///< 0 to 1
  void loadCsv(const QString& file);
  QString sweepText() const; ///< where the fresh sweep comes from and how many points it has; empty where there is none

  // Verdict
  Outcome outcome() const;
  QString verdictText() const; ///< one line: passed, failed, or what to do
  QString ruleText() const;    ///< how uncertainty counts
  PlotSpec beforeAfter() const;
  PlotSpec corrected() const;
  ReportTable table() const;

  QString missing() const; ///< a calibration is needed first
  QString problem() const; ///< the last thing that went wrong, with its remedy

signals:
  void changed();
  void progressChanged();

private:
  void setProblem(const QString& problem);

  AngleDocument& m_document;
  BenchLink& m_bench;
  JobRunner& m_jobs;
  int m_points = 0;
  bool m_capturing = false; ///< a verification sweep, not a calibration sweep
  QString m_problem;
};

} // namespace straightedge::gui
