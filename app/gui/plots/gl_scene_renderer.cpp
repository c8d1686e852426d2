// The module with OpenGL: the one place, with egl_context, that is linked with it. Loaded late, see scene_renderer.h.
#include "app/gui/plots/egl_context.h"
#include "app/gui/plots/scene_renderer.h"

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
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <mutex>

namespace straightedge::gui {
namespace {

/// GLEW keeps OpenGL's entry points in globals: one renderer at a time starts or draws.
std::mutex& openGlTurn() {
  static std::mutex turn;
  return turn;
}

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<float>& coordinates) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(static_cast<vtkIdType>(coordinates.size() / 3));
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    points->SetPoint(static_cast<vtkIdType>(i / 3), static_cast<double>(coordinates[i]),
                     static_cast<double>(coordinates[i + 1]), static_cast<double>(coordinates[i + 2]));
  }
  return points;
}

vtkSmartPointer<vtkActor> actorOf(const SceneMesh& mesh) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(pointsOf(mesh.points));
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const std::array<vtkIdType, 3> corners = {mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]};
    cells->InsertNextCell(3, corners.data());
  }
  data->SetPolys(cells);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(mesh.colors.size() / 3));
  std::ranges::copy(mesh.colors, colors->GetPointer(0));
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SetSplitting(mesh.sharpEdges ? 1 : 0);
  normals->SetFeatureAngle(40.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(mesh.ambient);
  actor->GetProperty()->SetDiffuse(1.02 - mesh.ambient);
  if (mesh.opacity < 1.0) {
    actor->GetProperty()->SetOpacity(mesh.opacity);
    actor->GetProperty()->BackfaceCullingOn();
  }
  return actor;
}

vtkSmartPointer<vtkActor> actorOf(const SceneLines& lines) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(pointsOf(lines.points));
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i + 1 < static_cast<vtkIdType>(lines.points.size() / 3); i += 2) {
    const std::array<vtkIdType, 2> ends = {i, i + 1};
    cells->InsertNextCell(2, ends.data());
  }
  data->SetLines(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(lines.widthPixels));
  actor->GetProperty()->SetColor(lines.color[0] / 255.0, lines.color[1] / 255.0, lines.color[2] / 255.0);
  return actor;
}

class GlSceneRenderer : public SceneRenderer {
public:
  /// With the context current.
  explicit GlSceneRenderer(std::unique_ptr<EglContext> egl) : m_egl(std::move(egl)), m_window(m_egl->makeWindow()) {
    m_window->AddRenderer(m_renderer);
    m_renderer->GetActiveCamera()->UseHorizontalViewAngleOff();
  }
  ~GlSceneRenderer() override {
    const std::scoped_lock turn(openGlTurn());
    m_egl->makeCurrent();
    m_window->Finalize();
    m_window->RemoveAllObservers();
    m_window = nullptr;
    m_egl->release();
  }
  GlSceneRenderer(const GlSceneRenderer&) = delete;
  GlSceneRenderer& operator=(const GlSceneRenderer&) = delete;

  std::vector<std::uint8_t> render(const SceneGeometry& geometry, const SceneFrame& frame) override {
    const std::scoped_lock turn(openGlTurn());
    m_egl->makeCurrent();
    if (!m_egl->isCurrent()) {
      return {};
    }
    m_renderer->RemoveAllViewProps();
    for (const SceneLines& lines : geometry.lines) {
      m_renderer->AddActor(actorOf(lines));
    }
    for (const SceneMesh& mesh : geometry.meshes) {
      m_renderer->AddActor(actorOf(mesh));
    }
    m_renderer->SetBackground(frame.background[0] / 255.0, frame.background[1] / 255.0, frame.background[2] / 255.0);
    place(frame.eye);
    m_window->SetMultiSamples(frame.samples);
    m_window->SetSize(frame.width, frame.height);
    m_window->Render();
    vtkNew<vtkUnsignedCharArray> buffer;
    m_window->GetRGBACharPixelData(0, 0, frame.width - 1, frame.height - 1, 0, buffer);
    const std::uint8_t* pixels = buffer->GetPointer(0);
    std::vector<std::uint8_t> bytes(pixels, pixels + buffer->GetNumberOfValues());
    m_egl->release();
    return bytes;
  }

private:
  void place(const SceneEye& eye) {
    vtkCamera* camera = m_renderer->GetActiveCamera();
    camera->SetPosition(eye.position.data());
    camera->SetFocalPoint(eye.focus.data());
    camera->SetViewUp(eye.up.data());
    camera->SetViewAngle(eye.viewAngleDeg);
    camera->SetClippingRange(eye.nearest, eye.farthest);
  }

  std::unique_ptr<EglContext> m_egl; // first: the last to go
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> m_window;
  vtkNew<vtkRenderer> m_renderer;
};

} // namespace
} // namespace straightedge::gui

/// See sceneRendererSymbol.
extern "C" __attribute__((visibility("default"))) straightedge::gui::SceneRenderer* straightedgeSceneRenderer1() {
  using namespace straightedge::gui;
  const std::scoped_lock turn(openGlTurn());
  auto egl = EglContext::create();
  if (!egl) {
    return nullptr;
  }
  EglContext& context = *egl;
  auto* renderer = new GlSceneRenderer(std::move(egl));
  context.release();
  return renderer;
}
