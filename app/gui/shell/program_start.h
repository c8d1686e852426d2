// From arguments to a running program.
#pragma once

#include <QString>
#include <QStringList>

class QApplication;

namespace straightedge::gui {

struct ProgramOptions {
  bool help = false;
  bool version = false;
  bool simulated = false;      ///< begin on the simulated angle bench
  bool simulatedField = false; ///< begin on the simulated field bench
  bool render = false;         ///< --render …: pictures and report without a window
  QStringList files;           ///< at most one
  QString problem;             ///< wrong usage, as a sentence; empty where all is well
};

/// `arguments` without the program's name. Options of the form that Qt itself understands (-platform …) are left alone.
ProgramOptions parseProgramOptions(const QStringList& arguments);

QString programUsage();

/// Why no window can be shown here; empty where one can. Looks at the environment only.
QString missingDisplay();

/// Names, resources and looks: before the first window, in the program and in tests.
void prepareApplication(QApplication& application);

} // namespace straightedge::gui
