// Measured axes as arrows against thin nominal ones; the angle between is drawn larger and shown as an arc.
#include "app/gui/plots/scene_colors.h"
#include "app/gui/plots/scene_drawing.h"
#include "app/gui/plots/scene_lettering.h"
#include "app/gui/plots/scene_shapes.h"
#include "app/gui/plots/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace straightedge::gui {
namespace {

constexpr double nominalReach = 1.12; ///< the thin axes end beyond the arrows' tips

SceneVector directionOf(const std::array<double, 3>& v) { return SceneVector{v[0], v[1], v[2]}.unit(); }

class DirectionsDrawing : public SceneDrawing {
public:
  explicit DirectionsDrawing(const DirectionsSpec& spec) : m_spec(spec) {
    SceneVector sum;
    for (const MeasuredDirection& direction : m_spec.directions) {
      sum = sum + directionOf(direction.nominal);
    }
    m_ball = {sum * (1.0 / std::max<double>(1.0, static_cast<double>(m_spec.directions.size()))), 0.9, {110.0, 28.0}};
  }

  SceneBall ball() const override { return m_ball; }

  SceneGeometry geometry(const SceneCamera& /*camera*/, PlotTheme theme, double pixelRatio) const override {
    SceneGeometry geometry;
    SceneLines nominal;
    nominal.color = sceneColor(PlotColors::of(theme).axis);
    nominal.widthPixels = pixelRatio;
    SceneMesh arrows;
    arrows.sharpEdges = true;
    for (const MeasuredDirection& direction : m_spec.directions) {
      const SceneVector along = directionOf(direction.nominal);
      addPath(nominal, {{}, along * nominalReach});
      const SceneColor color = sceneColor(PlotColors::series(direction.color, theme));
      addArrow(arrows, {}, drawn(direction), color);
      SceneLines arc;
      arc.color = color;
      arc.widthPixels = 1.5 * pixelRatio;
      addPath(arc, arcOf(direction, 0.7));
      geometry.lines.push_back(arc);
    }
    geometry.lines.push_back(nominal);
    geometry.meshes.push_back(arrows);
    return geometry;
  }

  void letter(QPainter& painter, const QRectF& area, const SceneProjection& projection, const SceneCamera& /*camera*/,
              PlotTheme theme) const override {
    const PlotColors colors = PlotColors::of(theme);
    const PlotFonts fonts = PlotFonts::standard();
    SceneLettering lettering(painter, area, colors.background);
    const QPointF origin = projection.at({});
    QPointF middle = origin; // of all ends: labels stand outside
    for (const MeasuredDirection& direction : m_spec.directions) {
      middle += projection.at(drawn(direction));
    }
    middle /= static_cast<double>(m_spec.directions.size()) + 1.0;
    for (const MeasuredDirection& direction : m_spec.directions) {
      const QColor color = PlotColors::series(direction.color, theme);
      lettering.writeBeside(projection.at(drawn(direction)), middle, {direction.label}, fonts.axisTitle, color, color);
    }
    for (const MeasuredDirection& direction : m_spec.directions) {
      lettering.writeBeside(projection.at(directionOf(direction.nominal) * nominalReach), origin,
                            {direction.nominalLabel}, fonts.label, colors.softText, colors.softText);
    }
  }

private:
  double angleOf(const MeasuredDirection& direction) const {
    const SceneVector nominal = directionOf(direction.nominal);
    const SceneVector measured = directionOf(direction.measured);
    return std::atan2(nominal.cross(measured).length(), nominal.dot(measured));
  }

  SceneVector drawn(const MeasuredDirection& direction) const {
    return turned(directionOf(direction.nominal), directionOf(direction.measured),
                  m_spec.exaggeration * angleOf(direction));
  }

  std::vector<SceneVector> arcOf(const MeasuredDirection& direction, double radius) const {
    constexpr int pieces = 16;
    std::vector<SceneVector> points;
    for (int i = 0; i <= pieces; ++i) {
      points.push_back(turned(directionOf(direction.nominal), directionOf(direction.measured),
                              m_spec.exaggeration * angleOf(direction) * i / pieces) *
                       radius);
    }
    return points;
  }

  DirectionsSpec m_spec;
  SceneBall m_ball;
};

} // namespace

std::unique_ptr<SceneDrawing> makeDirectionsDrawing(const DirectionsSpec& spec) {
  return std::make_unique<DirectionsDrawing>(spec);
}

} // namespace straightedge::gui
