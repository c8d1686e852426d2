// The widget that shows a SurfaceSpec: drag turns it, the wheel zooms, a double click resets.
#pragma once

#include "app/gui/plots/plot_view.h"
#include "app/gui/plots/surface_spec.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>

namespace straightedge::gui {

/// GUI thread only. OpenGL is started when it is shown for the first time (0.2 s and 120 MB with software OpenGL);
/// where there is none, the widget says so instead.
class SurfaceView : public QWidget {
  Q_OBJECT
public:
  explicit SurfaceView(QWidget* parent = nullptr);
  ~SurfaceView() override;

  void setSpec(const SurfaceSpec& spec);
  const SurfaceSpec& spec() const;
  void setTheme(std::optional<PlotTheme> theme); ///< without a value the palette decides
  bool isStarted() const;                        ///< shown once, and OpenGL is there
  double azimuth() const;                        ///< degrees
  double elevation() const;                      ///< degrees
  double zoom() const;
  void resetCamera();
  QImage picture(const QSize& size, double scale);    ///< null where there is no OpenGL
  bool saveAs(const QString& file, QString* problem); ///< .png in twice the size; false with a sentence

signals:
  void painted();

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
