// Step Fit of a field calibration: choices and blocks at the left, figures of every block, tables of orders and blocks.
#pragma once

#include "app/gui/field_steps/field_fit_presenter.h"
#include "app/gui/field_steps/field_step_pages.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QTabWidget;
class QToolButton;

namespace straightedge::gui {

class FieldFigureChooser;
class ResultTable;
class ValueLabel;

class FieldFitStep : public StepPage {
  Q_OBJECT
public:
  explicit FieldFitStep(FieldStepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeSide();
  QWidget* makeChoices(QWidget* parent);
  QWidget* makeBlocks(QWidget* parent);
  QWidget* makeTables();
  void refresh(); ///< while shown at once, otherwise when entered
  void showChoices();
  void showNumbers();

  FieldFitPresenter m_presenter;
  bool m_shown = false;
  bool m_stale = true;
  NoticeList* m_notices = nullptr;
  QComboBox* m_order = nullptr;
  QComboBox* m_method = nullptr;
  QDoubleSpinBox* m_fullScale = nullptr;
  QDoubleSpinBox* m_reference = nullptr;
  QLabel* m_fitText = nullptr;
  QList<QCheckBox*> m_blocks;       ///< in the chain's order
  QList<QToolButton*> m_blockHelps; ///< beside them
  QHBoxLayout* m_numbers = nullptr;
  QList<ValueLabel*> m_numberLabels;
  FieldFigureChooser* m_figures = nullptr;
  QTabWidget* m_tabs = nullptr;
  ResultTable* m_states = nullptr;
  ResultTable* m_orders = nullptr;
  ResultTable* m_blockRows = nullptr;
  ResultTable* m_coefficients = nullptr;
  ResultTable* m_uncertainty = nullptr;
};

} // namespace straightedge::gui
