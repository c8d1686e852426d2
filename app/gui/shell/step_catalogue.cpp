#include "app/gui/shell/step_catalogue.h"

#include "app/gui/shell/workspace.h"

#include <QtGlobal>

namespace straightedge::gui {

const std::array<StepEntry, stepCount>& stepCatalogue() {
  static const std::array<StepEntry, stepCount> steps{{
      {"Connect", "connect", "Choose the bench and watch its live reading", QT_TR_NOOP("&Connect")},
      {"Capture", "capture", "Plan the sweep and record it", QT_TR_NOOP("C&apture")},
      {"Review", "review", "Look at the recorded data and switch off bad points", QT_TR_NOOP("&Review")},
      {"Fit", "fit", "The correction curve and the chosen models over it", QT_TR_NOOP("&Fit")},
      {"Compare", "compare", "What each way of storing the correction costs and leaves", QT_TR_NOOP("Co&mpare")},
      {"Verify", "verify", "A fresh sweep through the chosen model, against the limit", QT_TR_NOOP("&Verify")},
      {"Export", "export", "Tables, plots and the report", QT_TR_NOOP("&Export")},
  }};
  return steps;
}

StepPage* makeAngleStep(std::size_t step, StepContext context, QWidget* parent) {
  using Make = StepPage* (*)(StepContext, QWidget*);
  static constexpr std::array<Make, stepCount> makers{makeConnectStep, makeCaptureStep, makeReviewStep, makeFitStep,
                                                      makeCompareStep, makeVerifyStep,  makeExportStep};
  return makers.at(step)(context, parent);
}

int stepIndex(const QString& title) { return stepIndex(stepCatalogue(), title); }

} // namespace straightedge::gui
