#include "app/gui/field_steps/capture_stages.h"

#include "app/gui/field_steps/field_page_words.h"
#include "app/gui/figures/field_words.h"
#include "app/gui/figures/figure_parts.h"
#include "app/gui/steps/capture_words.h"
#include "core/field/block_costs.h"
#include "core/field/block_names.h"
#include "devices/capture/field_course.h"

#include <QCoreApplication>

#include <algorithm>

namespace straightedge::gui {

namespace {

QString sayLine(const char* text) { return QCoreApplication::translate("CaptureStages", text); }

StageProgress progressOf(const devices::FieldStageProgress& stage, bool present) {
  if (stage.skipped) {
    return StageProgress::LeftOut;
  }
  if (present) {
    return StageProgress::Measuring;
  }
  if (stage.pointsDone >= stage.pointsPlanned) {
    return stage.pointsGivenUp > 0 ? StageProgress::DoneInPart : StageProgress::Done;
  }
  return stage.pointsDone > 0 ? StageProgress::Begun : StageProgress::ToDo;
}

QString stateOf(const devices::FieldStageProgress& stage, StageProgress progress) {
  const QString part = sayLine("%1 of %2").arg(stage.pointsDone).arg(stage.pointsPlanned);
  switch (progress) {
  case StageProgress::ToDo:
    return sayLine("to do");
  case StageProgress::Measuring:
    return sayLine("measuring, %1").arg(part);
  case StageProgress::Begun:
    return part;
  case StageProgress::Done:
    return sayLine("done");
  case StageProgress::DoneInPart:
    return sayLine("done, %1 without lock").arg(stage.pointsGivenUp);
  case StageProgress::LeftOut:
    return stage.pointsDone > 0 ? sayLine("left out, %1").arg(part) : sayLine("left out");
  }
  return {};
}

QString attemptText(int attempt) { return attempt == 0 ? QString() : sayLine("no. %1").arg(attempt + 1); }

QString costOfLeavingOut(const devices::FieldStage& stage) {
  if (stage.step == field::CampaignStep::Verification) {
    return sayLine("Left out, no reading shows what the calibration is worth, until a fresh campaign is verified.");
  }
  for (const auto& [block, word] : field::blockWords) {
    if (field::stepOf(block) == stage.step) {
      return sayLine("Left out, the block “%1”%2 is switched off: %3")
          .arg(blockTitle(block), stage.axis ? sayLine(" of axis %1").arg(axisWord(stage.axis)) : QString(),
               QString::fromUtf8(field::costOf(block)));
    }
  }
  return {};
}

} // namespace

double remainingS(const devices::FieldPlan& plan, std::size_t stage, const devices::FieldStageProgress& progress) {
  if (progress.skipped || progress.pointsPlanned == 0) {
    return 0.0;
  }
  const double done = static_cast<double>(progress.pointsDone) / progress.pointsPlanned;
  return std::max(0.0, 1.0 - done) * devices::expectedS(plan, plan.stages[stage]);
}

std::vector<StageLine> stageLines(const devices::FieldPlan& plan,
                                  const std::vector<devices::FieldStageProgress>& stages, int present) {
  std::vector<StageLine> lines;
  for (std::size_t i = 0; i < plan.stages.size() && i < stages.size(); ++i) {
    const devices::FieldStage& stage = plan.stages[i];
    StageLine line;
    line.title = stageWord(stage.step, stage.axis, stage.orientation);
    line.progress = progressOf(stages[i], static_cast<int>(i) == present);
    line.state = stateOf(stages[i], line.progress);
    const double left = remainingS(plan, i, stages[i]);
    line.duration = left > 0.0 ? durationText(left) : QString();
    line.attempt = attemptText(stages[i].attempt);
    line.why = fromText(devices::stagePurpose(stage));
    line.cost = costOfLeavingOut(stage);
    line.hasRows = stages[i].pointsDone > 0 || stages[i].attempt > 0;
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<devices::FieldStageProgress>
progressBySamples(const devices::FieldPlan& plan, const std::vector<session::FieldSample>& samples, bool finished) {
  std::vector<devices::FieldStageProgress> stages(plan.stages.size());
  const auto course = devices::FieldCourse::make(plan, samples);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const auto number = static_cast<int>(i);
    stages[i].skipped = plan.stages[i].skipped;
    stages[i].pointsPlanned = static_cast<int>(devices::plannedPoints(plan.stages[i]).size());
    if (course) {
      stages[i].pointsDone = course->pointsDone(number);
      stages[i].attempt = course->attempt(number);
    }
    if (finished && !stages[i].skipped) {
      stages[i].pointsGivenUp = stages[i].pointsPlanned - stages[i].pointsDone;
      stages[i].pointsDone = stages[i].pointsPlanned;
    }
  }
  return stages;
}

} // namespace straightedge::gui
