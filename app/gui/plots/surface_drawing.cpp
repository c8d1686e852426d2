// Heights over a grid in a box with walls: triangles and grid lines for the renderer; ticks, titles and colour bar.
#include "app/gui/plots/scene_colors.h"
#include "app/gui/plots/scene_drawing.h"
#include "app/gui/plots/scene_lettering.h"
#include "app/gui/plots/scene_shapes.h"
#include "app/gui/plots/theme.h"
#include "app/gui/plots/ticks.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace straightedge::gui {
namespace {

constexpr double boxHeight = 0.6; ///< the box is 1 × 1 × 0.6: data of any size look the same
constexpr double boxInBall = 0.9; ///< the box does not fill the ball about it

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

AxisScale heightsOf(const SurfaceSpec& spec) {
  if (spec.zRange && spec.zRange->first < spec.zRange->second) {
    return {spec.zRange->first, spec.zRange->second, false};
  }
  return rangeOf(spec.z);
}

/// The walls and edges that a camera sees from inside.
struct Walls {
  double x = 0.0, y = 0.0; ///< where the walls stand
  explicit Walls(const SceneCamera& camera)
      : x(std::cos(camera.azimuth * std::numbers::pi / 180.0) > 0.0 ? 0.0 : 1.0),
        y(std::sin(camera.azimuth * std::numbers::pi / 180.0) > 0.0 ? 0.0 : 1.0) {}
};

class SurfaceDrawing : public SceneDrawing {
public:
  explicit SurfaceDrawing(const SurfaceSpec& spec)
      : m_spec(spec), m_scales({rangeOf(spec.x), rangeOf(spec.y), heightsOf(spec)}) {
    for (std::size_t i = 0; i < 3; ++i) {
      m_ticks.at(i) = linearTicks(m_scales.at(i), 6);
    }
  }

  SceneBall ball() const override {
    return {{0.5, 0.5, 0.5 * boxHeight}, boxInBall * 0.5 * std::sqrt(2.0 + boxHeight * boxHeight), {90.0, 36.0}};
  }

  SceneGeometry geometry(const SceneCamera& camera, PlotTheme theme, double pixelRatio) const override {
    SceneGeometry geometry;
    geometry.lines.push_back(grid(Walls(camera), theme, pixelRatio));
    geometry.meshes.push_back(surface());
    return geometry;
  }

  void letter(QPainter& painter, const QRectF& area, const SceneProjection& projection, const SceneCamera& camera,
              PlotTheme theme) const override {
    letterAxes(painter, area, projection, Walls(camera), PlotColors::of(theme));
    colourBar(painter, area, PlotColors::of(theme));
  }

private:
  double share(double height) const {
    return colorShare(m_spec.colors, height, m_scales[2].minimum, m_scales[2].maximum);
  }

  SceneMesh surface() const {
    SceneMesh mesh;
    mesh.ambient = 0.62; // colours are to be compared with the bar
    const auto columns = static_cast<std::int32_t>(m_spec.x.size());
    for (qsizetype j = 0; j < m_spec.y.size(); ++j) {
      for (qsizetype i = 0; i < m_spec.x.size(); ++i) {
        const double z = m_spec.z[j * columns + i];
        const double height = std::isfinite(z) ? std::clamp(m_scales[2].toUnit(z), 0.0, 1.0) : 0.0;
        for (const double c : {m_scales[0].toUnit(m_spec.x[i]), m_scales[1].toUnit(m_spec.y[j]), height * boxHeight}) {
          mesh.points.push_back(static_cast<float>(c));
        }
        const SceneColor color = sceneColor(scaleColor(m_spec.colors, std::isfinite(z) ? share(z) : 0.5));
        mesh.colors.insert(mesh.colors.end(), color.begin(), color.end());
      }
    }
    for (std::int32_t j = 0; j + 1 < static_cast<std::int32_t>(m_spec.y.size()); ++j) {
      for (std::int32_t i = 0; i + 1 < columns; ++i) {
        const std::int32_t a = j * columns + i;
        const std::array<std::int32_t, 4> corners = {a, a + 1, a + columns + 1, a + columns};
        if (std::ranges::all_of(corners, [this](std::int32_t c) { return std::isfinite(m_spec.z[c]); })) {
          mesh.triangles.insert(mesh.triangles.end(),
                                {corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]});
        }
      }
    }
    return mesh;
  }

  SceneLines grid(const Walls& walls, PlotTheme theme, double pixelRatio) const {
    SceneLines lines;
    lines.color = sceneColor(PlotColors::of(theme).grid);
    lines.widthPixels = pixelRatio;
    const auto along = [&](std::size_t axis, const auto& draw) {
      draw(0.0);
      draw(1.0);
      for (const double position : m_ticks.at(axis).positions) {
        draw(m_scales.at(axis).toUnit(position));
      }
    };
    along(0, [&](double u) {
      addPath(lines, {{u, 0, 0}, {u, 1, 0}});
      addPath(lines, {{u, walls.y, 0}, {u, walls.y, boxHeight}});
    });
    along(1, [&](double v) {
      addPath(lines, {{0, v, 0}, {1, v, 0}});
      addPath(lines, {{walls.x, v, 0}, {walls.x, v, boxHeight}});
    });
    along(2, [&](double w) {
      addPath(lines, {{0, walls.y, w * boxHeight}, {1, walls.y, w * boxHeight}});
      addPath(lines, {{walls.x, 0, w * boxHeight}, {walls.x, 1, w * boxHeight}});
    });
    return lines;
  }

