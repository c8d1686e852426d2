// A surface rendered off screen by VTK into a picture, with axes, titles and colour bar lettered by Qt.
#pragma once

#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/surface_spec.h"

#include <QImage>
#include <QSize>

#include <memory>

namespace straightedge::gui {

/// Where it is looked at from: angles in degrees, zoom 1 shows the whole.
struct SurfaceCamera {
  double azimuth = -55.0;
  double elevation = 28.0; ///< −5 … 90
  double zoom = 1.0;
};

class SurfaceScene {
public:
  /// Nothing where there is no OpenGL.
  static std::unique_ptr<SurfaceScene> create();
  ~SurfaceScene();
  SurfaceScene(const SurfaceScene&) = delete;
  SurfaceScene& operator=(const SurfaceScene&) = delete;

  void setSpec(const SurfaceSpec& spec);
  /// `size` in logical pixels; `samples` 0 while it moves, 4 when it rests (software OpenGL is slow with 4).
  QImage render(const QSize& size, double devicePixelRatio, const SurfaceCamera& camera, PlotTheme theme, int samples);

private:
  SurfaceScene();
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

/// 0 … 1 -> colour of the scale (viridis: even in lightness, safe for colour-blind eyes).
QColor surfaceColor(double share);

} // namespace straightedge::gui
