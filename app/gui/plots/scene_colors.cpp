#include "app/gui/plots/scene_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace straightedge::gui {

namespace {

using ScaleStops = std::array<std::array<double, 3>, 9>;

// Every eighth of Matplotlib's viridis (van der Walt and Smith, 2015).
constexpr ScaleStops viridis = {{{68, 1, 84},
                                 {71, 44, 122},
                                 {59, 81, 139},
                                 {44, 113, 142},
                                 {33, 144, 141},
                                 {39, 173, 129},
                                 {92, 200, 99},
                                 {170, 220, 50},
                                 {253, 231, 37}}};
// Every eighth of the cool-warm scale for shaded surfaces (Moreland, "Diverging Color Maps for Scientific
// Visualization", 2009): blue and red are told apart by all common kinds of colour blindness.
constexpr ScaleStops coolWarm = {{{59, 76, 192},
                                  {98, 130, 234},
                                  {141, 176, 254},
                                  {184, 208, 249},
                                  {221, 221, 221},
                                  {245, 196, 173},
                                  {244, 154, 123},
                                  {222, 96, 77},
                                  {180, 4, 38}}};

} // namespace

SceneColor sceneColor(const QColor& color) {
  return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
          static_cast<std::uint8_t>(color.blue())};
}

QColor scaleColor(SurfaceColors scale, double share) {
  const ScaleStops& stops = scale == SurfaceColors::Sequential ? viridis : coolWarm;
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto low = std::min(stops.size() - 2, static_cast<std::size_t>(place));
  const double part = place - static_cast<double>(low);
  const auto mix = [&](std::size_t c) {
    return static_cast<int>(std::lround(stops.at(low).at(c) * (1.0 - part) + stops.at(low + 1).at(c) * part));
  };
  return {mix(0), mix(1), mix(2)};
}

double colorShare(SurfaceColors scale, double value, double low, double high) {
  if (scale == SurfaceColors::Sequential) {
    return high > low ? (value - low) / (high - low) : 0.5;
  }
  const double reach = std::max(std::abs(low), std::abs(high));
  return reach > 0.0 ? 0.5 + 0.5 * value / reach : 0.5;
}

} // namespace straightedge::gui
