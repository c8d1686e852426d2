// Directions covered on a sphere: a filled cap where a direction was measured, a ring where it was not.
#include "app/gui/plots/scene_colors.h"
#include "app/gui/plots/scene_drawing.h"
#include "app/gui/plots/scene_lettering.h"
#include "app/gui/plots/scene_shapes.h"
#include "app/gui/plots/theme.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace straightedge::gui {
namespace {

constexpr double capDeg = 16.0;
constexpr double aboveBall = 1.004; ///< marks lie on the ball, not in it
constexpr double outside = 10.0;    ///< pixels from the ball to its labels

SceneVector directionOf(const SphereMark& mark) {
  return SceneVector{mark.direction[0], mark.direction[1], mark.direction[2]}.unit();
}

class SphereDrawing : public SceneDrawing {
public:
  explicit SphereDrawing(const SphereSpec& spec) : m_spec(spec) {}

  SceneBall ball() const override { return {{}, 1.0, {92.0, 58.0}}; }

  SceneGeometry geometry(const SceneCamera& /*camera*/, PlotTheme theme, double pixelRatio) const override {
    SceneGeometry geometry;
    const PlotColors colors = PlotColors::of(theme);
    SceneMesh marks;
    for (const SphereMark& mark : m_spec.marks) {
      const SceneColor color = sceneColor(markColor(mark, theme));
      if (mark.covered) {
        addCap(marks, directionOf(mark), aboveBall, capDeg, color);
      } else {
        addRing(marks, directionOf(mark), aboveBall, 0.75 * capDeg, capDeg, color);
      }
    }
    geometry.meshes.push_back(marks);
    SceneMesh ball = ballMesh(1.0, sceneColor(colors.axis));
    ball.opacity = 0.22; // the marks at the back show through
    geometry.meshes.push_back(ball);
    SceneLines net;
    net.color = sceneColor(colors.grid);
    net.widthPixels = pixelRatio;
    constexpr int around = 72;
    for (int i = 0; i < 6; ++i) { // meridians
      addPath(net, circle(
                       [i](double t) {
                         return SceneVector{std::sin(t) * std::cos(std::numbers::pi * i / 6.0),
                                            std::sin(t) * std::sin(std::numbers::pi * i / 6.0), std::cos(t)};
                       },
                       around));
    }
    for (const double latitude : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
      const double l = latitude * std::numbers::pi / 180.0;
      addPath(net, circle(
                       [l](double t) {
                         return SceneVector{std::cos(l) * std::cos(t), std::cos(l) * std::sin(t), std::sin(l)};
                       },
                       around));
    }
    geometry.lines.push_back(net);
    return geometry;
  }

  void letter(QPainter& painter, const QRectF& area, const SceneProjection& projection, const SceneCamera& /*camera*/,
              PlotTheme theme) const override {
    const PlotColors colors = PlotColors::of(theme);
    const PlotFonts fonts = PlotFonts::standard();
    SceneLettering lettering(painter, area, colors.background);
    const QPointF middle = projection.at({});
    QList<const SphereMark*> order; // those in front first: they get the best places
    for (const SphereMark& mark : m_spec.marks) {
      order << &mark;
    }
    std::ranges::stable_sort(order, [&projection](const SphereMark* a, const SphereMark* b) {
      return projection.depth(directionOf(*a)) < projection.depth(directionOf(*b));
    });
    const double middleDepth = projection.depth({});
    const double radius = projection.outlineRadius({}, 1.0);
    for (const SphereMark* mark : order) {
      const bool behind = projection.depth(directionOf(*mark)) > middleDepth;
      const QColor first = behind ? colors.softText : colors.text;
      const QPointF at = projection.at(directionOf(*mark) * aboveBall);
      const QLineF out(middle, at);
      const QPointF outward = out.length() > 1.0 ? out.p2() - out.p1() : QPointF(0.0, -1.0);
      const QPointF beside = middle + outward * ((radius + outside) / std::hypot(outward.x(), outward.y()));
      painter.setPen(QPen(colors.axis, 1.0));
      painter.drawLine(at, beside);
      lettering.writeBeside(beside, middle,
                            QStringList(mark->name + (behind ? QStringLiteral(" (behind)") : QString())) +
                                mark->detail.split(QStringLiteral(", ")),
                            fonts.label, first, mark->covered ? colors.softText : markColor(*mark, theme));
    }
  }

private:
  static QColor markColor(const SphereMark& mark, PlotTheme theme) {
    return PlotColors::series(mark.covered ? SeriesColor::First : SeriesColor::Second, theme);
  }

  template <typename At>
  static std::vector<SceneVector> circle(At at, int pieces) {
    std::vector<SceneVector> points;
    for (int i = 0; i <= pieces; ++i) {
      points.push_back(at(2.0 * std::numbers::pi * i / pieces));
    }
    return points;
  }

  SphereSpec m_spec;
};

} // namespace

std::unique_ptr<SceneDrawing> makeSphereDrawing(const SphereSpec& spec) {
  return std::make_unique<SphereDrawing>(spec);
}

} // namespace straightedge::gui
