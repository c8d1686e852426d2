#include "app/gui/figures/render_command.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/program_start.h"

#include <QApplication>
#include <QTimer>

#include <cstdio>

namespace {

constexpr int wrongUsage = 2;

QStringList argumentsOf(int argc, char** argv) {
  QStringList arguments;
  for (int i = 1; i < argc; ++i) {
    arguments << QString::fromLocal8Bit(argv[i]);
  }
  return arguments;
}

int refuse(const QString& problem) {
  std::fputs(qPrintable("straightedge: " + problem + "\n"), stderr);
  return wrongUsage;
}

} // namespace

int main(int argc, char** argv) {
  using namespace straightedge::gui;
  const QStringList arguments = argumentsOf(argc, argv);
  const ProgramOptions options = parseProgramOptions(arguments);
  if (!options.problem.isEmpty()) {
    return refuse(options.problem);
  }
  if (options.help) {
    std::fputs(qPrintable(programUsage()), stdout);
    return 0;
  }
  if (options.version) {
    std::puts("straightedge " STRAIGHTEDGE_VERSION);
    return 0;
  }
  if (options.render) {
    qputenv("QT_QPA_PLATFORM", "offscreen"); // before the first QGuiApplication
    const QGuiApplication application(argc, argv);
    return renderCalibration(arguments.mid(arguments.indexOf("--render") + 1));
  }
  if (const QString problem = missingDisplay(); !problem.isEmpty()) {
    return refuse(problem);
  }
  QApplication application(argc, argv);
  prepareApplication(application);
  MainWindow window;
  window.show();
  if (options.simulated) {
    QTimer::singleShot(0, &window, &MainWindow::startSimulatedBench);
  } else if (options.simulatedField) {
    QTimer::singleShot(0, &window, &MainWindow::startSimulatedFieldBench);
  } else if (!options.files.isEmpty()) {
    QTimer::singleShot(0, &window, [&window, file = options.files.first()] { window.openFile(file); });
  }
  return QApplication::exec();
}
