#include "app/gui/field_steps/field_capture_presenter.h"

#include "app/gui/document/field_document.h"
#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/figures/figure_parts.h"
#include "app/gui/steps/capture_words.h"

#include <algorithm>
#include <utility>

namespace straightedge::gui {

using Phase = FieldCapturePresenter::Phase;

FieldCapturePresenter::FieldCapturePresenter(FieldDocument& document, FieldBenchLink& bench, QObject* parent)
    : QObject(parent), m_document(document), m_bench(bench) {
  connect(&document, &FieldDocument::opened, this, &FieldCapturePresenter::reload);
  connect(&document, &FieldDocument::planChanged, this, [this] {
    if (!m_bench.isCapturing() && samples().empty()) {
      showRecorded();
    }
    refreshPhase();
    emit planChanged();
  });
  connect(&document, &FieldDocument::campaignChanged, this, &FieldCapturePresenter::phaseChanged);
  connect(&bench, &FieldBenchLink::connectionChanged, this, [this] {
    setProblem({});
    refreshPhase();
    emit phaseChanged();
    emit planChanged(); // its duration depends on the bench
  });
  connect(&bench, &FieldBenchLink::samplesArrived, this, &FieldCapturePresenter::onSamples);
  connect(&bench, &FieldBenchLink::progressChanged, this, &FieldCapturePresenter::onProgress);
  connect(&bench, &FieldBenchLink::captureEnded, this, &FieldCapturePresenter::onEnded);
  connect(&bench, &FieldBenchLink::failed, this, &FieldCapturePresenter::setProblem);
  reload();
}

void FieldCapturePresenter::reload() {
  setProblem({});
  m_freshDone = false;
  m_shownStage = -1;
  m_live = false;
  showRecorded();
  refreshPhase();
  emit planChanged();
  emit phaseChanged();
}

/// What the session says of the calibration campaign, while nothing is captured.
void FieldCapturePresenter::showRecorded() {
  m_live = false;
  m_stored.clear();
  const session::Session* session = std::as_const(m_document).session();
  const auto record =
      session == nullptr ? std::nullopt : readFieldCaptureRecord(*session, session::SweepRole::Calibration);
  if (record) {
    m_stored = session->fieldSamples(session::SweepRole::Calibration).value_or(std::vector<session::FieldSample>{});
  }
  m_shownPlan = record && !m_stored.empty() ? record->plan : m_document.plan();
  m_finished = record && record->finished && !m_stored.empty();
  m_recorded = progressBySamples(m_shownPlan, m_stored, m_finished);
  const auto stages = static_cast<int>(m_shownPlan.stages.size());
  m_shownStage = stages == 0 ? -1 : std::clamp(m_shownStage, 0, stages - 1);
  rebuildTrace();
  emit stagesChanged();
}

const std::vector<session::FieldSample>& FieldCapturePresenter::samples() const {
  return m_live ? m_bench.liveSamples() : m_stored;
}

const std::vector<devices::FieldStageProgress>& FieldCapturePresenter::stageProgress() const {
  const auto& running = m_bench.progress().stages; // empty until the capture thread says the first word
  return m_bench.isCapturing() && running.size() == m_shownPlan.stages.size() ? running : m_recorded;
}

Phase FieldCapturePresenter::phaseNow() const {
  const devices::FieldCaptureProgress& progress = m_bench.progress();
  if (m_bench.isCapturing()) {
    if (progress.state == devices::CaptureState::Paused) {
      return progress.waitsForInstrument ? Phase::Unplugged : progress.error ? Phase::Faulted : Phase::Paused;
    }
    return progress.waitingFor.empty() ? Phase::Running : Phase::Waiting;
  }
  if (!m_bench.isConnected()) {
    return Phase::NoBench;
  }
  return m_interrupted ? Phase::Interrupted : Phase::Ready;
}

void FieldCapturePresenter::refreshPhase() {
  m_interrupted = m_bench.interruptedPlan(session::SweepRole::Calibration);
  if (const Phase now = phaseNow(); now != m_phase) {
    m_phase = now;
    emit phaseChanged();
  }
}

bool FieldCapturePresenter::ofVerification() const {
  return m_bench.isCapturing() && m_bench.captureRole() == session::SweepRole::Verification;
}

const devices::FieldPlan& FieldCapturePresenter::plan() const {
  return m_bench.isCapturing() ? m_bench.capturePlan() : m_document.plan();
}

void FieldCapturePresenter::setPlan(const devices::FieldPlan& plan) { m_document.setPlan(plan); }

QString FieldCapturePresenter::planProblem() const {
  const Result<void> checked = devices::checkPlan(plan());
  return checked ? QString() : fromText(checked.error().message());
}

QString FieldCapturePresenter::planSummary() const {
  qint64 stages = 0;
  qint64 points = 0;
  for (const devices::FieldStage& stage : plan().stages) {
    stages += stage.skipped ? 0 : 1;
    points += stage.skipped ? 0 : static_cast<qint64>(devices::plannedPoints(stage).size());
  }
  const bool virtualClock = m_bench.isConnected() && !m_bench.inRealTime();
  const QString duration =
      virtualClock ? tr("as fast as the computer can") : tr("about %1").arg(durationText(devices::expectedS(plan())));
  return tr("%1 stages, %2 plateaus and sweeps, %3").arg(countText(stages), countText(points), duration);
}

std::vector<StageLine> FieldCapturePresenter::stages() const {
  return stageLines(m_shownPlan, stageProgress(), presentStage());
}

int FieldCapturePresenter::presentStage() const { return m_bench.isCapturing() ? m_bench.progress().stage : -1; }

bool FieldCapturePresenter::canRepeat(int stage) const {
  const auto& all = stageProgress();
  if (stage < 0 || static_cast<std::size_t>(stage) >= all.size() || !m_bench.isConnected()) {
    return false;
  }
  const auto& chosen = all[static_cast<std::size_t>(stage)];
  return (m_bench.isCapturing() || !samples().empty()) &&
         (chosen.pointsDone > 0 || chosen.attempt > 0 || stage == presentStage());
}

void FieldCapturePresenter::repeat(int stage) {
  if (canRepeat(stage)) {
    setProblem({});
    m_bench.redoStage(stage);
    if (m_phase == Phase::Faulted) { // the stage that failed is asked for again: go on with it
      m_bench.resumeCapture();
    }
    refreshPhase();
  }
}

bool FieldCapturePresenter::isLeftOut(int stage) const {
  const auto& all = stageProgress();
  return stage >= 0 && static_cast<std::size_t>(stage) < all.size() && all[static_cast<std::size_t>(stage)].skipped;
}

bool FieldCapturePresenter::canLeaveOut(int stage) const {
  return stage >= 0 && static_cast<std::size_t>(stage) < m_shownPlan.stages.size() && m_document.isOpen();
}

void FieldCapturePresenter::leaveOut(int stage, bool out) {
  if (!canLeaveOut(stage) || isLeftOut(stage) == out) {
    return;
  }
  m_bench.skipStage(stage, out);
  if (m_bench.isCapturing()) {
    m_shownPlan.stages[static_cast<std::size_t>(stage)].skipped = out;
    emit stagesChanged();
  } else {
    showRecorded();
  }
  refreshPhase();
  emit planChanged();  // its duration is another
  emit phaseChanged(); // the campaign may be complete now, or not any more
}

bool FieldCapturePresenter::canStart() const {
  return (m_phase == Phase::Ready || m_phase == Phase::Interrupted) && planProblem().isEmpty();
}

bool FieldCapturePresenter::startReplacesData() const {
  return !m_document.campaign().rows.empty() || !samples().empty();
}

QString FieldCapturePresenter::replaceQuestion() const {
  const auto rows = std::max(m_document.campaign().rows.size(), samples().size());
  return tr("This calibration holds %1 rows. A new campaign replaces them; this cannot be undone.")
      .arg(countText(static_cast<qint64>(rows)));
}

void FieldCapturePresenter::report(const Result<void>& outcome) {
  if (!outcome) {
    setProblem(fromText(outcome.error().message()));
  }
  refreshPhase();
}

void FieldCapturePresenter::start() {
  if (canStart()) {
    setProblem({});
    report(m_bench.startCapture(m_document.plan(), session::SweepRole::Calibration, false));
  }
}

void FieldCapturePresenter::continueInterrupted() {
  if (m_interrupted) {
    setProblem({});
    const devices::FieldPlan begunPlan = *m_interrupted;
    report(m_bench.startCapture(begunPlan, session::SweepRole::Calibration, true));
  }
}

void FieldCapturePresenter::pause() { m_bench.pauseCapture(); }

void FieldCapturePresenter::resume() {
  setProblem({});
  m_bench.resumeCapture();
}

void FieldCapturePresenter::stop() { m_bench.stopCapture(); }

void FieldCapturePresenter::confirm() {
  if (canConfirm()) {
    m_bench.confirm();
  }
}

QString FieldCapturePresenter::heading() const {
  const int stage = presentStage();
  if (stage < 0 || static_cast<std::size_t>(stage) >= m_shownPlan.stages.size()) {
    return {};
  }
  const devices::FieldStage& present = m_shownPlan.stages[static_cast<std::size_t>(stage)];
  return tr("Stage %1 of %2: %3")
      .arg(stage + 1)
      .arg(m_shownPlan.stages.size())
      .arg(stageWord(present.step, present.axis, present.orientation));
}

QString FieldCapturePresenter::instruction() const {
  QString text = withProperMinus(fromText(m_bench.progress().waitingFor));
  if (!canConfirm() || text.isEmpty()) {
    return {};
  }
  text.replace(0, 1, text.front().toUpper());
  return text + QLatin1Char('.');
}

QString FieldCapturePresenter::actionText() const {
  const devices::FieldCaptureProgress& now = m_bench.progress();
  if (m_phase != Phase::Running || now.stage < 0 || static_cast<std::size_t>(now.stage) >= m_shownPlan.stages.size()) {
    return {};
  }
  const int rows = m_shownPlan.stages[static_cast<std::size_t>(now.stage)].rows;
  const QString row = tr("row %1 of %2").arg(std::min(now.rowsTaken + 1, rows)).arg(rows);
  const QString fieldText = teslaText(now.target);
  const QString celsius = peopleNumber(now.target) + tr(" °C");
  switch (now.action) {
  case devices::FieldAction::None:
    return {};
  case devices::FieldAction::Placing:
    return tr("The probe is being placed.");
  case devices::FieldAction::SettingField:
    return tr("Setting the field to %1.").arg(fieldText);
  case devices::FieldAction::SettlingProbe:
    return tr("The probe is settling at %1.").arg(celsius);
  case devices::FieldAction::SettlingElectronics:
    return tr("The electronics are settling at %1.").arg(celsius);
  case devices::FieldAction::WaitingForLock:
    return tr("Waiting for the reference to lock at %1.").arg(fieldText);
  case devices::FieldAction::TakingRows:
    return tr("Reading at %1, %2.").arg(fieldText, row);
  case devices::FieldAction::SweepingProbe:
    return tr("Sweeping the probe, now at %1, %2.").arg(celsius, row);
  case devices::FieldAction::SweepingElectronics:
    return tr("Sweeping the electronics, now at %1, %2.").arg(celsius, row);
  }
  return {};
}

/// Expected for what is missing; the rows of the present plateau or sweep count.
double FieldCapturePresenter::leftS() const {
  double seconds = 0.0;
  const auto& all = stageProgress();
  for (std::size_t i = 0; i < all.size() && i < m_shownPlan.stages.size(); ++i) {
    seconds += remainingS(m_shownPlan, i, all[i]);
  }
  if (const int stage = presentStage(); stage >= 0 && static_cast<std::size_t>(stage) < m_shownPlan.stages.size()) {
    seconds -= m_bench.progress().rowsTaken * m_shownPlan.stages[static_cast<std::size_t>(stage)].rowS;
  }
  return std::max(seconds, 0.0);
}

double FieldCapturePresenter::progressFraction() const {
  double all = 0.0;
  for (std::size_t i = 0; i < m_shownPlan.stages.size(); ++i) {
    all += isLeftOut(static_cast<int>(i)) ? 0.0 : devices::expectedS(m_shownPlan, m_shownPlan.stages[i]);
  }
  return all > 0.0 ? std::clamp(1.0 - leftS() / all, 0.0, 1.0) : 0.0;
}

QString FieldCapturePresenter::progressText() const {
  qint64 done = 0;
  qint64 planned = 0;
  for (const devices::FieldStageProgress& stage : stageProgress()) {
    done += stage.skipped ? 0 : stage.pointsDone;
    planned += stage.skipped ? 0 : stage.pointsPlanned;
  }
  QString text = tr("%1 of %2 plateaus and sweeps").arg(countText(done), countText(planned));
  if (m_bench.isCapturing() && m_bench.inRealTime()) {
    text += tr(", %1 left").arg(durationText(leftS()));
  }
  return text;
}

QString FieldCapturePresenter::rowsText() const {
  QString text = tr("%1 rows").arg(countText(static_cast<qint64>(samples().size())));
  const devices::FieldCaptureProgress& progress = m_bench.progress();
  if (m_live && progress.samplesLost > 0) {
    text += tr(" (%1 more are stored but not drawn)").arg(countText(progress.samplesLost));
  }
  if (m_bench.isCapturing() && progress.retried > 0) {
    text += tr(", %1 readings asked for again after a time-out").arg(progress.retried);
  }
  return text;
}

void FieldCapturePresenter::setProblem(const QString& problem) {
  if (problem != m_problem) {
    m_problem = problem;
    emit problemChanged();
  }
}

bool FieldCapturePresenter::isComplete() const { return !m_bench.isCapturing() && m_finished; }

QString FieldCapturePresenter::nextStep() const {
  if (m_bench.isCapturing() || m_document.campaign().rows.empty()) {
    return {};
  }
  return m_freshDone ? tr("Verify") : tr("Review");
}

QString FieldCapturePresenter::guidance() const {
  switch (m_phase) {
  case Phase::NoBench:
    return tr("No bench is connected. Go to the step Connect first, or open recorded data instead of capturing.");
  case Phase::Interrupted:
    return tr("This calibration holds the beginning of a campaign: %1. Go on where it stopped, or start over.")
        .arg(progressText());
  case Phase::Faulted:
    return tr("The capture is paused and every row so far is stored. Mend the fault, then resume, measure the stage "
              "again, or leave it out and resume.");
  case Phase::Unplugged:
    return tr("An instrument is gone; every row so far is stored. Plug it in again: the capture goes on by itself.");
  case Phase::Paused:
    return tr("Paused. Every row so far is stored.");
  case Phase::Running:
  case Phase::Waiting:
    return {};
  case Phase::Ready:
    break;
  }
  if (m_freshDone) {
    return tr("The fresh campaign is recorded. Go on to Verify.");
  }
  if (m_finished) {
    return tr("The campaign is complete. Choose a stage to measure it again, or go on to Review.");
  }
  return tr("Choose the plan and what to leave out, then start.");
}

void FieldCapturePresenter::showStage(int stage) {
  if (m_bench.isCapturing() || stage == m_shownStage || stage < 0 ||
      static_cast<std::size_t>(stage) >= m_shownPlan.stages.size()) {
    return;
  }
  m_shownStage = stage;
  rebuildTrace();
}

void FieldCapturePresenter::rebuildTrace() {
  ++m_traceRevision;
  if (m_shownStage >= 0 && static_cast<std::size_t>(m_shownStage) < m_shownPlan.stages.size()) {
    m_trace.setStage(m_shownPlan.stages[static_cast<std::size_t>(m_shownStage)], m_shownStage);
    m_trace.add(samples());
  } else {
    m_trace.clear();
  }
  emit traceChanged();
}

void FieldCapturePresenter::followPresent() {
  if (const int present = presentStage(); present >= 0 && present != m_shownStage) {
    m_shownStage = present;
    rebuildTrace();
  }
}

void FieldCapturePresenter::onSamples(int firstNew) {
  if (firstNew == 0) {
    if (!m_bench.isCapturing()) {
      return; // another session was opened: see reload()
    }
    m_live = true;
    m_freshDone = false;
    m_stored.clear();
    m_finished = false;
    m_shownPlan = m_bench.capturePlan();
    m_recorded = progressBySamples(m_shownPlan, m_bench.liveSamples(), false);
    m_shownStage = m_shownPlan.stages.empty() ? -1 : 0;
    rebuildTrace();
    emit stagesChanged();
    emit planChanged();
    return;
  }
  const std::vector<session::FieldSample>& all = m_bench.liveSamples();
  const int present = presentStage();
  if (present >= 0 && present != m_shownStage) {
    followPresent(); // takes all rows in
  } else {
    m_trace.add(std::span(all).subspan(static_cast<std::size_t>(firstNew)));
    ++m_traceRevision;
  }
}

void FieldCapturePresenter::onProgress() {
  followPresent();
  refreshPhase();
  emit progressChanged();
}

void FieldCapturePresenter::onEnded(session::SweepRole role) {
  m_freshDone = role == session::SweepRole::Verification && m_bench.progress().state == devices::CaptureState::Finished;
  showRecorded();
  refreshPhase();
  emit planChanged();
  emit phaseChanged();
}

} // namespace straightedge::gui
