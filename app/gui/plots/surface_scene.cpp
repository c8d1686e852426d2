#include "app/gui/plots/surface_scene.h"

#include "app/gui/plots/egl_context.h"
#include "app/gui/plots/theme.h"
#include "app/gui/plots/ticks.h"
#include "app/gui/plots/vtk_messages.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

namespace straightedge::gui {
namespace {

constexpr double boxHeight = 0.6; ///< the box is 1 × 1 × 0.6: data of any size look the same
constexpr double margin = 1.08;   ///< room for labels around the box

struct Vec {
  double x, y, z;
};

AxisScale rangeOf(const QList<double>& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(low < high)) {
    low = std::isfinite(low) ? low - 0.5 : 0.0;
    high = low + 1.0;
  }
  return {low, high, false};
}

void fillBackdrop(vtkPolyData* data, double wallX, double wallY, const std::array<Ticks, 3>& ticks,
                  const std::array<AxisScale, 3>& scales) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto line = [&](Vec a, Vec b) {
    const std::array<vtkIdType, 2> ends = {points->InsertNextPoint(a.x, a.y, a.z),
                                           points->InsertNextPoint(b.x, b.y, b.z)};
    lines->InsertNextCell(2, ends.data());
  };
  const auto grid = [&](std::size_t axis, const auto& draw) {
    draw(0.0);
    draw(1.0);
    for (const double position : ticks.at(axis).positions) {
      draw(scales.at(axis).toUnit(position));
    }
  };
  grid(0, [&](double u) {
    line({u, 0, 0}, {u, 1, 0});
    line({u, wallY, 0}, {u, wallY, boxHeight});
  });
  grid(1, [&](double v) {
    line({0, v, 0}, {1, v, 0});
    line({wallX, v, 0}, {wallX, v, boxHeight});
  });
  grid(2, [&](double w) {
    line({0, wallY, w * boxHeight}, {1, wallY, w * boxHeight});
    line({wallX, 0, w * boxHeight}, {wallX, 1, w * boxHeight});
  });
  data->SetPoints(points);
  data->SetLines(lines);
  data->Modified();
}

} // namespace

QColor surfaceColor(double share) {
  // Every eighth of Matplotlib's viridis (van der Walt and Smith, 2015).
  static constexpr std::array<std::array<double, 3>, 9> stops = {{{68, 1, 84},
                                                                  {71, 44, 122},
                                                                  {59, 81, 139},
                                                                  {44, 113, 142},
                                                                  {33, 144, 141},
                                                                  {39, 173, 129},
                                                                  {92, 200, 99},
                                                                  {170, 220, 50},
                                                                  {253, 231, 37}}};
  const double place = std::clamp(share, 0.0, 1.0) * 8.0;
  const auto low = std::min<std::size_t>(7, static_cast<std::size_t>(place));
  const double part = place - static_cast<double>(low);
  const auto mix = [&](std::size_t c) {
    return static_cast<int>(std::lround(stops.at(low).at(c) * (1.0 - part) + stops.at(low + 1).at(c) * part));
  };
  return {mix(0), mix(1), mix(2)};
}

struct SurfaceScene::Impl {
  std::unique_ptr<EglContext> egl; // first: the last to go
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkPolyData> surface, backdrop;
  vtkNew<vtkActor> grid;
  SurfaceSpec spec;
  std::array<AxisScale, 3> scales;
  std::array<Ticks, 3> ticks;

  void buildSurface();
  void place(const SurfaceCamera& camera);
  QPointF project(const Vec& point, const QSize& size) const;
  void letter(QPainter& painter, const QSize& size, double wallX, double wallY, const PlotColors& colors) const;
  void colourBar(QPainter& painter, const QSize& size, const PlotColors& colors) const;
};

SurfaceScene::SurfaceScene() : m_impl(std::make_unique<Impl>()) {}

