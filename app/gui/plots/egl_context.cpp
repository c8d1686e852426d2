#include "app/gui/plots/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <array>

namespace straightedge::gui {
namespace {

/// Debian's GLEW is built for GLX: under EGL it loads every entry point and then complains of a missing X display. VTK
/// 9.1 takes that for a failure and tries (and complains) again with every frame. So it is initialised once, quietly.
class QuietWindow : public vtkGenericOpenGLRenderWindow {
public:
  static QuietWindow* New() {
    auto* window = new QuietWindow;
    window->InitializeObjectBase();
    return window;
  }
  QuietWindow(const QuietWindow&) = delete;
  QuietWindow& operator=(const QuietWindow&) = delete;

  void initialiseQuietly() {
    const int before = vtkObject::GetGlobalWarningDisplay();
    vtkObject::GlobalWarningDisplayOff();
    this->OpenGLInitContext();
    vtkObject::SetGlobalWarningDisplay(before);
    this->GlewInitValid = true;
    this->Initialized = true;
    this->MaximumHardwareLineWidth = 1.0F;
  }

protected:
  QuietWindow() = default;
  ~QuietWindow() override = default;
};

void onWindowEvent(vtkObject* /*caller*/, unsigned long event, void* client, void* data) {
  auto* context = static_cast<EglContext*>(client);
  if (event == vtkCommand::WindowMakeCurrentEvent) {
    context->makeCurrent();
  } else {
    *static_cast<bool*>(data) = context->isCurrent();
  }
}

EGLDisplay openDisplay() {
  const auto platformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (platformDisplay == nullptr) {
    return EGL_NO_DISPLAY;
  }
  EGLDisplay display = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) {
    return display;
  }
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  if (queryDevices == nullptr || queryDevices(1, &device, &count) != EGL_TRUE || count < 1) {
    return EGL_NO_DISPLAY;
  }
  display = platformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE ? display : EGL_NO_DISPLAY;
}

} // namespace

struct EglContext::Impl {
  EGLDisplay display = EGL_NO_DISPLAY; ///< stays open: all contexts of the process share it
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;
};

EglContext::EglContext() : m_impl(std::make_unique<Impl>()) {}

std::unique_ptr<EglContext> EglContext::create() {
  std::unique_ptr<EglContext> result(new EglContext);
  Impl& egl = *result->m_impl;
  egl.display = openDisplay();
  if (egl.display == EGL_NO_DISPLAY || eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
    return nullptr;
  }
  constexpr std::array<EGLint, 13> wanted = {EGL_SURFACE_TYPE,
                                             EGL_PBUFFER_BIT,
                                             EGL_RENDERABLE_TYPE,
                                             EGL_OPENGL_BIT,
                                             EGL_RED_SIZE,
                                             8,
                                             EGL_GREEN_SIZE,
                                             8,
                                             EGL_BLUE_SIZE,
                                             8,
                                             EGL_ALPHA_SIZE,
                                             8,
                                             EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(egl.display, wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
    return nullptr;
  }
  constexpr std::array<EGLint, 7> version = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  egl.context = eglCreateContext(egl.display, config, EGL_NO_CONTEXT, version.data());
  constexpr std::array<EGLint, 5> size = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
  egl.surface = eglCreatePbufferSurface(egl.display, config, size.data());
  if (egl.context == EGL_NO_CONTEXT || eglMakeCurrent(egl.display, egl.surface, egl.surface, egl.context) != EGL_TRUE) {
    return nullptr;
  }
  return result;
}

EglContext::~EglContext() {
  Impl& egl = *m_impl;
  if (egl.context != EGL_NO_CONTEXT) {
    if (isCurrent()) {
      release();
    }
    eglDestroyContext(egl.display, egl.context);
  }
  if (egl.surface != EGL_NO_SURFACE) {
    eglDestroySurface(egl.display, egl.surface);
  }
}

void EglContext::makeCurrent() {
  eglBindAPI(EGL_OPENGL_API);
  eglMakeCurrent(m_impl->display, m_impl->surface, m_impl->surface, m_impl->context);
}

void EglContext::release() {
  eglBindAPI(EGL_OPENGL_API);
  eglMakeCurrent(m_impl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool EglContext::isCurrent() const { return eglGetCurrentContext() == m_impl->context; }

vtkSmartPointer<vtkGenericOpenGLRenderWindow> EglContext::makeWindow() {
  auto window = vtkSmartPointer<QuietWindow>::New();
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(this);
  callback->SetCallback(onWindowEvent);
  window->AddObserver(vtkCommand::WindowMakeCurrentEvent, callback);
  window->AddObserver(vtkCommand::WindowIsCurrentEvent, callback);
  window->SetOwnContext(0);
  window->SetReadyForRendering(true);
  window->SetFrameBlitModeToNoBlit();
  window->SetForceMaximumHardwareLineWidth(1.0F);
  window->initialiseQuietly();
  return window;
}

} // namespace straightedge::gui
