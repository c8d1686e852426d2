// A three-dimensional picture: rendered by the module with OpenGL, lettered by Qt.
#pragma once

#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/scene_camera.h"
#include "app/gui/plots/scene_spec.h"

#include <QImage>
#include <QSize>

#include <memory>

namespace straightedge::gui {

class SceneRenderer;

struct ScenePicture {
  QSize size;         ///< logical pixels
  double scale = 1.0; ///< device pixels of a logical one
  SceneCamera camera;
  PlotTheme theme = PlotTheme::Light;
  bool smooth = true; ///< four samples a pixel; while it is turned, one
};

/// Null where it could not be rendered. Any thread, one at a time for a renderer.
QImage paintScene(SceneRenderer& renderer, const SceneSpec& spec, const ScenePicture& picture);

/// Pictures for files and reports, one after the other. Starts OpenGL with the first; without it there are none, and
/// problem() says why. Any thread, one call at a time.
class SceneArtist {
public:
  SceneArtist();
  ~SceneArtist();
  SceneArtist(const SceneArtist&) = delete;
  SceneArtist& operator=(const SceneArtist&) = delete;

  QImage picture(const SceneSpec& spec, QSize size, double scale);
  const QString& problem() const { return m_problem; } ///< empty while none has failed

private:
  std::unique_ptr<SceneRenderer> m_renderer;
  bool m_tried = false;
  QString m_problem;
};

} // namespace straightedge::gui
