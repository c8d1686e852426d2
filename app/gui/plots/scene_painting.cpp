#include "app/gui/plots/scene_painting.h"

#include "app/gui/plots/scene_colors.h"
#include "app/gui/plots/scene_drawing.h"
#include "app/gui/plots/scene_module.h"
#include "app/gui/plots/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace straightedge::gui {

namespace {

QString sceneNote(const SceneSpec& spec) {
  if (const auto* directions = std::get_if<DirectionsSpec>(&spec)) {
    return directions->note;
  }
  const auto* sphere = std::get_if<SphereSpec>(&spec);
  return sphere != nullptr ? sphere->note : QString();
}

/// Title and note at the top; returns the height that they take.
double letterHead(QPainter& painter, const SceneSpec& spec, const QSizeF& size, const PlotColors& colors) {
  const PlotFonts fonts = PlotFonts::standard();
  constexpr double side = 10.0;
  constexpr double edge = 8.0;
  const double width = size.width() - 2.0 * side;
  double top = edge;
  const auto line = [&](const QString& text, const QFont& font, const QColor& color) {
    if (text.isEmpty()) {
      return;
    }
    painter.setFont(font);
    painter.setPen(color);
    const QRectF wanted = QFontMetricsF(font).boundingRect(QRectF(0, 0, width, size.height()), Qt::TextWordWrap, text);
    painter.drawText(QRectF(side, top, width, wanted.height()), Qt::AlignLeft | Qt::TextWordWrap, text);
    top += wanted.height() + 2.0;
  };
  line(sceneTitle(spec), fonts.title, colors.text);
  line(sceneNote(spec), fonts.note, colors.softText);
  return std::ceil(top);
}

/// The scene without letters; null where it could not be rendered.
QImage rendered(SceneRenderer& renderer, const SceneGeometry& geometry, const SceneFrame& frame) {
  const std::vector<std::uint8_t> pixels = renderer.render(geometry, frame);
  const auto rowBytes = static_cast<std::size_t>(frame.width) * 4;
  if (pixels.size() != rowBytes * static_cast<std::size_t>(frame.height)) {
    return {};
  }
  QImage image(frame.width, frame.height, QImage::Format_RGBX8888);
  for (int y = 0; y < frame.height; ++y) { // OpenGL's first row is the lowest
    std::memcpy(image.scanLine(frame.height - 1 - y), pixels.data() + static_cast<std::size_t>(y) * rowBytes, rowBytes);
  }
  return image.convertToFormat(QImage::Format_RGB32); // OpenGL's alpha means nothing here, to QPainter it would
}

} // namespace

std::unique_ptr<SceneDrawing> makeDrawing(const SceneSpec& spec) {
  struct Maker {
    std::unique_ptr<SceneDrawing> operator()(const SurfaceSpec& surface) const { return makeSurfaceDrawing(surface); }
    std::unique_ptr<SceneDrawing> operator()(const DirectionsSpec& directions) const {
      return makeDirectionsDrawing(directions);
    }
    std::unique_ptr<SceneDrawing> operator()(const SphereSpec& sphere) const { return makeSphereDrawing(sphere); }
  };
  return std::visit(Maker(), spec);
}

QImage paintScene(SceneRenderer& renderer, const SceneSpec& spec, const ScenePicture& picture) {
  const PlotColors colors = PlotColors::of(picture.theme);
  const auto pixels = [&picture](double logical) {
    return std::max(1, static_cast<int>(std::lround(logical * picture.scale)));
  };
  QImage image(pixels(picture.size.width()), pixels(picture.size.height()), QImage::Format_RGB32);
  image.fill(colors.background);
  image.setDevicePixelRatio(picture.scale);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing, true);
  const double head = std::min(letterHead(painter, spec, picture.size, colors), 0.5 * picture.size.height());
  if (isEmptyScene(spec)) {
    return image;
  }
  const QSizeF size(picture.size.width(), picture.size.height() - head);
  const std::unique_ptr<SceneDrawing> drawing = makeDrawing(spec);
  SceneFrame frame;
  frame.width = image.width();
  frame.height = std::max(1, image.height() - pixels(head));
  frame.samples = picture.smooth ? 4 : 0;
  frame.background = sceneColor(colors.background);
  frame.eye = eyeOf(picture.camera, drawing->ball(), size);
  QImage scene = rendered(renderer, drawing->geometry(picture.camera, picture.theme, picture.scale), frame);
  if (scene.isNull()) {
    return {};
  }
  scene.setDevicePixelRatio(picture.scale);
  painter.translate(0.0, pixels(head) / picture.scale);
  painter.drawImage(QPointF(0.0, 0.0), scene);
  drawing->letter(painter, QRectF(QPointF(), size).adjusted(8, 2, -8, -6), SceneProjection(frame.eye, size),
                  picture.camera, picture.theme);
  return image;
}

SceneArtist::SceneArtist() = default;
SceneArtist::~SceneArtist() = default;

QImage SceneArtist::picture(const SceneSpec& spec, QSize size, double scale) {
  if (!m_tried) {
    m_tried = true;
    SceneRendererOrProblem made = makeSceneRenderer();
    m_renderer = std::move(made.renderer);
    m_problem = made.problem;
  }
  ScenePicture picture;
  picture.size = size;
  picture.scale = scale;
  return m_renderer ? paintScene(*m_renderer, spec, picture) : QImage();
}

} // namespace straightedge::gui
