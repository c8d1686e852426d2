#include "app/gui/shell/examples.h"

#include <QCoreApplication>

namespace straightedge::gui {

namespace {
QString sayExample(const char* text) { return QCoreApplication::translate("Examples", text); }
} // namespace

QList<Example> examples() {
  return {{":/examples/side_shaft_32.csv", sayExample("Side-shaft magnet, 32 points"),
           sayExample("Steps of 11.25°, raw error above 20°")}};
}

} // namespace straightedge::gui
