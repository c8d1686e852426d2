// What the step Capture of a field calibration says and does, without widgets: plan, stages, the guided course of the
// campaign, live plots.
#pragma once

#include "app/gui/document/field_bench_link.h"
#include "app/gui/field_steps/capture_stages.h"
#include "app/gui/field_steps/field_live_trace.h"

#include <QObject>
#include <QString>

#include <optional>
#include <span>

namespace straightedge::gui {

class FieldDocument;

/// GUI thread. Shows the calibration campaign of the open session, and a fresh one for Verify while that is captured.
class FieldCapturePresenter : public QObject {
  Q_OBJECT
public:
  enum class Phase : std::uint8_t {
    NoBench,     ///< connect one first
    Ready,       ///< nothing captured yet, or a finished campaign
    Interrupted, ///< the session holds the beginning of a campaign
    Running,
    Waiting, ///< running; a person is to do something and confirm it
    Paused,
    Faulted,  ///< paused by an instrument that failed; what was captured is safe
    Unplugged ///< the same; goes on by itself when the instrument is back
  };

  FieldCapturePresenter(FieldDocument& document, FieldBenchLink& bench, QObject* parent = nullptr);

  Phase phase() const { return m_phase; }
  bool ofVerification() const; ///< a fresh campaign is being captured

  // Plan
  const devices::FieldPlan& plan() const; ///< of the running campaign, otherwise the document's
  void setPlan(const devices::FieldPlan& plan);
  QString planProblem() const; ///< why this plan cannot be captured; empty if it can
  QString planSummary() const; ///< "24 stages, 432 plateaus and sweeps, about 5 h 20 min"

  // Stages: of the campaign that is captured or recorded, else of the plan
  const devices::FieldPlan& shownPlan() const { return m_shownPlan; }
  std::vector<StageLine> stages() const;
  int presentStage() const; ///< measured now; -1: none
  bool canRepeat(int stage) const;
  void repeat(int stage);
  bool isLeftOut(int stage) const;
  bool canLeaveOut(int stage) const; ///< or take back in
  void leaveOut(int stage, bool out);

  // Course
  bool canStart() const;
  bool startReplacesData() const; ///< ask before start(): the session holds rows that it would replace
  QString replaceQuestion() const;
  void start();
  bool canContinueInterrupted() const { return m_phase == Phase::Interrupted; }
  void continueInterrupted();
  bool canPause() const { return m_phase == Phase::Running || m_phase == Phase::Waiting; }
  void pause();
  bool canResume() const { return m_phase == Phase::Paused || m_phase == Phase::Faulted; }
  void resume();
  bool canStop() const { return m_bench.isCapturing(); }
  void stop();
  bool canConfirm() const { return m_phase == Phase::Waiting; }
  void confirm();

  QString heading() const;         ///< "Stage 3 of 24: Nonlinearity, z"
  QString instruction() const;     ///< what a person is to do; empty where nothing is asked for
  QString actionText() const;      ///< "Waiting for the reference to lock at 0.3 T, row 3 of 10"
  double progressFraction() const; ///< 0 to 1, of the expected time
  QString progressText() const;    ///< "12 of 432 plateaus and sweeps, 5 h 10 min left"
  QString rowsText() const;
  QString problem() const { return m_problem; } ///< what went wrong and what to do; empty while all is well
  QString guidance() const;                     ///< what this phase means and what comes next
  bool isComplete() const;                      ///< a finished campaign is shown
  QString nextStep() const;                     ///< title of the step to go on with; empty where it is too early

  // Live plots
  int shownStage() const { return m_shownStage; } ///< -1: none
  void showStage(int stage);                      ///< while idle; while capturing the plots follow the capture
  const FieldLiveTrace& trace() const { return m_trace; }
  qint64 traceRevision() const { return m_traceRevision; } ///< rises with every change of the trace

signals:
  void phaseChanged();
  void planChanged();
  void stagesChanged();   ///< another plan is shown, or one of its stages was left out or taken back in
  void progressChanged(); ///< once per frame while capturing
  void traceChanged();    ///< another stage is shown, or all its rows anew
  void problemChanged();

private:
  void onSamples(int firstNew);
  void onProgress();
  void onEnded(session::SweepRole role);
  void reload();
  void showRecorded();
  void followPresent();
  void rebuildTrace();
  void setProblem(const QString& problem);
  void report(const Result<void>& outcome);
  void refreshPhase();
  Phase phaseNow() const;
  const std::vector<devices::FieldStageProgress>& stageProgress() const;
  const std::vector<session::FieldSample>& samples() const;
  double leftS() const;

  FieldDocument& m_document;
  FieldBenchLink& m_bench;
  FieldLiveTrace m_trace;
  qint64 m_traceRevision = 0;
  int m_shownStage = -1;
  devices::FieldPlan m_shownPlan;
  bool m_live = false; ///< the bench link's samples are shown, not m_stored
  std::vector<session::FieldSample> m_stored;
  std::vector<devices::FieldStageProgress> m_recorded; ///< by the samples, while nothing is captured
  bool m_finished = false;                             ///< the recorded campaign was carried out to the end
  std::optional<devices::FieldPlan> m_interrupted;
  bool m_freshDone = false; ///< a fresh campaign has ended in this run of the program
  Phase m_phase = Phase::NoBench;
  QString m_problem;
};

} // namespace straightedge::gui
