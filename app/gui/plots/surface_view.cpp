#include "app/gui/plots/surface_view.h"

#include "app/gui/plots/surface_scene.h"
#include "app/gui/plots/theme.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>
#include <QSaveFile>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

constexpr double degreesPerPixel = 0.4;

} // namespace

struct SurfaceView::Impl {
  SurfaceSpec spec;
  std::optional<PlotTheme> theme;
  SurfaceCamera camera;
  std::unique_ptr<SurfaceScene> scene;
  bool tried = false;
  bool turning = false;
  QPointF last;

  bool start() {
    if (!tried) {
      tried = true;
      scene = SurfaceScene::create();
      if (scene) {
        scene->setSpec(spec);
      }
    }
    return scene != nullptr;
  }
};

SurfaceView::SurfaceView(QWidget* parent) : QWidget(parent), m_impl(std::make_unique<Impl>()) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(160, 120);
}

SurfaceView::~SurfaceView() = default;

void SurfaceView::setSpec(const SurfaceSpec& spec) {
  m_impl->spec = spec;
  setAccessibleName(spec.title);
  setAccessibleDescription(tr("Surface of %1 over %2 and %3").arg(spec.zTitle, spec.xTitle, spec.yTitle));
  if (m_impl->scene) {
    m_impl->scene->setSpec(spec);
  }
  update();
}

const SurfaceSpec& SurfaceView::spec() const { return m_impl->spec; }

void SurfaceView::setTheme(std::optional<PlotTheme> theme) {
  m_impl->theme = theme;
  update();
}

bool SurfaceView::isStarted() const { return m_impl->scene != nullptr; }
double SurfaceView::azimuth() const { return m_impl->camera.azimuth; }
double SurfaceView::elevation() const { return m_impl->camera.elevation; }
double SurfaceView::zoom() const { return m_impl->camera.zoom; }

void SurfaceView::resetCamera() {
  m_impl->camera = {};
  update();
}

QImage SurfaceView::picture(const QSize& size, double scale) {
  if (!m_impl->start()) {
    return {};
  }
  const bool dark = palette().color(QPalette::Window).lightness() < 128;
  const PlotTheme theme = m_impl->theme.value_or(dark ? PlotTheme::Dark : PlotTheme::Light);
  return m_impl->scene->render(size, scale, m_impl->camera, theme, m_impl->turning ? 0 : 4);
}

bool SurfaceView::saveAs(const QString& file, QString* problem) {
  const QString name = QFileInfo(file).fileName();
  QString sentence;
  if (!file.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive)) {
    sentence = tr("“%1” does not end in .png; surfaces are saved as PNG only.").arg(name);
  } else if (!m_impl->start()) {
    sentence = tr("“%1” is not written: surfaces need OpenGL 3.2 (EGL), which this computer does not offer.").arg(name);
  } else {
    QSaveFile out(file);
    if (!out.open(QIODevice::WriteOnly) || !picture(size(), 2.0).save(&out, "PNG") || !out.commit()) {
      sentence = tr("The picture cannot be written to “%1”: %2. Choose another place.").arg(file, out.errorString());
    }
  }
  if (problem != nullptr) {
    *problem = sentence;
  }
  return sentence.isEmpty();
}

void SurfaceView::paintEvent(QPaintEvent* /*event*/) {
  const QImage image = picture(size(), devicePixelRatioF());
  QPainter painter(this);
  if (image.isNull()) {
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Three-dimensional plots need OpenGL 3.2 (EGL), which this computer does not offer. "
                        "On Debian, the package libgl1-mesa-dri provides it in software."));
  } else {
    painter.drawImage(QPointF(0.0, 0.0), image);
  }
  painter.end();
  emit painted();
}

void SurfaceView::mousePressEvent(QMouseEvent* event) {
  m_impl->turning = event->button() == Qt::LeftButton;
  m_impl->last = event->position();
}

void SurfaceView::mouseMoveEvent(QMouseEvent* event) {
  if (!m_impl->turning) {
    return;
  }
  const QPointF moved = event->position() - m_impl->last;
  m_impl->last = event->position();
  SurfaceCamera& camera = m_impl->camera;
  camera.azimuth = std::remainder(camera.azimuth - degreesPerPixel * moved.x(), 360.0);
  camera.elevation = std::clamp(camera.elevation + degreesPerPixel * moved.y(), -5.0, 90.0);
  update();
}

void SurfaceView::mouseReleaseEvent(QMouseEvent* /*event*/) {
  m_impl->turning = false;
  update(); // once more, with smooth edges
}

void SurfaceView::mouseDoubleClickEvent(QMouseEvent* /*event*/) { resetCamera(); }

void SurfaceView::wheelEvent(QWheelEvent* event) {
  const double factor = std::pow(1.15, event->angleDelta().y() / 120.0);
  m_impl->camera.zoom = std::clamp(m_impl->camera.zoom * factor, 0.5, 8.0);
  event->accept();
  update();
}

void SurfaceView::keyPressEvent(QKeyEvent* event) {
  SurfaceCamera& camera = m_impl->camera;
  switch (event->key()) {
  case Qt::Key_Left:
    camera.azimuth -= 5.0;
    break;
  case Qt::Key_Right:
    camera.azimuth += 5.0;
    break;
  case Qt::Key_Up:
    camera.elevation = std::min(90.0, camera.elevation + 5.0);
    break;
  case Qt::Key_Down:
    camera.elevation = std::max(-5.0, camera.elevation - 5.0);
    break;
  case Qt::Key_Plus:
    camera.zoom = std::min(8.0, camera.zoom * 1.2);
    break;
  case Qt::Key_Minus:
    camera.zoom = std::max(0.5, camera.zoom / 1.2);
    break;
  case Qt::Key_Home:
    camera = {};
    break;
  default:
    QWidget::keyPressEvent(event);
    return;
  }
  update();
}

void SurfaceView::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Copy &picture"), this, [this] { QGuiApplication::clipboard()->setImage(picture(size(), 2.0)); });
  menu->addAction(tr("&Save as PNG…"), this, [this] {
    const QString file = QFileDialog::getSaveFileName(this, tr("Save plot"), QString(), tr("PNG picture (*.png)"));
    QString problem;
    if (!file.isEmpty() && !saveAs(file, &problem)) {
      QMessageBox::warning(this, tr("Save plot"), problem);
    }
  });
  menu->addAction(tr("&Reset view"), this, [this] { resetCamera(); });
  menu->popup(event->globalPos());
}

} // namespace straightedge::gui
