// Step Review: what was recorded, how good it is, and which points count.
#pragma once

#include "app/gui/steps/review_presenter.h"
#include "app/gui/steps/step_page.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTabBar;
class QTableView;

namespace straightedge::gui {

class NoticeList;
class ValueLabel;

class ReviewStep : public StepPage {
  Q_OBJECT
public:
  explicit ReviewStep(StepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QWidget* makePlots();
  QWidget* makeTable();
  QWidget* makeActions();
  void connectPlot();
  void showAnalysis();
  void showFacts();
  void showPlot();
  void showActions();
  ReviewPresenter::View view() const;
  std::vector<std::size_t> selectedRows() const;
  void selectRows(const std::vector<std::size_t>& rows);
  void copyTable();

  ReviewPresenter m_presenter;
  NoticeList* m_notices = nullptr;
  QWidget* m_content = nullptr;
  QWidget* m_empty = nullptr;
  QLabel* m_emptyText = nullptr;
  QGridLayout* m_facts = nullptr;
  std::vector<ValueLabel*> m_factLabels;
  QTabBar* m_views = nullptr;
  PlotView* m_plot = nullptr;
  QLabel* m_hint = nullptr;
  QTableView* m_table = nullptr;
  QPushButton* m_off = nullptr;
  QPushButton* m_on = nullptr;
  QPushButton* m_selectOutliers = nullptr;
  QPushButton* m_allOn = nullptr;
  QPushButton* m_copy = nullptr;
  QPushButton* m_next = nullptr;
  bool m_shown = false;
};

} // namespace straightedge::gui
