#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/steps/placeholder_step.h"

#include <QCoreApplication>

namespace straightedge::gui {

StepPage* makeFieldConnectStep(FieldStepContext, QWidget* parent) {
  const QString instead = QCoreApplication::translate(
      "FieldConnectStep",
      "<p>The window does not connect to a bench for field calibrations yet. There are two other ways to data:</p>"
      "<p><b>Capture on the command line</b>, here with the simulated bench, and open the session afterwards with "
      "File &gt; Open:</p><p><tt>straightedge-cli capture field --bench simulated --session probe.sedge</tt></p>"
      "<p><b>Import a campaign</b> that was recorded elsewhere with File &gt; Import CSV, or drop its file "
      "<tt>campaign.csv</tt> on the window. The help names its columns.</p>");
  return new PlaceholderStep(QStringLiteral("Connect"), QStringLiteral("field"), instead, parent);
}

} // namespace straightedge::gui
