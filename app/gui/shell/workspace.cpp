#include "app/gui/shell/workspace.h"

namespace straightedge::gui {

int stepIndex(std::span<const StepEntry> steps, const QString& title) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (title.compare(QLatin1String(steps[i].title), Qt::CaseInsensitive) == 0) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

} // namespace straightedge::gui
