// Step Verify of a field calibration: pass or fail against a limit in percent, error before and after each block.
#pragma once

#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/field_steps/field_verify_presenter.h"
#include "app/gui/field_steps/fresh_capture.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace straightedge::gui {

class FieldFigureChooser;
class NoticeList;
class ResultTable;
class VerdictBanner;

class FieldVerifyStep : public StepPage {
  Q_OBJECT
public:
  explicit FieldVerifyStep(FieldStepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeSide();
  QWidget* makeResult();
  void refresh();
  void chooseCsv();

  FieldVerifyPresenter m_presenter;
  FreshCapture m_capture;
  bool m_shown = false;
  bool m_stale = true;
  NoticeList* m_notices = nullptr;
  QDoubleSpinBox* m_limit = nullptr;
  QComboBox* m_of = nullptr;
  QLabel* m_campaign = nullptr;
  QPushButton* m_captureFresh = nullptr;
  QLabel* m_cannotCapture = nullptr;
  QPushButton* m_forget = nullptr;
  VerdictBanner* m_banner = nullptr;
  FieldFigureChooser* m_figures = nullptr;
  ResultTable* m_table = nullptr;
};

} // namespace straightedge::gui
