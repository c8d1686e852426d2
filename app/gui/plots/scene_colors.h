// Colour scales of three-dimensional pictures, safe for colour-blind eyes.
#pragma once

#include "app/gui/plots/scene_renderer.h"
#include "app/gui/plots/scene_spec.h"

#include <QColor>

namespace straightedge::gui {

SceneColor sceneColor(const QColor& color);

/// 0 … 1 -> a colour of the scale: viridis (even in lightness), or blue over grey to red with grey at 0.5.
QColor scaleColor(SurfaceColors scale, double share);

/// Where a height lies on its colour scale over this range, 0 … 1; of the diverging scale zero is at 0.5, and the
/// further end of the range at 0 or 1.
double colorShare(SurfaceColors scale, double value, double low, double high);

} // namespace straightedge::gui
