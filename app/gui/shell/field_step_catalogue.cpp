#include "app/gui/shell/field_step_catalogue.h"

#include <QtGlobal>

#include <array>

namespace straightedge::gui {

namespace {

constexpr std::array<StepEntry, 7> fieldSteps{{
    {"Connect", "field", "Choose the bench: teslameter, reference, chamber", QT_TR_NOOP("&Connect")},
    {"Capture", "field", "Record the campaign stage by stage", QT_TR_NOOP("C&apture")},
    {"Review", "field-review", "Look at the recorded rows and switch off bad plateaus", QT_TR_NOOP("&Review")},
    {"Fit", "field-fit", "Every block of the correction and what it leaves", QT_TR_NOOP("&Fit")},
    {"Compare", "field-compare", "Orders of the blocks against the error they leave", QT_TR_NOOP("Co&mpare")},
    {"Verify", "field-verify", "Error before and after each block, against the limit", QT_TR_NOOP("&Verify")},
    {"Export", "field-export", "Coefficients, tables, plots and the report", QT_TR_NOOP("&Export")},
}};

using MakeFieldStep = StepPage* (*)(FieldStepContext, QWidget*);
constexpr std::array<MakeFieldStep, fieldSteps.size()> fieldStepMakers{
    makeFieldConnectStep, makeFieldCaptureStep, makeFieldReviewStep, makeFieldFitStep,
    makeFieldCompareStep, makeFieldVerifyStep,  makeFieldExportStep};

} // namespace

std::span<const StepEntry> fieldStepCatalogue() { return fieldSteps; }

StepPage* makeFieldStep(std::size_t step, FieldStepContext context, QWidget* parent) {
  return fieldStepMakers.at(step)(context, parent);
}

} // namespace straightedge::gui
