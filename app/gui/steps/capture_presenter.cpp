#include "app/gui/steps/capture_presenter.h"

#include "app/gui/document/angle_document.h"
#include "app/gui/document/capture_record.h"
#include "app/gui/steps/capture_words.h"

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

// What an instrument takes to answer; only the estimate of the duration depends on it.
constexpr double readingS = 0.002;

int stationsOf(const devices::AnglePlan& plan) {
  return plan.pointsPerTurn * plan.turns * (plan.bothDirections ? 2 : 1);
}

QString noteSentence(const std::string& note) {
  QString text = QString::fromStdString(note);
  if (!text.isEmpty()) {
    text = text.at(0).toUpper() + text.mid(1) + QLatin1Char('.');
  }
  return text;
}

} // namespace

CapturePresenter::CapturePresenter(AngleDocument& document, BenchLink& bench, QObject* parent)
    : QObject(parent), m_document(document), m_bench(bench) {
  connect(&document, &AngleDocument::opened, this, &CapturePresenter::reload);
  connect(&document, &AngleDocument::planChanged, this, [this] {
    refreshPhase();
    emit planChanged();
  });
  connect(&document, &AngleDocument::sweepChanged, this, &CapturePresenter::phaseChanged);
  connect(&bench, &BenchLink::connectionChanged, this, [this] {
    setProblem({});
    refreshPhase();
    emit phaseChanged();
    emit planChanged(); // its duration depends on the bench
  });
  connect(&bench, &BenchLink::samplesArrived, this, &CapturePresenter::onSamples);
  connect(&bench, &BenchLink::progressChanged, this, &CapturePresenter::onProgress);
  connect(&bench, &BenchLink::captureEnded, this, [this](session::SweepRole role) {
    if (role == session::SweepRole::Verification) {
      showStoredSamples(); // the fresh sweep is shown in Verify
    }
    refreshPhase();
    emit phaseChanged();
  });
  connect(&bench, &BenchLink::failed, this, &CapturePresenter::setProblem);
  reload();
}

void CapturePresenter::reload() {
  setProblem({});
  showStoredSamples();
  refreshPhase();
  emit planChanged();
  emit phaseChanged();
}

void CapturePresenter::showStoredSamples() {
  m_stored.clear();
  m_readings = 0;
  const session::Session* session = m_document.session();
  const std::optional<CaptureRecord> record =
      session == nullptr ? std::nullopt : readCaptureRecord(*session, session::SweepRole::Calibration);
  m_shownPlan = record ? record->plan : m_document.plan();
  m_points.setPlan(m_shownPlan);
  m_trace.clear();
  if (record) {
    m_stored = session->angleSamples(session::SweepRole::Calibration).value_or(std::vector<session::AngleSample>{});
    m_readings = static_cast<qint64>(m_stored.size());
    m_trace.add(m_stored, 0);
    m_points.add(m_stored, [this](const auto& sample) { return m_trace.errorDeg(sample); });
    m_points.flush();
  }
  emit samplesArrived(0);
}

void CapturePresenter::refreshPhase() {
  const devices::CaptureProgress progress = m_bench.progress();
  m_interrupted = m_bench.interruptedPlan(session::SweepRole::Calibration);
  Phase phase = m_interrupted ? Phase::Interrupted : Phase::Ready;
  if (!m_bench.isConnected()) {
    phase = Phase::NoBench;
  } else if (m_bench.isCapturing()) {
    phase = progress.state != devices::CaptureState::Paused ? Phase::Running
            : progress.waitsForInstrument                   ? Phase::Waiting
            : progress.error                                ? Phase::Faulted
                                                            : Phase::Paused;
  }
  // The table shows the plan that readings belong to; before there are any, the plan being edited.
  const bool untouched = m_points.measuredPoints() == 0 && !m_bench.isCapturing();
  if (const devices::AnglePlan& wanted = plan(); untouched && !(wanted == m_shownPlan)) {
    m_shownPlan = wanted;
    m_points.setPlan(wanted);
    emit samplesArrived(0);
  }
  if (phase != m_phase) {
    if (m_phase == Phase::Waiting && phase == Phase::Running) {
      setProblem({}); // the instrument is back
    }
    m_phase = phase;
    emit phaseChanged();
  }
}

CapturePresenter::Phase CapturePresenter::phase() const { return m_phase; }

const devices::AnglePlan& CapturePresenter::plan() const {
  if (m_bench.isCapturing()) {
    return m_bench.capturePlan();
  }
  return m_document.plan();
}

void CapturePresenter::setPlan(const devices::AnglePlan& plan) { m_document.setPlan(plan); }

