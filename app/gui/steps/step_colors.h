// Colours of what the steps draw themselves (dials, rings, notices), for light and dark palettes.
#pragma once

#include <QColor>

#include <cstdint>

class QWidget;

namespace straightedge::gui {

enum class StepColor : std::uint8_t {
  Faint,     ///< scales, tracks
  Quiet,     ///< secondary text
  Reference, ///< the encoder
  Sensor,    ///< the sensor under calibration
  Good,
  Warning,
  Bad
};

QColor stepColor(const QWidget& widget, StepColor color);

} // namespace straightedge::gui
