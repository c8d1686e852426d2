// Where a three-dimensional picture is looked at from, and where its points come to lie in it.
#pragma once

#include "app/gui/plots/scene_renderer.h"

#include <QPointF>
#include <QSizeF>

namespace straightedge::gui {

/// Angles in degrees; zoom 1 shows the whole.
struct SceneCamera {
  double azimuth = -55.0;
  double elevation = 28.0; ///< −5 … 90
  double zoom = 1.0;

  bool operator==(const SceneCamera&) const = default;
};

struct SceneVector {
  double x = 0.0, y = 0.0, z = 0.0;

  SceneVector operator+(const SceneVector& o) const { return {x + o.x, y + o.y, z + o.z}; }
  SceneVector operator-(const SceneVector& o) const { return {x - o.x, y - o.y, z - o.z}; }
  SceneVector operator*(double s) const { return {s * x, s * y, s * z}; }
  double dot(const SceneVector& o) const { return x * o.x + y * o.y + z * o.z; }
  SceneVector cross(const SceneVector& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
  double length() const;
  SceneVector unit() const; ///< of length 1; x where it has none
};

/// The ball that a picture shows at zoom 1, and the room for letters about it, at either side and above and below.
struct SceneBall {
  SceneVector middle;
  double radius = 1.0;
  QSizeF roomPixels = {0.0, 0.0};
};

/// The eye that sees the ball filling a picture of this size.
SceneEye eyeOf(const SceneCamera& camera, const SceneBall& ball, const QSizeF& size);

/// Points in space to points of a picture, in logical pixels from its upper left corner.
class SceneProjection {
public:
  SceneProjection(const SceneEye& eye, const QSizeF& size);

  QPointF at(const SceneVector& point) const;
  double depth(const SceneVector& point) const; ///< distance along the line of sight
  /// Of a ball in the middle of the picture as it is seen.
  double outlineRadius(const SceneVector& middle, double radius) const;

private:
  SceneVector m_eye, m_right, m_up, m_ahead;
  QSizeF m_size;
  double m_pixels; ///< per unit at depth 1
};

} // namespace straightedge::gui
