// Step Capture of a field calibration: the stages of the campaign, each guided, and live plots.
#pragma once

#include "app/gui/field_steps/field_capture_presenter.h"
#include "app/gui/field_steps/field_step_pages.h"

class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace straightedge::gui {

class CaptureButtons;
class FieldPlanForm;
class NoticeList;
class StageList;

class FieldCaptureStep : public StepPage {
  Q_OBJECT
public:
  explicit FieldCaptureStep(FieldStepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  bool tellsBenchFaults() const override { return true; }
  void entered() override;
  void left() override;

private:
  QWidget* makeGuide();
  QWidget* makePlanBox();
  QWidget* makeWork();
  void connectPresenter();
  void connectStages();
  void showPhase();
  void showPlan();
  void showStages();
  void showRights();
  void showNotices();
  void showGuide();
  void showFrame(); ///< once per frame while capturing; what may lag is shown less often
  void showPlots();
  void showMainPlot();
  void showTimePlot();
  bool waits() const; ///< for an instrument that was unplugged
  void leaveOut(const QList<int>& stages, bool out);

  FieldCapturePresenter m_presenter;
  NoticeList* m_notices = nullptr;
  QGroupBox* m_guide = nullptr;
  QLabel* m_heading = nullptr;
  QLabel* m_instruction = nullptr;
  QPushButton* m_confirm = nullptr;
  QLabel* m_action = nullptr;
  QLabel* m_guidance = nullptr;
  QProgressBar* m_progress = nullptr;
  QLabel* m_progressText = nullptr;
  QLabel* m_rowsText = nullptr;
  CaptureButtons* m_buttons = nullptr;
  FieldPlanForm* m_plan = nullptr;
  QLabel* m_planSummary = nullptr;
  StageList* m_stages = nullptr;
  PlotView* m_mainPlot = nullptr;
  PlotView* m_timePlot = nullptr;
  bool m_shown = false;
  int m_frame = 0;
  int m_followed = -1;     ///< stage that the list was put on last
  qint64 m_mainDrawn = -1; ///< revision of the trace that is drawn
  qint64 m_timeDrawn = -1;
};

} // namespace straightedge::gui
