#include "app/gui/shell/field_step_state.h"

#include "app/gui/document/field_bench_link.h"
#include "app/gui/document/field_document.h"
#include "core/base/number_text.h"

#include <QCoreApplication>

namespace straightedge::gui {

namespace {

QString sayFieldState(const char* text) { return QCoreApplication::translate("FieldStepState", text); }

QString statePercent(double value) { return QString::fromStdString(formatForPeople(value, 3)) + QStringLiteral(" %"); }

StepState fieldConnectState(const FieldBenchLink& bench) {
  if (bench.isConnected()) {
    return {StepProgress::Done, sayFieldState("Connected: %1.").arg(bench.benchName())};
  }
  return {StepProgress::Available, {}};
}

StepState fieldCaptureState(const FieldDocument& document, const FieldBenchLink& bench) {
  if (bench.isCapturing()) {
    return {StepProgress::Available, sayFieldState("Capturing.")};
  }
  const auto rows = document.campaign().rows.size();
  if (rows > 0 && bench.interruptedPlan(session::SweepRole::Calibration)) {
    return {StepProgress::Available, sayFieldState("%1 rows recorded; stages are still to be measured.").arg(rows)};
  }
  if (rows > 0) {
    return {StepProgress::Done, sayFieldState("%1 rows recorded.").arg(rows)};
  }
  if (!bench.isConnected()) {
    return {StepProgress::Missing, sayFieldState("Connect a bench first, or import a campaign from a CSV file.")};
  }
  return {StepProgress::Available, {}};
}

StepState fieldVerifyState(const FieldDocument& document) {
  if (const auto& report = document.verification()) {
    const QString text = (report->met ? sayFieldState("Passed: largest error %1, limit %2.")
                                      : sayFieldState("Failed: largest error %1, limit %2."))
                             .arg(statePercent(report->peakPercent), statePercent(report->limitPercent));
    return {report->met ? StepProgress::Done : StepProgress::Failed, text};
  }
  if (const auto& error = document.verificationError()) {
    return {StepProgress::Failed, QString::fromStdString(error->message())};
  }
  return {StepProgress::Available, {}};
}

StepState refusedCampaignOr(const FieldDocument& document, const StepState& otherwise) {
  if (document.campaign().rows.empty()) {
    return {StepProgress::Missing, sayFieldState("There is no campaign yet: capture one, or import a CSV file.")};
  }
  if (document.runError()) {
    return {StepProgress::Failed, QString::fromStdString(document.runError()->message())};
  }
  return otherwise;
}

} // namespace

StepState fieldStepState(std::size_t step, const FieldDocument& document, const FieldBenchLink& bench) {
  const StepProgress whenFitted = document.run() ? StepProgress::Done : StepProgress::Available;
  switch (step) {
  case 0:
    return fieldConnectState(bench);
  case 1:
    return fieldCaptureState(document, bench);
  case 2:
  case 3:
  case 4:
    return refusedCampaignOr(document, {whenFitted, {}});
  case 5:
    return refusedCampaignOr(document, fieldVerifyState(document));
  default:
    return refusedCampaignOr(document, {StepProgress::Available, {}});
  }
}

} // namespace straightedge::gui
