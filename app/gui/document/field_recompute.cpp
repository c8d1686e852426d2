#include "app/gui/document/field_recompute.h"

#include "app/gui/document/same_traceability.h"
#include "app/gui/jobs/job_runner.h"
#include "core/base/sha256.h"
#include "core/field/campaign_csv.h"

#include <QDateTime>

#include <algorithm>
#include <utility>

namespace straightedge::gui {

namespace {

// Keys of the jobs: a new one of a key overtakes the one that still runs.
const QString fieldFitJob = QStringLiteral("field-fit");
const QString fieldCompareJob = QStringLiteral("field-compare");
const QString fieldVerifyJob = QStringLiteral("field-verify");

std::optional<field::Block> blockOf(field::CampaignStep step) {
  switch (step) {
  case field::CampaignStep::Nonlinearity:
    return field::Block::Nonlinearity;
  case field::CampaignStep::ProbeTemperature:
    return field::Block::ProbeTemperature;
  case field::CampaignStep::Offset:
    return field::Block::Offset;
  case field::CampaignStep::Sensitivity:
    return field::Block::Sensitivity;
  case field::CampaignStep::Electronics:
    return field::Block::Electronics;
  case field::CampaignStep::ElectronicsSensitivity:
    return field::Block::ElectronicsSensitivity;
  case field::CampaignStep::Orientation:
    return field::Block::AxisMatrix;
  case field::CampaignStep::Verification:
    break;
  }
  return std::nullopt;
}

bool canVerifyWith(const field::Campaign& campaign) {
  return std::any_of(campaign.rows.begin(), campaign.rows.end(),
                     [](const field::CampaignRow& row) { return row.step == field::CampaignStep::Verification; });
}

/// A captured campaign has no file whose bytes could be hashed: its canonical CSV stands for them, as on the command
/// line.
SourceRecord sourceOf(const field::Campaign& campaign, const std::string& sessionName) {
  return {campaign.name.empty() ? sessionName : campaign.name,
          campaign.sha256.empty() ? sha256Hex(field::campaignCsv(campaign)) : campaign.sha256,
          static_cast<long long>(campaign.rows.size())};
}

} // namespace

field::Campaign countedRows(const field::Campaign& campaign, const std::vector<bool>& enabled,
                            const std::set<field::Block>& blocksOff) {
  field::Campaign counted{campaign.name, campaign.sha256, {}};
  counted.rows.reserve(campaign.rows.size());
  for (std::size_t i = 0; i < campaign.rows.size(); ++i) {
    const auto block = blockOf(campaign.rows[i].step);
    if ((i >= enabled.size() || enabled[i]) && (!block || !blocksOff.contains(*block))) {
      counted.rows.push_back(campaign.rows[i]);
    }
  }
  return counted;
}

FieldRecompute::FieldRecompute(JobRunner& jobs, QObject* parent) : QObject(parent), m_jobs(jobs) {
  m_soon.setSingleShot(true);
  m_soon.setInterval(0);
  connect(&m_soon, &QTimer::timeout, this, &FieldRecompute::start);
}

FieldRecompute::~FieldRecompute() {
  m_jobs.cancel(fieldFitJob); // their results would come back to nobody
  m_jobs.cancel(fieldCompareJob);
  m_jobs.cancel(fieldVerifyJob);
}

void FieldRecompute::setComparisonWanted(bool wanted) {
  m_comparisonWanted = wanted;
  compare();
}

void FieldRecompute::setInputs(FieldInputs inputs) {
  const auto& now = inputs.choices;
  const auto& before = m_inputs.choices;
  const bool runStale =
      inputs.campaign != m_inputs.campaign || inputs.enabled != m_inputs.enabled || now.order != before.order ||
      now.method != before.method || now.fullScaleT != before.fullScaleT ||
      now.referenceTemperatureC != before.referenceTemperatureC || now.blocksOff != before.blocksOff ||
      !sameTraceability(inputs.traceability, m_inputs.traceability);
  const bool verificationStale = inputs.verification != m_inputs.verification ||
                                 now.limitPercent != before.limitPercent || now.percentOf != before.percentOf;
  m_inputs = std::move(inputs);
  m_runStale = m_runStale || runStale;
  m_verificationStale = m_verificationStale || verificationStale;
  if (runStale || verificationStale) {
    m_soon.start();
  }
}

void FieldRecompute::clear() {
  m_soon.stop();
  m_jobs.cancel(fieldFitJob);
  m_jobs.cancel(fieldVerifyJob);
  m_inputs = {};
  m_runStale = m_verificationStale = false;
  dropRun(std::nullopt);
  dropVerification();
}

void FieldRecompute::start() {
  if (std::exchange(m_runStale, false)) {
    calibrate(); // the verification follows from its result
  } else if (!m_jobs.isRunning(fieldFitJob) && std::exchange(m_verificationStale, false)) {
    verify();
  }
}

void FieldRecompute::calibrate() {
  if (!m_inputs.campaign || m_inputs.campaign->rows.empty()) {
    m_jobs.cancel(fieldFitJob);
    dropRun(std::nullopt);
    dropVerification();
    return;
  }
  using Run = std::shared_ptr<const field::FieldRun>;
  m_jobs.run<Run>(
      fieldFitJob, tr("Fitting"),
      [inputs = m_inputs](const JobControl&) -> Result<Run> {
        const auto& choices = inputs.choices;
        const field::FieldFitOptions options{.order = choices.order,
                                             .method = choices.method,
                                             .fullScaleT = choices.fullScaleT,
                                             .referenceTemperatureC = choices.referenceTemperatureC};
        auto counted = countedRows(*inputs.campaign, *inputs.enabled, choices.blocksOff);
        if (counted.name.empty()) {
          counted.name = inputs.fileName; // for messages
        }
        auto result = field::calibrateField(counted, options, inputs.traceability);
        if (!result) {
          return std::unexpected(std::move(result.error()));
        }
        if (auto uncertainty = field::uncertaintyOf(*result)) {
          result->result.uncertainty = std::move(*uncertainty);
        } else {
          result->result.warnings.push_back(
              {field::Block::Nonlinearity, "No uncertainty is stated: " + uncertainty.error().what + "."});
        }
        result->result.source = sourceOf(*inputs.campaign, inputs.fileName);
        result->result.created = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
        return std::make_shared<const field::FieldRun>(std::move(*result));
      },
      [this](Result<Run> result) {
        if (!result) {
          dropRun(std::move(result.error()));
          dropVerification();
          return;
        }
        run = std::move(*result);
        runError.reset();
        comparisonIsCurrent = false;
        emit runChanged();
        compare();
        m_verificationStale = false;
        verify();
      });
}

void FieldRecompute::compare() {
  if (!m_comparisonWanted) {
    m_jobs.cancel(fieldCompareJob);
    if (!comparisonIsCurrent) {
      m_compared.reset(); // what was cancelled begins anew when it is wanted again
    }
    return;
  }
  if (!run || m_compared == run) {
    return;
  }
  m_compared = run;
  using Shared = std::shared_ptr<const field::StorageComparison>;
  m_jobs.run<Shared>(
      fieldCompareJob, tr("Comparing orders"),
      [from = run](const JobControl& control) -> Result<Shared> {
        auto compared = field::compareStorage(*from, control);
        if (!compared) {
          return std::unexpected(std::move(compared.error()));
        }
        return std::make_shared<const field::StorageComparison>(std::move(*compared));
      },
      [this](Result<Shared> result) {
        if (result) {
          comparison = std::move(*result);
          comparisonIsCurrent = true;
          emit comparisonChanged();
        }
      });
}

void FieldRecompute::verify() {
  const bool fresh = m_inputs.verification && !m_inputs.verification->rows.empty();
  if (!run || (!fresh && !canVerifyWith(*m_inputs.campaign))) {
    dropVerification();
    return;
  }
  m_jobs.run<field::LimitReport>(
      fieldVerifyJob, tr("Verifying"),
      [from = run, inputs = m_inputs, fresh](const JobControl&) {
        const auto& choices = inputs.choices;
        return field::verifyField(from->result.chain,
                                  fresh ? *inputs.verification : countedRows(*inputs.campaign, *inputs.enabled, {}),
                                  choices.limitPercent, choices.percentOf);
      },
      [this, fresh](Result<field::LimitReport> result) {
        verification.reset();
        verificationError.reset();
        verificationIsFresh = fresh;
        if (result) {
          verification = std::move(*result);
        } else {
          verificationError = std::move(result.error());
        }
        emit verificationChanged();
      });
}

void FieldRecompute::dropRun(std::optional<Error> why) {
  m_jobs.cancel(fieldCompareJob);
  m_compared.reset();
  comparisonIsCurrent = false;
  const bool hadComparison = std::exchange(comparison, nullptr) != nullptr;
  const bool changed = run || runError || why;
  run.reset();
  runError = std::move(why);
  if (changed) {
    emit runChanged();
  }
  if (hadComparison) {
    emit comparisonChanged();
  }
}

void FieldRecompute::dropVerification() {
  m_jobs.cancel(fieldVerifyJob);
  if (verification || verificationError) {
    verification.reset();
    verificationIsFresh = false;
    verificationError.reset();
    emit verificationChanged();
  }
}

} // namespace straightedge::gui
