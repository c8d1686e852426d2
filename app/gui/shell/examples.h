// Example sweeps and campaigns that are part of the program.
#pragma once

#include <QList>
#include <QString>

namespace straightedge::gui {

struct Example {
  QString resource; ///< path in the program's resources
  QString title;
  QString description;
};

QList<Example> examples();

} // namespace straightedge::gui