std::unique_ptr<SurfaceScene> SurfaceScene::create() {
  sendVtkMessagesToLog();
  auto egl = EglContext::create();
  if (!egl) {
    return nullptr;
  }
  std::unique_ptr<SurfaceScene> scene(new SurfaceScene);
  Impl& d = *scene->m_impl;
  d.egl = std::move(egl);
  d.window = d.egl->makeWindow();
  d.window->AddRenderer(d.renderer);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(d.surface);
  normals->SplittingOff();
  vtkNew<vtkPolyDataMapper> surfaceMapper;
  surfaceMapper->SetInputConnection(normals->GetOutputPort());
  vtkNew<vtkActor> surfaceActor;
  surfaceActor->SetMapper(surfaceMapper);
  surfaceActor->GetProperty()->SetAmbient(0.35);
  surfaceActor->GetProperty()->SetDiffuse(0.7);
  d.renderer->AddActor(surfaceActor);
  vtkNew<vtkPolyDataMapper> backdropMapper;
  backdropMapper->SetInputData(d.backdrop);
  d.grid->SetMapper(backdropMapper);
  d.grid->GetProperty()->LightingOff();
  d.renderer->AddActor(d.grid);
  d.renderer->GetActiveCamera()->SetViewAngle(25.0);
  return scene;
}

SurfaceScene::~SurfaceScene() {
  if (m_impl->window) {
    m_impl->egl->makeCurrent();
    m_impl->window->Finalize();
    m_impl->window->RemoveAllObservers();
  }
}

void SurfaceScene::setSpec(const SurfaceSpec& spec) {
  m_impl->spec = spec;
  m_impl->scales = {rangeOf(spec.x), rangeOf(spec.y), rangeOf(spec.z)};
  for (std::size_t i = 0; i < 3; ++i) {
    m_impl->ticks.at(i) = linearTicks(m_impl->scales.at(i), 6);
  }
  m_impl->buildSurface();
}