  void letterAxes(QPainter& painter, const QRectF& area, const SceneProjection& projection, const Walls& walls,
                  const PlotColors& colors) const {
    const PlotFonts fonts = PlotFonts::standard();
    const QFontMetricsF metrics(fonts.label);
    const double frontX = 1.0 - walls.x;
    const double frontY = 1.0 - walls.y;
    const QPointF middle = projection.at({0.5, 0.5, 0.5 * boxHeight});
    // The upright edge further to the left carries the height axis.
    const bool leftIsWallX = projection.at({walls.x, frontY, 0}).x() < projection.at({frontX, walls.y, 0}).x();
    const double edgeX = leftIsWallX ? walls.x : frontX;
    const double edgeY = leftIsWallX ? frontY : walls.y;
    SceneLettering lettering(painter, area, colors.background);
    const std::array<QString, 3> titles = {m_spec.xTitle, m_spec.yTitle, m_spec.zTitle};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto on = [&](double u) {
        return axis == 0   ? SceneVector{u, frontY, 0}
               : axis == 1 ? SceneVector{frontX, u, 0}
                           : SceneVector{edgeX, edgeY, u * boxHeight};
      };
      const QLineF edge(projection.at(on(0.0)), projection.at(on(1.0)));
      // Away from the middle of the box, at right angles to the edge.
      QPointF away(-edge.dy(), edge.dx());
      away /= std::max(1.0, std::hypot(away.x(), away.y()));
      if (QPointF::dotProduct(away, edge.center() - middle) < 0.0) {
        away = -away;
      }
      double widest = 0.0;
      const Ticks& marks = m_ticks.at(axis);
      painter.setFont(fonts.label);
      painter.setPen(colors.softText);
      for (qsizetype i = 0; i < marks.positions.size(); ++i) {
        const QSizeF box(metrics.horizontalAdvance(marks.labels[i]) + 2.0, metrics.height());
        const double reach = 5.0 + 0.5 * (std::abs(away.x()) * box.width() + std::abs(away.y()) * box.height());
        const QPointF at = projection.at(on(m_scales.at(axis).toUnit(marks.positions[i]))) + reach * away;
        const QRectF place(at - QPointF(0.5 * box.width(), 0.5 * box.height()), box);
        if (lettering.writeIfFree(place, marks.labels[i])) { // at corners there is not room for all
          widest = std::max(widest, 2.0 * reach);
        }
      }
      QString title = titles.at(axis);
      if (!marks.remark.isEmpty()) {
        title += QStringLiteral("  ") + marks.remark;
      }
      painter.save();
      painter.setFont(fonts.axisTitle);
      painter.setPen(colors.text);
      painter.translate(edge.center() + (widest + 10.0) * away);
      double turn = std::remainder(-edge.angle(), 180.0);
      turn -= turn > 75.0 ? 180.0 : 0.0; // upright titles read from below, as on flat plots
      painter.rotate(turn);              // along the edge, never upside down
      painter.drawText(QRectF(-300, -20, 600, 40), Qt::AlignCenter, title);
      painter.restore();
    }
  }

  void colourBar(QPainter& painter, const QRectF& area, const PlotColors& colors) const {
    const PlotFonts fonts = PlotFonts::standard();
    const QFontMetricsF metrics(fonts.label);
    double width = 0.0;
    for (const QString& label : m_ticks[2].labels) {
      width = std::max(width, metrics.horizontalAdvance(label));
    }
    constexpr double barWidth = 14.0;
    const QRectF bar(area.right() - width - 26.0 - metrics.height(), area.top() + 0.14 * area.height(), barWidth,
                     0.66 * area.height());
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    constexpr int stops = 32;
    const AxisScale& heights = m_scales[2];
    for (int i = 0; i <= stops; ++i) {
      const double place = static_cast<double>(i) / stops;
      gradient.setColorAt(place, scaleColor(m_spec.colors, share(heights.fromUnit(place))));
    }
    painter.fillRect(bar, gradient);
    painter.setPen(QPen(colors.axis, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
    painter.setFont(fonts.label);
    painter.setPen(colors.softText);
    for (qsizetype i = 0; i < m_ticks[2].positions.size(); ++i) {
      const double y = bar.bottom() - heights.toUnit(m_ticks[2].positions[i]) * bar.height();
      painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 4.0, y));
      painter.drawText(QRectF(bar.right() + 7.0, y - 10.0, width + 4.0, 20.0), Qt::AlignLeft | Qt::AlignVCenter,
                       m_ticks[2].labels[i]);
    }
    // What it measures, upright beside it: above it a long title would not fit.
    QString title = m_spec.zTitle;
    if (!m_ticks[2].remark.isEmpty()) {
      title += QStringLiteral("  ") + m_ticks[2].remark;
    }
    painter.save();
    painter.translate(bar.left() - 0.5 * metrics.height() - 3.0, bar.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-0.5 * area.height(), -0.5 * metrics.height(), area.height(), metrics.height()),
                     Qt::AlignCenter, title);
    painter.restore();
  }

  SurfaceSpec m_spec;
  std::array<AxisScale, 3> m_scales;
  std::array<Ticks, 3> m_ticks;
};

} // namespace

std::unique_ptr<SceneDrawing> makeSurfaceDrawing(const SurfaceSpec& spec) {
  return std::make_unique<SurfaceDrawing>(spec);
}

} // namespace straightedge::gui
