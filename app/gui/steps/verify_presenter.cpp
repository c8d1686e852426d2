#include "app/gui/steps/verify_presenter.h"

#include "app/gui/figures/figure_parts.h"
#include "app/gui/figures/report_tables.h"
#include "app/gui/figures/verification_figures.h"
#include "app/gui/jobs/job_runner.h"
#include "core/angle/sweep_csv.h"

#include <algorithm>

namespace straightedge::gui {

namespace {

constexpr int defaultPoints = 72;
constexpr int fewestPoints = 8;
constexpr int mostPoints = 3600;

} // namespace

VerifyPresenter::VerifyPresenter(AngleDocument& document, BenchLink& bench, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_bench(bench), m_jobs(jobs), m_points(defaultPoints) {
  connect(&document, &AngleDocument::opened, this, [this] {
    m_problem.clear();
    emit changed();
  });
  connect(&document, &AngleDocument::runChanged, this, &VerifyPresenter::changed);
  connect(&document, &AngleDocument::choicesChanged, this, &VerifyPresenter::changed);
  connect(&document, &AngleDocument::verificationSweepChanged, this, &VerifyPresenter::changed);
  connect(&document, &AngleDocument::verificationChanged, this, &VerifyPresenter::changed);
  connect(&bench, &BenchLink::connectionChanged, this, &VerifyPresenter::changed);
  connect(&bench, &BenchLink::progressChanged, this, [this] {
    if (m_capturing) {
      emit progressChanged();
    }
  });
  connect(&bench, &BenchLink::captureEnded, this, [this](session::SweepRole role) {
    if (role == session::SweepRole::Verification) {
      m_capturing = false;
      const devices::CaptureProgress progress = m_bench.progress();
      setProblem(progress.error ? fromText(progress.error->message()) : QString());
    } else {
      emit changed(); // the bench is free again
    }
  });
  connect(&bench, &BenchLink::failed, this, [this](const QString& message) {
    if (m_capturing) {
      setProblem(message);
    }
  });
}

QStringList VerifyPresenter::models() const {
  QStringList names;
  for (const angle::ModelName& name : m_document.choices().models) {
    names << modelNameText(name);
  }
  const QString selected = modelNameText(m_document.choices().selected);
  if (!names.contains(selected)) {
    names << selected;
  }
  return names;
}

int VerifyPresenter::selectedModel() const {
  return static_cast<int>(models().indexOf(modelNameText(m_document.choices().selected)));
}

void VerifyPresenter::selectModel(int place) {
  AngleChoices choices = m_document.choices();
  if (place < 0 || place >= static_cast<int>(choices.models.size())) {
    return; // the last entry may be the selected model itself, which Fit does not list
  }
  choices.selected = choices.models[static_cast<std::size_t>(place)];
  if (choices != m_document.choices()) {
    m_document.setChoices(choices, tr("Choose %1").arg(modelNameText(choices.selected)));
  }
}

double VerifyPresenter::limitDeg() const { return m_document.choices().limitDeg; }

void VerifyPresenter::setLimitDeg(double limitDeg) {
  AngleChoices choices = m_document.choices();
  choices.limitDeg = limitDeg;
  if (limitDeg > 0.0 && choices != m_document.choices()) {
    m_document.setChoices(choices, tr("Set the limit"));
  }
}

void VerifyPresenter::setPoints(int points) {
  m_points = std::clamp(points, fewestPoints, mostPoints);
  emit changed();
}

devices::AnglePlan VerifyPresenter::plan() const {
  devices::AnglePlan fresh = m_document.plan();
  // half a step of the calibration's plan away from its points
  fresh.startDeg += 180.0 / std::max(1, fresh.pointsPerTurn);
  fresh.pointsPerTurn = m_points;
  fresh.turns = 1;
  fresh.bothDirections = false;
  fresh.sampleRateHz = 0.0;
  return fresh;
}

QString VerifyPresenter::captureProblem() const {
  if (!m_bench.isConnected()) {
    return tr("No bench is connected: choose one in the step Connect.");
  }
  if (m_bench.isCapturing()) {
    return tr("A capture is running.");
  }
  return missing();
}

void VerifyPresenter::capture() {
  if (!captureProblem().isEmpty()) {
    return;
  }
  m_capturing = true;
  const Result<void> started = m_bench.startCapture(plan(), session::SweepRole::Verification, false);
  if (!started) {
    m_capturing = false;
  }
  setProblem(started ? QString() : fromText(started.error().message()));
}

void VerifyPresenter::stopCapture() {
  if (m_capturing) {
    m_bench.stopCapture();
  }
}

bool VerifyPresenter::isCapturing() const { return m_capturing; }

double VerifyPresenter::progress() const {
  const devices::CaptureProgress progress = m_bench.progress();
  return progress.pointsPlanned > 0 ? static_cast<double>(progress.pointsDone) / progress.pointsPlanned : 0.0;
}

QString VerifyPresenter::progressText() const {
  const devices::CaptureProgress progress = m_bench.progress();
  QString text = tr("%1 of %2 points").arg(progress.pointsDone).arg(progress.pointsPlanned);
  if (progress.remainingS) {
    text += tr(", %1 s left").arg(qRound(*progress.remainingS));
  }
  return text;
}

void VerifyPresenter::loadCsv(const QString& file) {
  m_jobs.run<angle::Sweep>(
      QStringLiteral("load-verification"), tr("Reading the sweep"),
      [path = file.toStdString()](const JobControl&) { return angle::readSweepCsv(path); },
      [this](Result<angle::Sweep> sweep) {
        if (sweep) {
          m_document.setVerificationSweep(std::move(*sweep));
        }
        setProblem(sweep ? QString() : fromText(sweep.error().message()));
      });
}

QString VerifyPresenter::sweepText() const {
  const angle::Sweep& sweep = m_document.verificationSweep();
  if (sweep.size() == 0) {
    return {};
  }
  const QString from = sweep.source.file.empty() ? tr("Captured on the bench") : fromText(sweep.source.file);
  return tr("%1, %2 readings").arg(from).arg(sweep.size());
}

VerifyPresenter::Outcome VerifyPresenter::outcome() const {
  if (!m_document.verification()) {
    return Outcome::None;
  }
  switch (m_document.verification()->verdict) {
  case angle::Verdict::Pass:
    return Outcome::Passed;
  case angle::Verdict::PassWithinUncertainty:
    return Outcome::PassedInDoubt;
  case angle::Verdict::Fail:
    return Outcome::Failed;
  case angle::Verdict::FailWithinUncertainty:
    return Outcome::FailedInDoubt;
  }
  return Outcome::None;
}

QString VerifyPresenter::verdictText() const {
  if (m_document.verification()) {
    return verdictSentence(*m_document.verification());
  }
  if (m_document.verificationError()) {
    return fromText(m_document.verificationError()->message());
  }
  if (const QString first = missing(); !first.isEmpty()) {
    return first;
  }
  return m_document.verificationSweep().size() == 0 ? tr("Take a fresh sweep, or load one: it shows what the "
                                                         "correction is worth on data it was not made from.")
                                                    : tr("The sweep is being verified.");
}

QString VerifyPresenter::ruleText() const {
  return m_document.verification() ? fromText(m_document.verification()->decisionRule) : QString();
}

PlotSpec VerifyPresenter::beforeAfter() const {
  return m_document.verification() ? beforeAfterFigure(*m_document.verification())
                                   : emptyFigure(tr("Error before and after correction"),
                                                 turnAxis(tr("Encoder angle (°)")), dataAxis(tr("Error (°)")), {});
}

PlotSpec VerifyPresenter::corrected() const {
  return m_document.verification() ? correctedErrorFigure(*m_document.verification())
                                   : emptyFigure(tr("Error after correction"), turnAxis(tr("Encoder angle (°)")),
                                                 dataAxis(tr("Error after correction (°)")), {});
}

ReportTable VerifyPresenter::table() const {
  return m_document.verification() ? verificationTable(*m_document.verification()) : ReportTable{};
}

QString VerifyPresenter::missing() const {
  if (m_document.run()) {
    return {};
  }
  return m_document.sweep().size() == 0 ? tr("There is no calibration yet: capture a sweep or import a CSV file first.")
                                        : tr("The calibration is not computed: see the step Fit.");
}

QString VerifyPresenter::problem() const { return m_problem; }

void VerifyPresenter::setProblem(const QString& problem) {
  m_problem = problem;
  emit changed();
}

} // namespace straightedge::gui
