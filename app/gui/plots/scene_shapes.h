// Solid bodies as triangles for three-dimensional pictures. Private to plots.
#pragma once

#include "app/gui/plots/scene_camera.h"
#include "app/gui/plots/scene_renderer.h"

namespace straightedge::gui {

/// Adds a shaft with a head from `from` to `to`; radii are shares of its length.
void addArrow(SceneMesh& mesh, const SceneVector& from, const SceneVector& to, const SceneColor& color);

/// A ball about the origin.
SceneMesh ballMesh(double radius, const SceneColor& color);

/// Adds the part of a ball about the origin within `angleDeg` of a direction.
void addCap(SceneMesh& mesh, const SceneVector& direction, double radius, double angleDeg, const SceneColor& color);

/// Adds a band on a ball about the origin, from one angle to another about a direction.
void addRing(SceneMesh& mesh, const SceneVector& direction, double radius, double innerDeg, double outerDeg,
             const SceneColor& color);

/// Adds a line from point to point.
void addPath(SceneLines& lines, const std::vector<SceneVector>& points);

/// `angle` radians from `from` towards `to`, both of length 1; `from` where they point the same way.
SceneVector turned(const SceneVector& from, const SceneVector& to, double angle);

} // namespace straightedge::gui
