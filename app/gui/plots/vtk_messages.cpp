#include "app/gui/plots/vtk_messages.h"

#include <QLoggingCategory>
#include <QString>
#include <vtkNew.h>
#include <vtkOutputWindow.h>

#include <mutex>

namespace straightedge::gui {
namespace {

Q_LOGGING_CATEGORY(vtkLog, "straightedge.vtk")

class LogWindow : public vtkOutputWindow {
public:
  static LogWindow* New() {
    auto* window = new LogWindow;
    window->InitializeObjectBase();
    return window;
  }
  LogWindow(const LogWindow&) = delete;
  LogWindow& operator=(const LogWindow&) = delete;

  void DisplayText(const char* text) override { qCWarning(vtkLog).noquote() << QString::fromUtf8(text).simplified(); }
  void DisplayDebugText(const char* text) override {
    qCDebug(vtkLog).noquote() << QString::fromUtf8(text).simplified();
  }

protected:
  LogWindow() = default;
  ~LogWindow() override = default;
};

} // namespace

void sendVtkMessagesToLog() {
  static std::once_flag once;
  std::call_once(once, [] {
    vtkNew<LogWindow> window;
    vtkOutputWindow::SetInstance(window);
  });
}

} // namespace straightedge::gui
