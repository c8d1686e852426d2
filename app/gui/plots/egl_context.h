// OpenGL without a window system: an EGL context on no surface (Mesa), or on the first EGL device.
#pragma once

#include <vtkSmartPointer.h>

#include <memory>

class vtkGenericOpenGLRenderWindow;

namespace straightedge::gui {

/// Current in one thread at a time: in the one that made it until it is released. Outlives the windows it makes.
class EglContext {
public:
  /// Nothing where there is no EGL with desktop OpenGL 3.2.
  static std::unique_ptr<EglContext> create();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void makeCurrent();
  void release(); ///< current nowhere: another thread may take it
  bool isCurrent() const;
  /// A render window that draws off screen in this context.
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> makeWindow();

private:
  EglContext();
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
