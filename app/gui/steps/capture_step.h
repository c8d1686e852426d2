// Step Capture: the plan, its course with time left, and live plots.
#pragma once

#include "app/gui/steps/capture_presenter.h"
#include "app/gui/steps/step_page.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace straightedge::gui {

class CaptureButtons;
class CoverageRing;
class NoticeList;
class PlanForm;

class CaptureStep : public StepPage {
  Q_OBJECT
public:
  explicit CaptureStep(StepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  bool tellsBenchFaults() const override { return true; }
  void entered() override;
  void left() override;

private:
  QWidget* makePlanBox();
  QWidget* makeCourseBox();
  QWidget* makeRingBox();
  QWidget* makePointsBox();
  void connectPresenter();
  void showPhase();
  void showPlan();
  void showColumns(); ///< those that tell the plan's points apart
  void showNotices();
  void showProgress();
  void takeSamples(int first);
  void showFrame(); ///< once per frame while samples arrive; what may lag is shown less often
  void showAllPlots();
  bool waits() const; ///< for an instrument that was unplugged
  void selectPlanPoint(int planPoint);
  std::optional<int> selectedPoint() const;

  CapturePresenter m_presenter;
  NoticeList* m_notices = nullptr;
  PlanForm* m_plan = nullptr;
  QLabel* m_planSummary = nullptr;
  QLabel* m_guidance = nullptr;
  CaptureButtons* m_buttons = nullptr;
  QPushButton* m_redo = nullptr;
  QProgressBar* m_progress = nullptr;
  QLabel* m_progressText = nullptr;
  QLabel* m_samplesText = nullptr;
  CoverageRing* m_ring = nullptr;
  PlotView* m_errorPlot = nullptr;
  PlotView* m_sensorPlot = nullptr;
  QTableView* m_table = nullptr;
  bool m_shown = false;
  int m_frame = 0;
};

} // namespace straightedge::gui
