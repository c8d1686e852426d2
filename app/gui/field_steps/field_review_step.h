// Step Review of a field calibration: stages with their plateaus and sweeps, raw readings, what counts.
#pragma once

#include "app/gui/field_steps/field_review_presenter.h"
#include "app/gui/field_steps/field_step_pages.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace straightedge::gui {

class SceneView;
class ValueLabel;

class FieldReviewStep : public StepPage {
  Q_OBJECT
public:
  explicit FieldReviewStep(FieldStepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QWidget* makePlot();
  QWidget* makeStages();
  QWidget* makeActions();
  void refresh();
  void showFacts();
  void showStages();
  void showPlot();
  void showActions();
  void selectRow(std::size_t row);
  void switchSelected(bool on);
  std::pair<std::size_t, std::optional<std::size_t>> placeOf(QTreeWidgetItem* item) const; ///< stage; run or none
  std::vector<std::size_t> selectedRows() const;
  QString selectedTitle() const;
  void copyTable();

  FieldReviewPresenter m_presenter;
  bool m_shown = false;
  bool m_stale = true;
  bool m_filling = false;
  NoticeList* m_notices = nullptr;
  QWidget* m_content = nullptr;
  QWidget* m_empty = nullptr;
  QLabel* m_emptyText = nullptr;
  QHBoxLayout* m_facts = nullptr;
  QList<ValueLabel*> m_factLabels;
  PlotView* m_plot = nullptr;
  SceneView* m_orientations = nullptr;
  QTreeWidget* m_stages = nullptr;
  QPushButton* m_off = nullptr;
  QPushButton* m_on = nullptr;
  QPushButton* m_allOn = nullptr;
};

} // namespace straightedge::gui
