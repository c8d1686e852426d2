// Step Verify: a fresh sweep through the chosen model, pass or fail against the limit, before and after.
#pragma once

#include "app/gui/steps/step_page.h"
#include "app/gui/steps/verify_presenter.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace straightedge::gui {

class NoticeList;
class ResultTable;
class VerdictBanner;

class VerifyStep : public StepPage {
  Q_OBJECT
public:
  explicit VerifyStep(StepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  bool tellsBenchFaults() const override { return true; }
  void entered() override;
  void left() override;

private:
  QWidget* makeSide();
  QWidget* makeResult();
  void refresh();
  void showProgress();
  void chooseCsv();

  VerifyPresenter m_presenter;
  bool m_shown = false;
  bool m_stale = true;
  NoticeList* m_notices = nullptr;
  QComboBox* m_model = nullptr;
  QDoubleSpinBox* m_limit = nullptr;
  QSpinBox* m_points = nullptr;
  QPushButton* m_capture = nullptr;
  QLabel* m_captureProblem = nullptr;
  QProgressBar* m_progress = nullptr;
  QLabel* m_sweep = nullptr;
  VerdictBanner* m_banner = nullptr;
  PlotView* m_beforeAfter = nullptr;
  PlotView* m_corrected = nullptr;
  ResultTable* m_table = nullptr;
};

} // namespace straightedge::gui
