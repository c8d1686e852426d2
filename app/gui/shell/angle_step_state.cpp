#include "app/gui/shell/angle_step_state.h"

#include "app/gui/document/angle_document.h"
#include "app/gui/document/bench_link.h"
#include "core/base/number_text.h"

#include <QCoreApplication>

namespace straightedge::gui {

namespace {

QString sayState(const char* text) { return QCoreApplication::translate("StepState", text); }

QString degreesForPeople(double value) {
  return QString::fromStdString(formatForPeople(value, 3)) + QStringLiteral("°");
}

StepState connectState(const BenchLink& bench) {
  if (bench.isConnected()) {
    return {StepProgress::Done, sayState("Connected: %1.").arg(bench.benchName())};
  }
  return {StepProgress::Available, {}};
}

StepState captureState(const AngleDocument& document, const BenchLink& bench) {
  if (bench.isCapturing()) {
    return {StepProgress::Available, sayState("Capturing.")};
  }
  if (const auto points = document.sweep().size(); points > 0) {
    return {StepProgress::Done, sayState("%1 points recorded.").arg(points)};
  }
  if (!bench.isConnected()) {
    return {StepProgress::Missing, sayState("Connect a bench first, or import a sweep from a CSV file.")};
  }
  return {StepProgress::Available, {}};
}

StepState refusedOr(const AngleDocument& document, const StepState& otherwise) {
  if (document.sweep().size() == 0) {
    return {StepProgress::Missing, sayState("There is no sweep yet: capture one, or import a CSV file.")};
  }
  if (document.runError()) {
    return {StepProgress::Failed, QString::fromStdString(document.runError()->message())};
  }
  return otherwise;
}

StepState verifyState(const AngleDocument& document) {
  if (const auto& report = document.verification()) {
    const QString text = (report->met ? sayState("Passed: largest error %1, limit %2.")
                                      : sayState("Failed: largest error %1, limit %2."))
                             .arg(degreesForPeople(report->maxErrorDeg), degreesForPeople(report->limitDeg));
    return {report->met ? StepProgress::Done : StepProgress::Failed, text};
  }
  if (const auto& error = document.verificationError()) {
    return {StepProgress::Failed, QString::fromStdString(error->message())};
  }
  return {StepProgress::Available, {}};
}

} // namespace

StepState angleStepState(std::size_t step, const AngleDocument& document, const BenchLink& bench) {
  const StepProgress whenFitted = document.run() ? StepProgress::Done : StepProgress::Available;
  switch (step) {
  case 0:
    return connectState(bench);
  case 1:
    return captureState(document, bench);
  case 2:
  case 3:
    return refusedOr(document, {whenFitted, {}});
  case 4:
    return refusedOr(document, {document.comparison() ? StepProgress::Done : StepProgress::Available, {}});
  case 5:
    return refusedOr(document, verifyState(document));
  default:
    return refusedOr(document, {StepProgress::Available, {}});
  }
}

} // namespace straightedge::gui
