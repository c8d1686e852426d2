#include "app/gui/plots/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace straightedge::gui {

namespace {

constexpr double viewAngleDeg = 25.0;

SceneVector vectorOf(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

} // namespace

double SceneVector::length() const { return std::sqrt(dot(*this)); }

SceneVector SceneVector::unit() const {
  const double size = length();
  return size > 0.0 ? *this * (1.0 / size) : SceneVector{1.0, 0.0, 0.0};
}

SceneEye eyeOf(const SceneCamera& camera, const SceneBall& ball, const QSizeF& size) {
  const double azimuth = camera.azimuth * std::numbers::pi / 180.0;
  const double elevation = camera.elevation * std::numbers::pi / 180.0;
  // The view angle is that of the height: how much smaller the ball has to be than that.
  const auto left = [](double length, double room) { return std::max(0.4 * length, length - 2.0 * room); };
  const double room = size.height() / std::max(1.0, std::min(left(size.height(), ball.roomPixels.height()),
                                                             left(size.width(), ball.roomPixels.width())));
  const double distance = room * ball.radius / std::sin(0.5 * viewAngleDeg * std::numbers::pi / 180.0) / camera.zoom;
  const SceneVector away{std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation)};
  const SceneVector position = ball.middle + away * distance;
  SceneEye eye;
  eye.position = {position.x, position.y, position.z};
  eye.focus = {ball.middle.x, ball.middle.y, ball.middle.z};
  eye.viewAngleDeg = viewAngleDeg;
  if (camera.elevation > 89.0) { // straight from above "up" is away from the viewer
    eye.up = {-std::cos(azimuth), -std::sin(azimuth), 0.0};
  } else {
    eye.up = {0.0, 0.0, 1.0};
  }
  constexpr double beyond = 1.3; // of the ball: corners, thin axes
  eye.nearest = std::max(0.01 * distance, distance - beyond * ball.radius);
  eye.farthest = distance + beyond * ball.radius;
  return eye;
}

SceneProjection::SceneProjection(const SceneEye& eye, const QSizeF& size)
    : m_eye(vectorOf(eye.position)), m_ahead((vectorOf(eye.focus) - vectorOf(eye.position)).unit()), m_size(size),
      m_pixels(0.5 * size.height() / std::tan(0.5 * eye.viewAngleDeg * std::numbers::pi / 180.0)) {
  m_right = m_ahead.cross(vectorOf(eye.up)).unit();
  m_up = m_right.cross(m_ahead);
}

QPointF SceneProjection::at(const SceneVector& point) const {
  const SceneVector from = point - m_eye;
  const double scale = m_pixels / std::max(1e-9, from.dot(m_ahead));
  return {0.5 * m_size.width() + scale * from.dot(m_right), 0.5 * m_size.height() - scale * from.dot(m_up)};
}

double SceneProjection::outlineRadius(const SceneVector& middle, double radius) const {
  const double distance = depth(middle);
  return m_pixels * radius / std::sqrt(std::max(1e-12, distance * distance - radius * radius));
}

double SceneProjection::depth(const SceneVector& point) const { return (point - m_eye).dot(m_ahead); }

} // namespace straightedge::gui
