#include "app/gui/plots/scene_view.h"

#include "app/gui/plots/scene_worker.h"
#include "app/gui/plots/theme.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QEvent>
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

struct SceneView::Impl {
  SceneSpec spec;
  std::optional<PlotTheme> theme;
  SceneCamera camera;
  QString problem;
  QImage shown;
  quint64 wished = 1;  ///< counts changes of what is to be seen
  quint64 asked = 0;   ///< the wish that the worker has
  quint64 arrived = 0; ///< the wish that `shown` answers
  QSizeF askedSize;    ///< in device pixels
  bool started = false;
  bool turning = false;
  QPointF last;
  std::unique_ptr<SceneWorker> worker;

  PlotTheme themeFor(const QPalette& palette) const {
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    return theme.value_or(dark ? PlotTheme::Dark : PlotTheme::Light);
  }
};

SceneView::SceneView(QWidget* parent) : QWidget(parent), m_impl(std::make_unique<Impl>()) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(160, 120);
  m_impl->worker = std::make_unique<SceneWorker>(*this);
}

SceneView::~SceneView() = default;

void SceneView::refresh() {
  ++m_impl->wished;
  update();
}

void SceneView::setSpec(const SceneSpec& spec) {
  m_impl->spec = spec;
  setAccessibleName(sceneTitle(spec));
  setAccessibleDescription(sceneInWords(spec));
  refresh();
}

const SceneSpec& SceneView::spec() const { return m_impl->spec; }

void SceneView::setTheme(std::optional<PlotTheme> theme) {
  m_impl->theme = theme;
  refresh();
}

bool SceneView::isStarted() const { return m_impl->started; }
QString SceneView::problem() const { return m_impl->problem; }
SceneCamera SceneView::camera() const { return m_impl->camera; }

void SceneView::setCamera(const SceneCamera& camera) {
  m_impl->camera = camera;
  m_impl->camera.azimuth = std::remainder(camera.azimuth, 360.0);
  m_impl->camera.elevation = std::clamp(camera.elevation, -5.0, 90.0);
  m_impl->camera.zoom = std::clamp(camera.zoom, 0.5, 8.0);
  refresh();
}

void SceneView::resetCamera() { setCamera({}); }

void SceneView::requestPicture(const QSize& size, double scale, std::function<void(const QImage&)> done) {
  const ScenePicture picture{size, scale, m_impl->camera, m_impl->themeFor(palette()), true};
  m_impl->worker->draw(m_impl->spec, picture, [this, done = std::move(done)](const SceneWorker::Drawn& drawn) {
    m_impl->problem = drawn.problem;
    done(drawn.image);
  });
}

void SceneView::saveAs(const QString& file, std::function<void(const QString&)> done) {
  const QString name = QFileInfo(file).fileName();
  if (!file.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive)) {
    done(tr("“%1” does not end in .png; three-dimensional pictures are saved as PNG only.").arg(name));
    return;
  }
  requestPicture(size(), 2.0, [this, file, name, done = std::move(done)](const QImage& image) {
    if (image.isNull()) {
      done(tr("“%1” is not written. %2").arg(name, m_impl->problem));
      return;
    }
    QSaveFile out(file);
    const bool written = out.open(QIODevice::WriteOnly) && image.save(&out, "PNG") && out.commit();
    done(written ? QString()
                 : tr("The picture cannot be written to “%1”: %2. Choose another place.").arg(file, out.errorString()));
  });
}

void SceneView::paintEvent(QPaintEvent* /*event*/) {
  Impl& d = *m_impl;
  const PlotColors colors = PlotColors::of(d.themeFor(palette()));
  if (isEmptyScene(d.spec)) { // nothing that OpenGL would have to be started for
    QPainter painter(this);
    painter.fillRect(rect(), colors.background);
    painter.setPen(colors.softText);
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, sceneTitle(d.spec));
    painter.end();
    emit pictureShown();
    return;
  }
  const QSizeF pixels = QSizeF(size()) * devicePixelRatioF();
  if (d.askedSize != pixels) {
    ++d.wished;
  }
  if (d.asked != d.wished && d.problem.isEmpty()) {
    d.asked = d.wished;
    d.askedSize = pixels;
    const ScenePicture picture{size(), devicePixelRatioF(), d.camera, d.themeFor(palette()), !d.turning};
    d.worker->show(d.spec, picture, [this, wish = d.asked](const SceneWorker::Drawn& drawn) {
      m_impl->problem = drawn.problem;
      m_impl->started = m_impl->started || !drawn.image.isNull();
      m_impl->shown = drawn.image;
      m_impl->arrived = wish;
      if (drawn.image.isNull() && drawn.problem.isEmpty()) {
        m_impl->problem = tr("The picture could not be drawn: OpenGL gave nothing back.");
      }
      update();
    });
  }
  QPainter painter(this);
  painter.fillRect(rect(), colors.background);
  if (!d.shown.isNull()) {
    painter.drawImage(QPointF(0.0, 0.0), d.shown);
  } else {
    painter.setPen(colors.softText);
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     d.problem.isEmpty() ? tr("Drawing…") : d.problem);
  }
  painter.end();
  if (d.arrived == d.wished || !d.problem.isEmpty()) {
    emit pictureShown();
  }
}

void SceneView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    refresh();
  }
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  m_impl->turning = event->button() == Qt::LeftButton;
  m_impl->last = event->position();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  if (!m_impl->turning) {
    return;
  }
  const QPointF moved = event->position() - m_impl->last;
  m_impl->last = event->position();
  SceneCamera turned = m_impl->camera;
  turned.azimuth -= degreesPerPixel * moved.x();
  turned.elevation += degreesPerPixel * moved.y();
  setCamera(turned);
}

void SceneView::mouseReleaseEvent(QMouseEvent* /*event*/) {
  m_impl->turning = false;
  refresh(); // once more, with smooth edges
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* /*event*/) { resetCamera(); }

void SceneView::wheelEvent(QWheelEvent* event) {
  SceneCamera nearer = m_impl->camera;
  nearer.zoom *= std::pow(1.15, event->angleDelta().y() / 120.0);
  setCamera(nearer);
  event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  SceneCamera camera = m_impl->camera;
  switch (event->key()) {
  case Qt::Key_Left:
    camera.azimuth -= 5.0;
    break;
  case Qt::Key_Right:
    camera.azimuth += 5.0;
    break;
  case Qt::Key_Up:
    camera.elevation += 5.0;
    break;
  case Qt::Key_Down:
    camera.elevation -= 5.0;
    break;
  case Qt::Key_Plus:
    camera.zoom *= 1.2;
    break;
  case Qt::Key_Minus:
    camera.zoom /= 1.2;
    break;
  case Qt::Key_Home:
    camera = {};
    break;
  default:
    QWidget::keyPressEvent(event);
    return;
  }
  setCamera(camera);
}

void SceneView::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Copy &picture"), this, [this] {
    requestPicture(size(), 2.0, [](const QImage& image) {
      if (!image.isNull()) {
        QGuiApplication::clipboard()->setImage(image);
      }
    });
  });
  menu->addAction(tr("&Save as PNG…"), this, [this] {
    const QString file = QFileDialog::getSaveFileName(this, tr("Save picture"), QString(), tr("PNG picture (*.png)"));
    if (!file.isEmpty()) {
      saveAs(file, [this](const QString& problem) {
        if (!problem.isEmpty()) {
          QMessageBox::warning(this, tr("Save picture"), problem);
        }
      });
    }
  });
  menu->addAction(tr("&Reset view"), this, [this] { resetCamera(); });
  menu->popup(event->globalPos());
}

} // namespace straightedge::gui
