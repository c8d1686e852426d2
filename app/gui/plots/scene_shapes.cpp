#include "app/gui/plots/scene_shapes.h"

#include <cmath>
#include <numbers>

namespace straightedge::gui {

namespace {

constexpr int sectors = 36; ///< around a body

std::int32_t addCorner(SceneMesh& mesh, const SceneVector& point, const SceneColor& color) {
  for (const double c : {point.x, point.y, point.z}) {
    mesh.points.push_back(static_cast<float>(c));
  }
  mesh.colors.insert(mesh.colors.end(), color.begin(), color.end());
  return static_cast<std::int32_t>(mesh.points.size() / 3) - 1;
}

/// Two directions at right angles to one another and to this one.
std::pair<SceneVector, SceneVector> twoAcross(const SceneVector& direction) {
  const SceneVector other =
      std::abs(direction.x) < 0.7 * direction.length() ? SceneVector{1.0, 0.0, 0.0} : SceneVector{0.0, 1.0, 0.0};
  const SceneVector first = direction.cross(other).unit();
  return {first, direction.unit().cross(first)};
}

/// Circles one after the other along an axis, joined by bands; radius 0 is a point.
struct Circle {
  SceneVector middle;
  double radius = 0.0;
};

void addTurned(SceneMesh& mesh, const SceneVector& axis, const std::vector<Circle>& circles, const SceneColor& color) {
  const auto [u, v] = twoAcross(axis);
  std::int32_t before = -1;
  for (const Circle& circle : circles) {
    const auto first = static_cast<std::int32_t>(mesh.points.size() / 3);
    for (int i = 0; i < sectors; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / sectors;
      addCorner(mesh, circle.middle + (u * std::cos(turn) + v * std::sin(turn)) * circle.radius, color);
    }
    for (std::int32_t i = 0; before >= 0 && i < sectors; ++i) {
      const std::int32_t j = (i + 1) % sectors;
      mesh.triangles.insert(mesh.triangles.end(),
                            {before + i, before + j, first + j, before + i, first + j, first + i});
    }
    before = first;
  }
}

/// Circles of a ball about the origin, between two angles from a direction.
std::vector<Circle> ballCircles(const SceneVector& direction, double radius, double fromDeg, double toDeg, int bands) {
  std::vector<Circle> circles;
  for (int i = 0; i <= bands; ++i) {
    const double angle = (fromDeg + (toDeg - fromDeg) * i / bands) * std::numbers::pi / 180.0;
    circles.push_back({direction.unit() * (radius * std::cos(angle)), radius * std::sin(angle)});
  }
  return circles;
}

} // namespace

void addArrow(SceneMesh& mesh, const SceneVector& from, const SceneVector& to, const SceneColor& color) {
  constexpr double shaft = 0.018;
  constexpr double head = 0.05;
  constexpr double headLength = 0.16;
  const SceneVector along = to - from;
  const double length = along.length();
  const SceneVector neck = from + along * (1.0 - headLength);
  addTurned(mesh, along,
            {{from, 0.0}, {from, shaft * length}, {neck, shaft * length}, {neck, head * length}, {to, 0.0}}, color);
}

SceneMesh ballMesh(double radius, const SceneColor& color) {
  SceneMesh mesh;
  addTurned(mesh, {0.0, 0.0, 1.0}, ballCircles({0.0, 0.0, -1.0}, radius, 0.0, 180.0, 24), color);
  return mesh;
}

void addCap(SceneMesh& mesh, const SceneVector& direction, double radius, double angleDeg, const SceneColor& color) {
  addTurned(mesh, direction, ballCircles(direction, radius, angleDeg, 0.0, 6), color);
}

void addRing(SceneMesh& mesh, const SceneVector& direction, double radius, double innerDeg, double outerDeg,
             const SceneColor& color) {
  addTurned(mesh, direction, ballCircles(direction, radius, outerDeg, innerDeg, 2), color);
}

void addPath(SceneLines& lines, const std::vector<SceneVector>& points) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    for (const SceneVector& end : {points[i], points[i + 1]}) {
      for (const double c : {end.x, end.y, end.z}) {
        lines.points.push_back(static_cast<float>(c));
      }
    }
  }
}

SceneVector turned(const SceneVector& from, const SceneVector& to, double angle) {
  const SceneVector aside = to - from * from.dot(to);
  if (!(aside.length() > 1e-12)) {
    return from;
  }
  return from * std::cos(angle) + aside.unit() * std::sin(angle);
}

} // namespace straightedge::gui
