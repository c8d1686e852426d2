// Step Compare: what each way of storing the correction costs and leaves; target and budget lines; the recommendation.
#pragma once

#include "app/gui/steps/compare_presenter.h"
#include "app/gui/steps/step_page.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTableView;
class QTabWidget;

namespace straightedge::gui {

class ComparisonFilter;
class ComparisonTable;
class NoticeList;

class CompareStep : public StepPage {
  Q_OBJECT
public:
  explicit CompareStep(StepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeAnswers();
  QWidget* makeOptions();
  QWidget* makeTable();
  void showFigure();
  void showDemands();
  void copyTable();

  ComparePresenter m_presenter;
  bool m_shown = false;
  bool m_stale = true;
  NoticeList* m_notices = nullptr;
  QDoubleSpinBox* m_target = nullptr;
  QSpinBox* m_budget = nullptr;
  QLabel* m_targetAnswer = nullptr;
  QLabel* m_budgetAnswer = nullptr;
  QPushButton* m_takeTarget = nullptr;
  QPushButton* m_takeBudget = nullptr;
  QLabel* m_chosen = nullptr;
  QLabel* m_progress = nullptr;
  QTabWidget* m_tabs = nullptr;
  PlotView* m_plot = nullptr;
  QTableView* m_table = nullptr;
  ComparisonTable* m_rows = nullptr;
  ComparisonFilter* m_filter = nullptr;
};

} // namespace straightedge::gui
