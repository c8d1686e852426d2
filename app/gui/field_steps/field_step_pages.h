// The pages of a field calibration's steps: what they are made with, and who makes them.
#pragma once

#include "app/gui/steps/step_page.h"

namespace straightedge::gui {

class FieldBenchLink;
class FieldDocument;

/// What every step may use. All outlive the pages.
struct FieldStepContext {
  FieldDocument& document;
  FieldBenchLink& bench;
  JobRunner& jobs;
};

StepPage* makeFieldConnectStep(FieldStepContext context, QWidget* parent);
StepPage* makeFieldCaptureStep(FieldStepContext context, QWidget* parent);
StepPage* makeFieldReviewStep(FieldStepContext context, QWidget* parent);
StepPage* makeFieldFitStep(FieldStepContext context, QWidget* parent);
StepPage* makeFieldCompareStep(FieldStepContext context, QWidget* parent);
StepPage* makeFieldVerifyStep(FieldStepContext context, QWidget* parent);
StepPage* makeFieldExportStep(FieldStepContext context, QWidget* parent);

} // namespace straightedge::gui