QString CapturePresenter::planProblem() const {
  const Result<void> checked = devices::checkPlan(plan());
  return checked ? QString() : QString::fromStdString(checked.error().message());
}

double CapturePresenter::plannedDurationS() const {
  const devices::AnglePlan& planned = plan();
  const double speed = m_bench.simulatedSettings().stageSpeedDegPerS;
  const double turning = 360.0 * planned.turns * (planned.bothDirections ? 2.0 : 1.0) / speed;
  if (planned.sampleRateHz > 0.0) {
    return turning;
  }
  return turning + stationsOf(planned) * (planned.settleS + planned.averages * readingS);
}

QString CapturePresenter::turnByHand() const {
  if (m_bench.hasStage() || m_shownPlan.sampleRateHz > 0.0) { // a shaft that turns on is guided by the capture's note
    return {};
  }
  const std::vector<devices::PlannedPoint>& planned = m_points.planned(); // of m_shownPlan
  const auto done = static_cast<std::size_t>(std::max(0, m_bench.progress().pointsDone));
  if (done >= planned.size()) {
    return {};
  }
  const QString target = QString::number(planned[done].encoderDeg, 'f', 2).replace(QLatin1Char('-'), QChar(0x2212));
  return tr("Turn the shaft to %1° and hold it still; the point is read by itself.").arg(target);
}

QString CapturePresenter::planSummary() const {
  const devices::AnglePlan& planned = plan();
  const bool virtualClock = m_bench.isSimulated() && !m_bench.simulatedSettings().realTime;
  const bool byHand = m_bench.isConnected() && !m_bench.hasStage();
  const QString duration = byHand         ? tr("the shaft is turned by hand")
                           : virtualClock ? tr("as fast as the computer can")
                                          : tr("about %1").arg(durationText(plannedDurationS()));
  if (planned.sampleRateHz > 0.0) {
    const qint64 readings = std::llround(plannedDurationS() * planned.sampleRateHz);
    return tr("About %1 readings, %2").arg(countText(readings), duration);
  }
  const qint64 readings = static_cast<qint64>(stationsOf(planned)) * planned.averages;
  return tr("%1 points, %2 readings, %3").arg(countText(stationsOf(planned)), countText(readings), duration);
}

bool CapturePresenter::canStart() const {
  return (m_phase == Phase::Ready || m_phase == Phase::Interrupted) && planProblem().isEmpty();
}

bool CapturePresenter::startReplacesData() const { return m_document.sweep().size() > 0 || !m_stored.empty(); }

QString CapturePresenter::replaceQuestion() const {
  const auto readings = std::max(m_document.sweep().size(), m_stored.size());
  return tr("This calibration holds %1 readings. A new sweep replaces them; this cannot be undone.")
      .arg(countText(static_cast<qint64>(readings)));
}

void CapturePresenter::start() {
  if (!canStart()) {
    return;
  }
  setProblem({});
  if (const Result<void> begun = m_bench.startCapture(m_document.plan(), session::SweepRole::Calibration, false);
      !begun) {
    setProblem(QString::fromStdString(begun.error().message()));
  }
  refreshPhase();
}

bool CapturePresenter::canContinueInterrupted() const { return m_phase == Phase::Interrupted; }

void CapturePresenter::continueInterrupted() {
  if (!m_interrupted) {
    return;
  }
  setProblem({});
  const devices::AnglePlan begunPlan = *m_interrupted;
  if (const Result<void> begun = m_bench.startCapture(begunPlan, session::SweepRole::Calibration, true); !begun) {
    setProblem(QString::fromStdString(begun.error().message()));
  }
  refreshPhase();
}

bool CapturePresenter::canPause() const { return m_phase == Phase::Running; }

void CapturePresenter::pause() { m_bench.pauseCapture(); }

bool CapturePresenter::canResume() const { return m_phase == Phase::Paused || m_phase == Phase::Faulted; }

void CapturePresenter::resume() {
  setProblem({});
  m_bench.resumeCapture();
}

bool CapturePresenter::canStop() const { return m_bench.isCapturing(); }

void CapturePresenter::stop() { m_bench.stopCapture(); }

bool CapturePresenter::canRedo(std::optional<int> planPoint) const {
  return planPoint && m_bench.isConnected() && m_phase != Phase::Interrupted && m_points.isMeasured(*planPoint);
}

void CapturePresenter::redo(int planPoint) {
  if (canRedo(planPoint)) {
    setProblem({});
    m_bench.redoPoint(planPoint);
    refreshPhase();
  }
}

