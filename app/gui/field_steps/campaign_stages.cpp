#include "app/gui/field_steps/campaign_stages.h"

#include "app/gui/document/field_document.h"
#include "app/gui/field_steps/field_page_words.h"
#include "core/field/block_costs.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {

namespace {

QString sayStage(const char* text) { return QCoreApplication::translate("CampaignStages", text); }

bool isTemperatureSweep(field::CampaignStep step) {
  return step != field::CampaignStep::Nonlinearity && step != field::CampaignStep::Orientation &&
         step != field::CampaignStep::Verification;
}

bool blockIsOff(const FieldDocument& document, field::CampaignStep step) {
  return step != field::CampaignStep::Verification &&
         std::ranges::any_of(document.choices().blocksOff,
                             [step](field::Block block) { return field::stepOf(block) == step; });
}

/// Rows of the run that the fit takes into account.
std::vector<std::size_t> countedRowsOf(const CampaignRun& run, const FieldDocument& document, bool needsLock) {
  std::vector<std::size_t> rows;
  for (std::size_t row = run.first; row < run.first + run.count; ++row) {
    if (document.isRowEnabled(row) && (!needsLock || document.campaign().rows[row].locked)) {
      rows.push_back(row);
    }
  }
  return rows;
}

/// Why the fit rejected this plateau, or how much of it lies beyond the shortest; only the nonlinearity has both.
QString plateauRemark(const CampaignRun& run, const FieldDocument& document, const std::vector<std::size_t>& counted) {
  const std::shared_ptr<const field::FieldRun> fit = document.run();
  if (!fit || run.step != field::CampaignStep::Nonlinearity || !run.axis || counted.empty()) {
    return {};
  }
  const auto& report = fit->reports.nonlinearity[field::indexOf(*run.axis)];
  if (!report) {
    return {};
  }
  const std::int64_t line = document.campaign().rows[counted.front()].line;
  for (const field::RejectedPlateau& rejected : report->plateaus.rejected) {
    const bool here = line > 0 ? rejected.line == line
                               : std::abs(rejected.referenceT - run.referenceT) < field::plateauToleranceT &&
                                     rejected.rows == static_cast<Eigen::Index>(counted.size());
    if (here) {
      return sayStage("rejected: %1").arg(withProperMinus(QString::fromStdString(rejected.reason)));
    }
  }
  const auto each = static_cast<std::size_t>(report->plateaus.rowsEach);
  return each > 0 && counted.size() > each ? sayStage("%1 beyond the shortest plateau").arg(counted.size() - each)
                                           : QString();
}

QString leftOutOf(const ListedRun& listed, const FieldDocument& document, bool needsLock) {
  if (listed.on == 0) {
    return sayStage("switched off");
  }
  if (blockIsOff(document, listed.run.step)) {
    return sayStage("its block is switched off");
  }
  const std::vector<std::size_t> counted = countedRowsOf(listed.run, document, needsLock);
  QStringList reasons;
  if (listed.on < listed.run.count) {
    reasons << sayStage("%1 switched off").arg(listed.run.count - listed.on);
  }
  if (counted.empty()) {
    reasons << sayStage("never locked");
  } else if (counted.size() < listed.on) {
    reasons << sayStage("%1 not locked").arg(listed.on - counted.size());
  }
  if (const QString remark = plateauRemark(listed.run, document, counted); !remark.isEmpty()) {
    reasons << remark;
  }
  return reasons.join(QStringLiteral(", "));
}

QString stageRemark(const ListedStage& stage, const FieldDocument& document) {
  if (stage.on == 0) {
    return sayStage("switched off");
  }
  if (blockIsOff(document, stage.step)) {
    return sayStage("its block is switched off");
  }
  const auto touched = std::ranges::count_if(stage.runs, [](const ListedRun& run) { return !run.leftOut.isEmpty(); });
  if (touched == 0) {
    return {};
  }
  return sayStage("rows left out of %1 of %2").arg(touched).arg(stage.runs.size());
}

} // namespace

std::vector<ListedStage> campaignStages(const FieldDocument& document) {
  std::vector<ListedStage> stages;
  const CampaignRun* before = nullptr;
  const std::vector<CampaignRun> runs = campaignRuns(document.campaign());
  for (const CampaignRun& run : runs) {
    if (before == nullptr || before->step != run.step || before->axis != run.axis ||
        before->orientation != run.orientation) {
      ListedStage stage;
      stage.step = run.step;
      stage.title = stageWord(run.step, run.axis, run.orientation);
      stage.needsLock = field::needsOf(run.step).reference;
      stages.push_back(std::move(stage));
    }
    before = &run;
    ListedStage& stage = stages.back();
    ListedRun listed;
    listed.run = run;
    const QString title = isTemperatureSweep(run.step) ? sayStage("Sweep %1") : sayStage("Plateau %1");
    listed.title = title.arg(stage.runs.size() + 1);
    for (std::size_t row = run.first; row < run.first + run.count; ++row) {
      listed.on += document.isRowEnabled(row) ? 1U : 0U;
    }
    listed.leftOut = leftOutOf(listed, document, stage.needsLock);
    stage.rows += run.count;
    stage.locked += run.locked;
    stage.on += listed.on;
    stage.runs.push_back(std::move(listed));
  }
  for (ListedStage& stage : stages) {
    stage.leftOut = stageRemark(stage, document);
  }
  return stages;
}

} // namespace straightedge::gui
