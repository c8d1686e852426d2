// A step of a guided calibration, as the step bar, the menu and the help know it.
#pragma once

#include <QString>

#include <cstddef>
#include <cstdint>

namespace straightedge::gui {

struct StepEntry {
  const char* title;
  const char* helpPage;
  const char* hint;     ///< what the step is for, in the step bar's tooltip
  const char* menuText; ///< title with its mnemonic
};

enum class StepProgress : std::uint8_t {
  Missing,   ///< something is needed first
  Available, ///< can be worked on
  Done,
  Failed, ///< worked on, and the outcome is bad: data refused, limit not met
};

/// How far a step is.
struct StepState {
  StepProgress progress = StepProgress::Missing;
  QString note; ///< what is missing or what came out, as a sentence; may be empty
  bool operator==(const StepState&) const = default;
};

} // namespace straightedge::gui
