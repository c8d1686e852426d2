// The widget that shows a three-dimensional picture: drag turns it, the wheel zooms, a double click resets.
#pragma once

#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/scene_camera.h"
#include "app/gui/plots/scene_spec.h"

#include <QImage>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

namespace straightedge::gui {

/// GUI thread only. OpenGL is loaded and started when it is shown for the first time, in a thread that draws; until the
/// picture is there the widget says so. Where there is no OpenGL it says why instead. Arrow keys turn, + and − zoom,
/// Home resets; the context menu copies and saves.
class SceneView : public QWidget {
  Q_OBJECT
public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  void setSpec(const SceneSpec& spec); ///< where it is looked at from stays
  const SceneSpec& spec() const;
  void setTheme(std::optional<PlotTheme> theme); ///< without a value the palette decides
  bool isStarted() const;                        ///< a picture was drawn: OpenGL is there
  QString problem() const;                       ///< why there are no pictures; empty while that is not known
  SceneCamera camera() const;
  void resetCamera();

  /// Calls back with the picture, null where it cannot be drawn.
  void requestPicture(const QSize& size, double scale, std::function<void(const QImage&)> done);
  /// A .png in twice the size; calls back with a sentence, empty when it is written.
  void saveAs(const QString& file, std::function<void(const QString&)> done);

signals:
  void pictureShown(); ///< what is on the screen is what was wished for last, or the reason why there is nothing

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  void refresh(); ///< the picture shown is not the one wished for any more
  void setCamera(const SceneCamera& camera);

  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
