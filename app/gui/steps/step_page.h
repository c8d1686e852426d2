// A step of the guided calibration: one page, reachable from the step bar at any time.
#pragma once

#include "app/gui/plots/plot_view.h"

#include <QWidget>

namespace straightedge::gui {

class AngleDocument;
class BenchLink;
class JobRunner;

/// What every step may use. All outlive the pages.
struct StepContext {
  AngleDocument& document;
  BenchLink& bench;
  JobRunner& jobs;
};

class StepPage : public QWidget {
  Q_OBJECT
public:
  explicit StepPage(QWidget* parent = nullptr) : QWidget(parent) {}

  virtual QString title() const = 0;    ///< "Connect", "Capture", …
  virtual QString helpPage() const = 0; ///< file stem in resources/help, e.g. "connect"
  /// Empty when the step can do its work; otherwise what is missing and where to get it, as a sentence.
  virtual QString missing() const { return {}; }
  /// Says itself what failed on the bench, beside what can be done about it: the window need not say it again.
  virtual bool tellsBenchFaults() const { return false; }
  virtual void entered() {} ///< shown
  virtual void left() {}    ///< another step is shown

signals:
  void availabilityChanged();              ///< missing() may have changed
  void goToStep(const QString& title);     ///< a button or link leads on
  void detailsRequested();                 ///< open the dialog of traceability details
  void helpRequested(const QString& page); ///< a file stem in resources/help
};

StepPage* makeConnectStep(StepContext context, QWidget* parent);
StepPage* makeCaptureStep(StepContext context, QWidget* parent);
StepPage* makeReviewStep(StepContext context, QWidget* parent);
StepPage* makeFitStep(StepContext context, QWidget* parent);
StepPage* makeCompareStep(StepContext context, QWidget* parent);
StepPage* makeVerifyStep(StepContext context, QWidget* parent);
StepPage* makeExportStep(StepContext context, QWidget* parent);

/// Theme of plots that fits the widget's palette.
PlotTheme plotThemeOf(const QWidget& widget);

} // namespace straightedge::gui
