// How far each step is, from the calibration and the bench alone: the step bar shows it before a page exists.
#pragma once

#include "app/gui/shell/step_catalogue.h"

#include <QString>

#include <cstdint>

namespace straightedge::gui {

enum class StepProgress : std::uint8_t {
  Missing,   ///< something is needed first
  Available, ///< can be worked on
  Done,
  Failed, ///< worked on, and the outcome is bad: data refused, limit not met
};

struct StepState {
  StepProgress progress = StepProgress::Missing;
  QString note; ///< what is missing or what came out, as a sentence; may be empty
  bool operator==(const StepState&) const = default;
};

StepState stepState(std::size_t step, const AngleDocument& document, const BenchLink& bench);

} // namespace straightedge::gui
