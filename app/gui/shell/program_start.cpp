#include "app/gui/shell/program_start.h"

#include "app/gui/shell/theme.h"

#include <QApplication>
#include <QIcon>
#include <QSettings>

// Resources of a static library are linked in only where somebody asks for them; must stand outside of namespaces.
static void initResources() { Q_INIT_RESOURCE(straightedge); }

namespace straightedge::gui {

ProgramOptions parseProgramOptions(const QStringList& arguments) {
  ProgramOptions options;
  if (arguments.contains("--render")) {
    options.render = true; // everything else is the render command's
    return options;
  }
  bool optionsEnded = false;
  for (qsizetype i = 0; i < arguments.size(); ++i) {
    const QString& argument = arguments[i];
    if (optionsEnded || !argument.startsWith('-') || argument == "-") {
      options.files << argument;
    } else if (argument == "--") {
      optionsEnded = true;
    } else if (argument == "--help" || argument == "-h") {
      options.help = true;
    } else if (argument == "--version") {
      options.version = true;
    } else if (argument == "--simulated") {
      options.simulated = true;
    } else if (argument == "--simulated-field") {
      options.simulatedField = true;
    } else if (argument == "-platform" || argument == "-style") {
      ++i;
    } else {
      options.problem = QStringLiteral("unknown option %1; see straightedge --help").arg(argument);
      return options;
    }
  }
  if (options.files.size() > 1) {
    options.problem =
        QStringLiteral("one file at a time, %1 were given; start the program once for each").arg(options.files.size());
  } else if (options.simulated && options.simulatedField) {
    options.problem = QStringLiteral("--simulated and --simulated-field exclude each other; give one of them");
  } else if ((options.simulated || options.simulatedField) && !options.files.isEmpty()) {
    options.problem = QStringLiteral("%1 begins a new calibration; leave the file out")
                          .arg(options.simulated ? "--simulated" : "--simulated-field");
  }
  return options;
}

QString programUsage() {
  return QStringLiteral(
      "Usage: straightedge [OPTION] [FILE]\n"
      "       straightedge --render CALIBRATION.json --out DIR\n"
      "\n"
      "Calibrates angle sensors and field probes. FILE is a calibration (.sedge) to open, or a sweep or a\n"
      "campaign (.csv) to import.\n"
      "\n"
      "Options:\n"
      "  --simulated         begin a new angle calibration on the simulated bench\n"
      "  --simulated-field   begin a new field calibration on the simulated bench\n"
      "  --render            draw plots and report of a calibration without a display\n"
      "  -h, --help          print this and end\n"
      "  --version           print the version and end\n"
      "\n"
      "Without a display use straightedge-cli.\n");
}

QString missingDisplay() {
#ifdef Q_OS_LINUX
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || !qEnvironmentVariableIsEmpty("DISPLAY") ||
      !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) {
    return {};
  }
  return QStringLiteral("there is no display to show a window on (neither DISPLAY nor WAYLAND_DISPLAY is set); use "
                        "straightedge-cli, or straightedge --render for pictures");
#else
  return {};
#endif
}

void prepareApplication(QApplication& application) {
  initResources();
  QApplication::setOrganizationName("Straightedge");
  QApplication::setApplicationName("straightedge");
  QApplication::setApplicationDisplayName("Straightedge");
  QApplication::setApplicationVersion(STRAIGHTEDGE_VERSION);
  QGuiApplication::setDesktopFileName("straightedge");
  applyTheme(application, themeFromName(QSettings().value("theme").toString()));
}

} // namespace straightedge::gui
