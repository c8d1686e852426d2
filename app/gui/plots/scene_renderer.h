// What the module with OpenGL (lib/straightedge/straightedge_gl.so) does for the program, as a pure interface:
// triangles and lines in, pixels out. Neither side links the other: the program loads the module when the first
// three-dimensional picture is wanted (scene_module.h), so that starting it costs no OpenGL. No Qt and no VTK here.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace straightedge::gui {

using SceneColor = std::array<std::uint8_t, 3>; ///< red, green, blue

/// Triangles with a colour at every corner.
struct SceneMesh {
  std::vector<float> points;           ///< x, y, z of every corner
  std::vector<std::uint8_t> colors;    ///< red, green, blue of every corner
  std::vector<std::int32_t> triangles; ///< three corners each
  bool sharpEdges = false;             ///< edges of more than 40° stay edges, softer ones are shaded round
  double ambient = 0.35;               ///< light from everywhere; the more, the truer the colours, the flatter the body
  double opacity = 1.0;                ///< below 1 only what faces the viewer is drawn, after everything opaque
};

/// Straight pieces of one colour, without light.
struct SceneLines {
  std::vector<float> points; ///< x, y, z of both ends, piece after piece
  SceneColor color = {0, 0, 0};
  double widthPixels = 1.0;
};

struct SceneGeometry {
  std::vector<SceneMesh> meshes;
  std::vector<SceneLines> lines;
};

/// Where it is looked at from, in perspective.
struct SceneEye {
  std::array<double, 3> position = {0.0, 0.0, 1.0};
  std::array<double, 3> focus = {0.0, 0.0, 0.0};
  std::array<double, 3> up = {0.0, 1.0, 0.0};
  double viewAngleDeg = 25.0; ///< from the upper to the lower edge
  double nearest = 0.1, farthest = 10.0;
};

struct SceneFrame {
  int width = 1, height = 1; ///< pixels
  int samples = 0;           ///< per pixel; software OpenGL is slow with 4, the most it has
  SceneColor background = {255, 255, 255};
  SceneEye eye;
};

/// Any thread, one call at a time; its OpenGL context is nobody's between calls.
class SceneRenderer {
public:
  SceneRenderer() = default;
  virtual ~SceneRenderer() = default;
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Four bytes a pixel (red, green, blue, of no meaning), the lowest row first. Empty where it could not be drawn.
  virtual std::vector<std::uint8_t> render(const SceneGeometry& geometry, const SceneFrame& frame) = 0;
};

/// What the module exports, under a name that changes with this header.
inline constexpr const char* sceneRendererSymbol = "straightedgeSceneRenderer1";
/// Null where there is no OpenGL 3.2 by EGL.
using MakeSceneRenderer = SceneRenderer* (*)();

} // namespace straightedge::gui
