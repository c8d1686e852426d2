// How a kind of three-dimensional picture is drawn: its triangles and lines for the renderer, its letters for Qt. Knows
// no OpenGL. Private to plots.
#pragma once

#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/scene_camera.h"
#include "app/gui/plots/scene_spec.h"

#include <QRectF>

#include <memory>

class QPainter;

namespace straightedge::gui {

class SceneDrawing {
public:
  SceneDrawing() = default;
  virtual ~SceneDrawing() = default;
  SceneDrawing(const SceneDrawing&) = delete;
  SceneDrawing& operator=(const SceneDrawing&) = delete;

  virtual SceneBall ball() const = 0;
  /// `pixelRatio`: device pixels of a logical one, for the width of lines.
  virtual SceneGeometry geometry(const SceneCamera& camera, PlotTheme theme, double pixelRatio) const = 0;
  /// Everything but the title, in logical pixels within `area`.
  virtual void letter(QPainter& painter, const QRectF& area, const SceneProjection& projection,
                      const SceneCamera& camera, PlotTheme theme) const = 0;
};

std::unique_ptr<SceneDrawing> makeDrawing(const SceneSpec& spec);
std::unique_ptr<SceneDrawing> makeSurfaceDrawing(const SurfaceSpec& spec);
std::unique_ptr<SceneDrawing> makeDirectionsDrawing(const DirectionsSpec& spec);
std::unique_ptr<SceneDrawing> makeSphereDrawing(const SphereSpec& spec);

} // namespace straightedge::gui
