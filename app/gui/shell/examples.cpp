#include "app/gui/shell/examples.h"

#include <QCoreApplication>

namespace straightedge::gui {

namespace {
QString say(const char* text) { return QCoreApplication::translate("Examples", text); }
} // namespace

QList<Example> examples() {
  return {{":/examples/side_shaft_32.csv", say("Side-shaft magnet, 32 points"),
           say("One turn in steps of 11.25°; the raw error exceeds 20°")}};
}

} // namespace straightedge::gui