void SurfaceScene::Impl::buildSurface() {
  surface->Initialize();
  if (spec.isEmpty()) {
    return;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (qsizetype j = 0; j < spec.y.size(); ++j) {
    for (qsizetype i = 0; i < spec.x.size(); ++i) {
      const double z = spec.z[j * spec.x.size() + i];
      const double w = std::isfinite(z) ? scales[2].toUnit(z) : 0.0;
      points->InsertNextPoint(scales[0].toUnit(spec.x[i]), scales[1].toUnit(spec.y[j]), w * boxHeight);
      const QColor color = surfaceColor(w);
      colors->InsertNextTuple3(color.red(), color.green(), color.blue());
    }
  }
  vtkNew<vtkCellArray> cells;
  for (qsizetype j = 0; j + 1 < spec.y.size(); ++j) {
    for (qsizetype i = 0; i + 1 < spec.x.size(); ++i) {
      const qsizetype a = j * spec.x.size() + i;
      const std::array<vtkIdType, 4> corners = {a, a + 1, a + spec.x.size() + 1, a + spec.x.size()};
      if (std::all_of(corners.begin(), corners.end(), [this](vtkIdType c) { return std::isfinite(spec.z[c]); })) {
        cells->InsertNextCell(4, corners.data());
      }
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->SetScalars(colors);
}

void SurfaceScene::Impl::place(const SurfaceCamera& camera) {
  const double azimuth = camera.azimuth * std::numbers::pi / 180.0;
  const double elevation = camera.elevation * std::numbers::pi / 180.0;
  const double radius = 0.5 * std::sqrt(2.0 + boxHeight * boxHeight);
  const double distance = margin * radius / std::sin(12.5 * std::numbers::pi / 180.0) / camera.zoom;
  vtkCamera* eye = renderer->GetActiveCamera();
  eye->SetFocalPoint(0.5, 0.5, 0.5 * boxHeight);
  eye->SetPosition(0.5 + distance * std::cos(elevation) * std::cos(azimuth),
                   0.5 + distance * std::cos(elevation) * std::sin(azimuth),
                   0.5 * boxHeight + distance * std::sin(elevation));
  if (camera.elevation > 89.0) { // straight from above "up" is away from the viewer
    eye->SetViewUp(-std::cos(azimuth), -std::sin(azimuth), 0.0);
  } else {
    eye->SetViewUp(0.0, 0.0, 1.0);
  }
  renderer->ResetCameraClippingRange(-0.2, 1.2, -0.2, 1.2, -0.2, boxHeight + 0.2);
}

QPointF SurfaceScene::Impl::project(const Vec& point, const QSize& size) const {
  std::array<double, 3> p = {point.x, point.y, point.z};
  renderer->WorldToView(p[0], p[1], p[2]);
  return {0.5 * (p[0] + 1.0) * size.width(), 0.5 * (1.0 - p[1]) * size.height()};
}

void SurfaceScene::Impl::letter(QPainter& painter, const QSize& size, double wallX, double wallY,
                                const PlotColors& colors) const {
  const PlotFonts fonts = PlotFonts::standard();
  const QFontMetricsF labels(fonts.label);
  const double frontX = 1.0 - wallX;
  const double frontY = 1.0 - wallY;
  const QPointF middle = project({0.5, 0.5, 0.5 * boxHeight}, size);
  // The upright edge further to the left carries the z axis.
  const bool leftIsWallX = project({wallX, frontY, 0}, size).x() < project({frontX, wallY, 0}, size).x();
  const double edgeX = leftIsWallX ? wallX : frontX;
  const double edgeY = leftIsWallX ? frontY : wallY;
  QList<QRectF> taken;
  const std::array<QString, 3> titles = {spec.xTitle, spec.yTitle, spec.zTitle};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto on = [&](double u) {
      return axis == 0 ? Vec{u, frontY, 0} : axis == 1 ? Vec{frontX, u, 0} : Vec{edgeX, edgeY, u * boxHeight};
    };
    const QLineF edge(project(on(0.0), size), project(on(1.0), size));
    // Away from the middle of the box, at right angles to the edge.
    QPointF away(-edge.dy(), edge.dx());
    away /= std::max(1.0, std::hypot(away.x(), away.y()));
    if (QPointF::dotProduct(away, edge.center() - middle) < 0.0) {
      away = -away;
    }
    double widest = 0.0;
    const Ticks& marks = ticks.at(axis);
    painter.setFont(fonts.label);
    painter.setPen(colors.softText);
    for (qsizetype i = 0; i < marks.positions.size(); ++i) {
      const QSizeF box(labels.horizontalAdvance(marks.labels[i]) + 2.0, labels.height());
      const double reach = 5.0 + 0.5 * (std::abs(away.x()) * box.width() + std::abs(away.y()) * box.height());
      const QPointF at = project(on(scales.at(axis).toUnit(marks.positions[i])), size) + reach * away;
      const QRectF place(at - QPointF(0.5 * box.width(), 0.5 * box.height()), box);
      const bool covers = std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) {
        return place.adjusted(-4, -1, 4, 1).intersects(other);
      });
      if (covers) {
        continue; // at corners and seen along an edge there is not room for all
      }
      taken << place;
      widest = std::max(widest, 2.0 * reach);
      painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, marks.labels[i]);
    }
    QString title = titles.at(axis);
    if (!marks.remark.isEmpty()) {
      title += QStringLiteral("  ") + marks.remark;
    }
    painter.save();
    painter.setFont(fonts.axisTitle);
    painter.setPen(colors.text);
    painter.translate(edge.center() + (widest + 10.0) * away);
    double turn = -edge.angle();
    turn = std::remainder(turn, 180.0);
    turn -= turn > 75.0 ? 180.0 : 0.0; // upright titles read from below, as on flat plots
    painter.rotate(turn);              // along the edge, never upside down
    painter.drawText(QRectF(-300, -20, 600, 40), Qt::AlignCenter, title);
    painter.restore();
  }
}

