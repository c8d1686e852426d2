// The stages of a campaign that is planned or captured, as the step Capture lists them: how far each is, why it is
// measured, how long it takes, and what it costs to leave it out.
#pragma once

#include "devices/capture/field_capture.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace straightedge::gui {

enum class StageProgress : std::uint8_t {
  ToDo,
  Measuring,
  Begun, ///< some of it is there
  Done,
  DoneInPart, ///< plateaus were given up: the reference did not lock
  LeftOut
};

struct StageLine {
  QString title; ///< "Nonlinearity, x"
  StageProgress progress = StageProgress::ToDo;
  QString state;    ///< "to do", "3 of 80", "done, 2 gave no lock", …
  QString duration; ///< what is still to be measured of it; empty where nothing is
  QString attempt;  ///< "2nd", …; empty for the first
  QString why;      ///< a sentence
  QString cost;     ///< what leaving it out costs
  bool hasRows = false;
};

/// `stages` has one entry for each stage of the plan; `present` is measured now, or -1.
std::vector<StageLine> stageLines(const devices::FieldPlan& plan,
                                  const std::vector<devices::FieldStageProgress>& stages, int present);

/// How far the stages are by the samples alone; of a campaign that was `finished`, what is missing was given up.
std::vector<devices::FieldStageProgress>
progressBySamples(const devices::FieldPlan& plan, const std::vector<session::FieldSample>& samples, bool finished);

/// Seconds that are expected for what is missing of a stage.
double remainingS(const devices::FieldPlan& plan, std::size_t stage, const devices::FieldStageProgress& progress);

} // namespace straightedge::gui