bool CapturePresenter::isComplete() const { return m_phase == Phase::Ready && m_points.measuredPoints() > 0; }

QString CapturePresenter::nextStep() const {
  return isComplete() || m_phase == Phase::Interrupted ? tr("Review") : QString();
}

double CapturePresenter::progressFraction() const {
  if (m_bench.isCapturing()) {
    const devices::CaptureProgress progress = m_bench.progress();
    return progress.pointsPlanned > 0 ? static_cast<double>(progress.pointsDone) / progress.pointsPlanned : 0.0;
  }
  const int planned = stationsOf(m_shownPlan);
  return planned > 0 ? static_cast<double>(m_points.measuredPoints()) / planned : 0.0;
}

QString CapturePresenter::progressText() const {
  if (!m_bench.isCapturing()) {
    return m_points.measuredPoints() == 0
               ? QString()
               : tr("%1 of %2 points").arg(countText(m_points.measuredPoints()), countText(stationsOf(m_shownPlan)));
  }
  const devices::CaptureProgress progress = m_bench.progress();
  QString text = tr("%1 of %2 points").arg(countText(progress.pointsDone), countText(progress.pointsPlanned));
  if (progress.remainingS && (!m_bench.isSimulated() || m_bench.simulatedSettings().realTime)) {
    text += tr(", %1 left").arg(durationText(*progress.remainingS));
  }
  return text;
}

QString CapturePresenter::samplesText() const {
  const devices::CaptureProgress progress = m_bench.progress();
  QString text = m_readings == 1 ? tr("1 reading") : tr("%1 readings").arg(countText(m_readings));
  if (progress.samplesLost > 0 && m_bench.captureRole() == session::SweepRole::Calibration) {
    text += tr(" (%1 more are stored but not drawn)").arg(countText(progress.samplesLost));
  }
  return text;
}

QString CapturePresenter::problem() const { return m_problem; }

void CapturePresenter::setProblem(const QString& problem) {
  if (problem != m_problem) {
    m_problem = problem;
    emit problemChanged();
  }
}

QString CapturePresenter::guidance() const {
  switch (m_phase) {
  case Phase::NoBench:
    return tr("No bench is connected. Go to the step Connect first, or open recorded data instead of capturing.");
  case Phase::Interrupted:
    return tr("This calibration holds the beginning of a sweep: %1 of %2 points. Go on where it stopped, or start "
              "over.")
        .arg(countText(m_points.measuredPoints()), countText(stationsOf(*m_interrupted)));
  case Phase::Waiting:
    return tr("The capture waits for the instrument that was unplugged. Every reading so far is stored; the sweep goes "
              "on by itself at the same point when it is back, at whatever port.");
  case Phase::Faulted:
    return tr("The capture is paused and every reading so far is stored. Mend the fault, then resume.");
  case Phase::Paused:
    return tr("Paused. Every reading so far is stored.");
  case Phase::Running:
    return m_note.isEmpty() ? turnByHand() : m_note;
  case Phase::Ready:
    break;
  }
  if (isComplete()) {
    return tr("The sweep is complete. Select a point to measure it again, or go on to Review.");
  }
  return tr("Choose the plan, then start.");
}

void CapturePresenter::onSamples(int firstNew) {
  if (m_bench.captureRole() == session::SweepRole::Verification) {
    return; // Verify shows those
  }
  const std::vector<session::AngleSample>& all = m_bench.liveSamples();
  if (firstNew == 0) {
    m_stored.clear(); // from here on the bench link's samples are shown
    m_shownPlan = plan();
    m_points.setPlan(m_shownPlan);
    m_trace.clear();
  }
  m_readings = static_cast<qint64>(all.size());
  const auto first = static_cast<std::size_t>(firstNew);
  m_trace.add(all, first);
  m_points.add(std::span(all).subspan(first), [this](const auto& sample) { return m_trace.errorDeg(sample); });
  emit samplesArrived(firstNew);
}

std::span<const session::AngleSample> CapturePresenter::samplesFrom(int first) const {
  const bool live = m_stored.empty() && m_bench.captureRole() == session::SweepRole::Calibration;
  const std::span<const session::AngleSample> all = live ? std::span(m_bench.liveSamples()) : std::span(m_stored);
  return all.subspan(std::min(static_cast<std::size_t>(first), all.size()));
}

void CapturePresenter::onProgress() {
  refreshPhase();
  m_note = noteSentence(m_bench.progress().note);
  if (const QString now = guidance(); now != m_guidance) { // the next angle of a shaft turned by hand, a note
    m_guidance = now;
    emit guidanceChanged();
  }
  emit progressChanged();
}

} // namespace straightedge::gui
