// What the step Capture says and does, without widgets: plan, course of the capture, live plots.
#pragma once

#include "app/gui/document/bench_link.h"
#include "app/gui/steps/capture_points_model.h"
#include "app/gui/steps/live_trace.h"

#include <QObject>
#include <QString>

#include <optional>
#include <span>

namespace straightedge::gui {

class AngleDocument;

/// GUI thread.
class CapturePresenter : public QObject {
  Q_OBJECT
public:
  enum class Phase : std::uint8_t {
    NoBench,     ///< connect one first
    Ready,       ///< nothing captured yet, or a finished sweep
    Interrupted, ///< the session holds the beginning of a sweep
    Running,
    Paused,
    Waiting, ///< for an instrument that was unplugged: goes on by itself when it is back
    Faulted  ///< paused by an instrument that failed; what was captured is safe
  };

  CapturePresenter(AngleDocument& document, BenchLink& bench, QObject* parent = nullptr);

  Phase phase() const;
  // Plan
  const devices::AnglePlan& plan() const; ///< of the running or interrupted sweep, otherwise the document's
  void setPlan(const devices::AnglePlan& plan);
  QString planProblem() const;     ///< why this plan cannot be captured; empty if it can
  QString planSummary() const;     ///< "128 points, about 12 s"
  double plannedDurationS() const; ///< estimate for a bench in real time

  // Course
  bool canStart() const;
  bool startReplacesData() const; ///< ask before start(): the session holds readings that it would replace
  QString replaceQuestion() const;
  void start();
  bool canContinueInterrupted() const;
  void continueInterrupted();
  bool canPause() const;
  void pause();
  bool canResume() const;
  void resume();
  bool canStop() const;
  void stop();
  bool canRedo(std::optional<int> planPoint) const; ///< a point that was measured
  void redo(int planPoint);

  bool isComplete() const;  ///< a sweep that was carried out to its end is shown
  QString nextStep() const; ///< title of the step to go on with; empty where it is too early

  double progressFraction() const; ///< 0 to 1
  QString progressText() const;    ///< "12 of 64 points, 00:31 left"
  QString samplesText() const;     ///< "768 readings"; says how many the live display left out
  QString problem() const;         ///< what went wrong and what to do; empty while all is well
  QString guidance() const;        ///< what this phase means and what comes next

  const devices::AnglePlan& shownPlan() const { return m_shownPlan; } ///< the one that trace and points belong to
  std::span<const session::AngleSample> samplesFrom(int first) const; ///< shown samples, in order of arrival
  const LiveTrace& trace() const { return m_trace; }
  CapturePointsModel& points() { return m_points; }

signals:
  void phaseChanged();
  void planChanged();
  void progressChanged();         ///< once per frame while capturing
  void samplesArrived(int first); ///< trace and points have taken them in; 0: everything anew
  void problemChanged();
  void guidanceChanged(); ///< within a phase

private:
  void onSamples(int firstNew);
  void onProgress();
  void reload();
  void showStoredSamples();
  void setProblem(const QString& problem);
  void refreshPhase();
  QString turnByHand() const; ///< where to turn the shaft next; empty with a stage

  AngleDocument& m_document;
  BenchLink& m_bench;
  LiveTrace m_trace;
  CapturePointsModel m_points;
  std::vector<session::AngleSample> m_stored; ///< of the open session while nothing was captured in this run
  devices::AnglePlan m_shownPlan;             ///< the one that m_points shows
  std::optional<devices::AnglePlan> m_interrupted;
  qint64 m_readings = 0; ///< taken into m_trace
  Phase m_phase = Phase::NoBench;
  QString m_problem;
  QString m_guidance; ///< as last told
  QString m_note;     ///< of the running capture: what a person should know or do
};

} // namespace straightedge::gui
