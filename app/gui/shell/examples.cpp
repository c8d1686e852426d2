#include "app/gui/shell/examples.h"

#include <QCoreApplication>

namespace straightedge::gui {

namespace {
QString sayExample(const char* text) { return QCoreApplication::translate("Examples", text); }
} // namespace

QList<Example> examples() {
  return {{":/examples/side_shaft_32.csv", sayExample("Side-shaft magnet, 32 points"),
           sayExample("A recorded turn in steps of 11.25°")},
          {":/examples/side_shaft_two_turns.csv", sayExample("Side-shaft magnet, two turns, both directions"),
           sayExample("Simulated; shows hysteresis and repeatability")},
          {":/examples/on_axis_64.csv", sayExample("Magnet on the shaft's end, 64 points"),
           sayExample("Simulated; a small correction")},
          {":/examples/hall_probe_campaign.csv", sayExample("Hall teslameter, a short campaign"),
           sayExample("Simulated; field calibration with every stage")}};
}

} // namespace straightedge::gui
