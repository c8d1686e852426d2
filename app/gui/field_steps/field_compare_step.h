// Step Compare of a field calibration: orders of the blocks against the error they leave, as plot and table.
#pragma once

#include "app/gui/field_steps/field_compare_presenter.h"
#include "app/gui/field_steps/field_step_pages.h"

class QLabel;
class QPushButton;
class QTabWidget;

namespace straightedge::gui {

class NoticeList;
class ResultTable;

class FieldCompareStep : public StepPage {
  Q_OBJECT
public:
  explicit FieldCompareStep(FieldStepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeBar();
  QWidget* makeTable();
  void refresh();
  void chooseRow(int row);

  FieldComparePresenter m_presenter;
  bool m_shown = false;
  bool m_stale = true;
  NoticeList* m_notices = nullptr;
  QLabel* m_chosen = nullptr;
  QLabel* m_progress = nullptr;
  QTabWidget* m_tabs = nullptr;
  PlotView* m_plot = nullptr;
  ResultTable* m_table = nullptr;
  QPushButton* m_use = nullptr;
};

} // namespace straightedge::gui
