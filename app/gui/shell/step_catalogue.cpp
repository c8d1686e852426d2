#include "app/gui/shell/step_catalogue.h"

namespace straightedge::gui {

const std::array<StepEntry, stepCount>& stepCatalogue() {
  static const std::array<StepEntry, stepCount> steps{{
      {"Connect", "connect", "Choose the bench and watch its live reading", makeConnectStep},
      {"Capture", "capture", "Plan the sweep and record it", makeCaptureStep},
      {"Review", "review", "Look at the recorded data and switch off bad points", makeReviewStep},
      {"Fit", "fit", "The correction curve and the chosen models over it", makeFitStep},
      {"Compare", "compare", "What each way of storing the correction costs and leaves", makeCompareStep},
      {"Verify", "verify", "A fresh sweep through the chosen model, against the limit", makeVerifyStep},
      {"Export", "export", "Tables, plots and the report", makeExportStep},
  }};
  return steps;
}

int stepIndex(const QString& title) {
  const auto& steps = stepCatalogue();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (title.compare(QLatin1String(steps[i].title), Qt::CaseInsensitive) == 0) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

} // namespace straightedge::gui
