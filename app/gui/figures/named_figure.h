// A figure that can be listed, written to a file and printed in a report.
#pragma once

#include "app/gui/plots/plot_spec.h"
#include "app/gui/plots/scene_spec.h"

#include <QString>

#include <cstdint>
#include <functional>

namespace straightedge::gui {

/// The section of a report that a figure belongs to.
enum class FigureTopic : std::uint8_t {
  Data,
  // Angle
  Curve,
  Models,
  // Field: a section per block
  Nonlinearity,
  ProbeTemperature,
  Offset,
  Sensitivity,
  Electronics,
  AxisMatrix,
  Uncertainty,
  // Both
  Comparison,
  Verification,
};

struct NamedFigure {
  QString stem; ///< file name without folder and extension, e.g. "correction-curve"
  FigureTopic topic = FigureTopic::Data;
  QString caption;                       ///< a sentence or two: what is drawn and how it was made
  std::function<PlotSpec()> make;        ///< the plot; any thread
  std::function<SceneSpec()> scene = {}; ///< instead of `make`: a three-dimensional picture; any thread

  bool isScene() const { return static_cast<bool>(scene); }
};

} // namespace straightedge::gui