void SurfaceScene::Impl::colourBar(QPainter& painter, const QSize& size, const PlotColors& colors) const {
  const PlotFonts fonts = PlotFonts::standard();
  const QFontMetricsF metrics(fonts.label);
  double width = 0.0;
  for (const QString& label : ticks[2].labels) {
    width = std::max(width, metrics.horizontalAdvance(label));
  }
  const QRectF bar(size.width() - width - 36.0, 0.2 * size.height(), 14.0, 0.55 * size.height());
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  for (int i = 0; i <= 16; ++i) {
    gradient.setColorAt(i / 16.0, surfaceColor(i / 16.0));
  }
  painter.fillRect(bar, gradient);
  painter.setPen(QPen(colors.axis, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(bar);
  painter.setFont(fonts.label);
  painter.setPen(colors.softText);
  for (qsizetype i = 0; i < ticks[2].positions.size(); ++i) {
    const double y = bar.bottom() - scales[2].toUnit(ticks[2].positions[i]) * bar.height();
    painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 4.0, y));
    painter.drawText(QRectF(bar.right() + 8.0, y - 10.0, width + 4.0, 20.0), Qt::AlignLeft | Qt::AlignVCenter,
                     ticks[2].labels[i]);
  }
}

QImage SurfaceScene::render(const QSize& size, double devicePixelRatio, const SurfaceCamera& camera, PlotTheme theme,
                            int samples) {
  Impl& d = *m_impl;
  const PlotColors colors = PlotColors::of(theme);
  const QSize pixels(std::max(1, static_cast<int>(std::lround(size.width() * devicePixelRatio))),
                     std::max(1, static_cast<int>(std::lround(size.height() * devicePixelRatio))));
  const double wallX = std::cos(camera.azimuth * std::numbers::pi / 180.0) > 0.0 ? 0.0 : 1.0;
  const double wallY = std::sin(camera.azimuth * std::numbers::pi / 180.0) > 0.0 ? 0.0 : 1.0;
  fillBackdrop(d.backdrop, wallX, wallY, d.ticks, d.scales);
  const auto component = [](float c) { return static_cast<double>(c); };
  d.renderer->SetBackground(component(colors.background.redF()), component(colors.background.greenF()),
                            component(colors.background.blueF()));
  d.grid->GetProperty()->SetColor(component(colors.grid.redF()), component(colors.grid.greenF()),
                                  component(colors.grid.blueF()));
  d.window->SetMultiSamples(samples);
  d.window->SetSize(pixels.width(), pixels.height());
  d.place(camera);
  d.window->Render();
  vtkNew<vtkUnsignedCharArray> buffer;
  d.window->GetRGBACharPixelData(0, 0, pixels.width() - 1, pixels.height() - 1, 0, buffer);
  QImage image(pixels, QImage::Format_RGBX8888);
  const auto rowBytes = static_cast<std::size_t>(pixels.width()) * 4;
  for (int y = 0; y < pixels.height(); ++y) { // VTK's first row is the lowest
    std::memcpy(image.scanLine(pixels.height() - 1 - y), buffer->GetPointer(0) + static_cast<std::size_t>(y) * rowBytes,
                rowBytes);
  }
  image = image.convertToFormat(QImage::Format_RGB32); // OpenGL's alpha means nothing here, to QPainter it would
  image.setDevicePixelRatio(devicePixelRatio);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing, true);
  const PlotFonts fonts = PlotFonts::standard();
  painter.setFont(fonts.title);
  painter.setPen(colors.text);
  painter.drawText(QRectF(10, 8, size.width() - 20, 24), Qt::AlignLeft | Qt::AlignVCenter, d.spec.title);
  if (!d.spec.isEmpty()) {
    d.letter(painter, size, wallX, wallY, colors);
    d.colourBar(painter, size, colors);
  }
  return image;
}

} // namespace straightedge::gui
