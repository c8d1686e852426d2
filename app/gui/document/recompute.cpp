#include "app/gui/document/recompute.h"

#include "app/gui/document/same_traceability.h"
#include "app/gui/jobs/job_runner.h"
#include "core/angle/sweep_csv.h"
#include "core/base/sha256.h"

#include <QDateTime>

#include <algorithm>
#include <utility>

namespace straightedge::gui {

namespace {
// Keys of the jobs: a new one of a key overtakes the one that still runs.
const QString calibrateJob = QStringLiteral("calibrate");
const QString compareJob = QStringLiteral("compare");
const QString compareRestJob = QStringLiteral("compare-fully");
const QString verifyJob = QStringLiteral("verify");

/// The models that Fit shows, and the selected one, which Verify needs even where Fit does not show it.
std::vector<angle::ModelName> wantedModels(const AngleChoices& choices) {
  auto models = choices.models;
  if (std::find(models.begin(), models.end(), choices.selected) == models.end()) {
    models.push_back(choices.selected);
  }
  return models;
}

/// A captured sweep has no file whose bytes could be hashed: its canonical CSV stands for them, as on the command line.
void traceSource(SourceRecord& source, const angle::Sweep& sweep, const std::string& fileName) {
  if (source.sha256.empty()) {
    source.sha256 = sha256Hex(angle::sweepToCsv(sweep));
  }
  if (source.file.empty()) {
    source.file = fileName;
  }
}

bool sameSweep(const std::shared_ptr<const angle::Sweep>& a, const std::shared_ptr<const angle::Sweep>& b) {
  return a == b;
}
} // namespace

Recompute::Recompute(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {
  m_soon.setSingleShot(true);
  m_soon.setInterval(0);
  connect(&m_soon, &QTimer::timeout, this, &Recompute::start);
}

Recompute::~Recompute() {
  for (const QString& key : {calibrateJob, compareJob, compareRestJob, verifyJob}) {
    m_jobs.cancel(key); // their results would come back to nobody
  }
}

void Recompute::setInputs(RecomputeInputs inputs) {
  const bool runStale = !sameSweep(inputs.sweep, m_inputs.sweep) ||
                        inputs.choices.curveMethod != m_inputs.choices.curveMethod ||
                        wantedModels(inputs.choices) != wantedModels(m_inputs.choices) ||
                        !sameTraceability(inputs.traceability, m_inputs.traceability);
  const bool comparisonStale = inputs.choices.bits != m_inputs.choices.bits;
  const bool verificationStale = !sameSweep(inputs.verificationSweep, m_inputs.verificationSweep) ||
                                 inputs.choices.selected != m_inputs.choices.selected ||
                                 inputs.choices.limitDeg != m_inputs.choices.limitDeg;
  m_inputs = std::move(inputs);
  m_runStale = m_runStale || runStale;
  m_verificationStale = m_verificationStale || verificationStale;
  if (runStale || comparisonStale || verificationStale) {
    m_soon.start();
  }
}

void Recompute::clear() {
  m_soon.stop();
  for (const QString& key : {calibrateJob, compareJob, compareRestJob, verifyJob}) {
    m_jobs.cancel(key);
  }
  m_inputs = {};
  m_runStale = m_verificationStale = false;
  dropRun(std::nullopt);
  dropVerification();
}

void Recompute::start() {
  if (std::exchange(m_runStale, false)) {
    calibrate(); // comparison and verification follow from its result
    return;
  }
  if (m_jobs.isRunning(calibrateJob)) {
    return;
  }
  if (run) {
    compare();
  }
  if (std::exchange(m_verificationStale, false)) {
    verifyFreshSweep();
  }
}

void Recompute::calibrate() {
  if (!m_inputs.sweep || m_inputs.sweep->size() == 0) {
    m_jobs.cancel(calibrateJob);
    dropRun(std::nullopt);
    dropVerification();
    return;
  }
  using Run = std::shared_ptr<const angle::CalibrationRun>;
  angle::CalibrationOptions options{wantedModels(m_inputs.choices), {m_inputs.choices.curveMethod}};
  m_jobs.run<Run>(
      calibrateJob, tr("Fitting"),
      [sweep = m_inputs.sweep, options = std::move(options), traceability = m_inputs.traceability,
       fileName = m_inputs.fileName](const JobControl&) -> Result<Run> {
        auto result = angle::calibrate(*sweep, options, traceability);
        if (!result) {
          return std::unexpected(std::move(result.error()));
        }
        traceSource(result->result.source, *sweep, fileName);
        result->result.created = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
        return std::make_shared<const angle::CalibrationRun>(std::move(*result));
      },
      [this](Result<Run> result) { takeRun(std::move(result)); });
}

void Recompute::takeRun(Result<std::shared_ptr<const angle::CalibrationRun>> result) {
  if (!result) {
    dropRun(std::move(result.error()));
    dropVerification();
    return;
  }
  run = std::move(*result);
  runError.reset();
  emit runChanged();
  compare();
  m_verificationStale = false;
  verifyFreshSweep();
}

void Recompute::compare() {
  const ComparisonKey key{m_inputs.sweep, m_inputs.choices.curveMethod, m_inputs.choices.bits};
  if (m_compared == key) {
    return;
  }
  m_compared = key;
  m_jobs.cancel(compareRestJob);
  using Shared = std::shared_ptr<const angle::Comparison>;
  m_jobs.run<Shared>(
      compareJob, tr("Comparing storage"),
      [from = run, bits = key.bits](const JobControl&) -> Result<Shared> {
        return std::make_shared<const angle::Comparison>(angle::compareQuick(from->curve, {bits}));
      },
      [this](Result<Shared> result) {
        if (!result) {
          m_compared.reset();
          return;
        }
        comparison = std::move(*result);
        comparisonComplete = false;
        emit comparisonChanged();
        compareRest();
      });
}

void Recompute::compareRest() {
  using Shared = std::shared_ptr<const angle::Comparison>;
  m_jobs.run<Shared>(
      compareRestJob, tr("Comparing minimax and fine tables"),
      [from = run, bits = m_inputs.choices.bits](const JobControl& control) -> Result<Shared> {
        auto full = angle::compareFully(from->curve, {bits}, control);
        if (!full) {
          return std::unexpected(std::move(full.error()));
        }
        return std::make_shared<const angle::Comparison>(std::move(*full));
      },
      [this](Result<Shared> result) {
        if (result) {
          comparison = std::move(*result);
          comparisonComplete = true;
          emit comparisonChanged();
        }
      });
}

void Recompute::verifyFreshSweep() {
  const auto fresh = m_inputs.verificationSweep;
  if (!run || !fresh || fresh->size() == 0) {
    dropVerification();
    return;
  }
  const auto& models = run->result.models;
  const auto model = std::find_if(models.begin(), models.end(),
                                  [&](const angle::Model& m) { return m.name == m_inputs.choices.selected; });
  if (model == models.end()) {
    dropVerification();
    return;
  }
  m_jobs.run<angle::VerificationReport>(
      verifyJob, tr("Verifying"),
      [from = run, index = model - models.begin(), fresh, limit = m_inputs.choices.limitDeg](const JobControl&) {
        return angle::verify(from->result, from->result.models[static_cast<std::size_t>(index)], *fresh, limit);
      },
      [this](Result<angle::VerificationReport> result) {
        verification.reset();
        verificationError.reset();
        if (result) {
          verification = std::move(*result);
        } else {
          verificationError = std::move(result.error());
        }
        emit verificationChanged();
      });
}

void Recompute::dropRun(std::optional<Error> why) {
  m_jobs.cancel(compareJob);
  m_jobs.cancel(compareRestJob);
  m_compared.reset();
  const bool hadComparison = std::exchange(comparison, nullptr) != nullptr;
  const bool changed = run || runError || why;
  comparisonComplete = false;
  run.reset();
  runError = std::move(why);
  if (changed) {
    emit runChanged();
  }
  if (hadComparison) {
    emit comparisonChanged();
  }
}

void Recompute::dropVerification() {
  m_jobs.cancel(verifyJob);
  if (verification || verificationError) {
    verification.reset();
    verificationError.reset();
    emit verificationChanged();
  }
}

} // namespace straightedge::gui
