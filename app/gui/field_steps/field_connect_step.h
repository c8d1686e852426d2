// Step Connect of a field calibration: choose a bench, see its instruments and what they read right now.
#pragma once

#include "app/gui/bench/bench_presenter.h"
#include "app/gui/field_steps/field_connect_presenter.h"
#include "app/gui/field_steps/field_step_pages.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace straightedge::gui {

class BenchPanel;
class ConnectColumn;
class NoticeList;
class SimulatedFieldForm;
class ValueLabel;

class FieldConnectStep : public StepPage {
  Q_OBJECT
public:
  explicit FieldConnectStep(FieldStepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeColumn();
  void connectInstruments();
  void takeRoles();
  QWidget* makeLiveBox();
  QWidget* makeSettingRow(QWidget* parent);
  void showConnection();
  void showReading();
  void showProblem();
  void showTraceability();

  FieldConnectPresenter m_presenter;
  BenchPresenter m_realBench;
  BenchPanel* m_panel = nullptr;
  NoticeList* m_notices = nullptr;
  ConnectColumn* m_column = nullptr;
  SimulatedFieldForm* m_form = nullptr;
  std::array<ValueLabel*, 3> m_axes = {};
  std::array<QLabel*, 3> m_noise = {};
  QList<ValueLabel*> m_values;
  QWidget* m_settings = nullptr; ///< magnet and carrier
  QComboBox* m_placing = nullptr;
  QPushButton* m_place = nullptr;
  QDoubleSpinBox* m_field = nullptr;
  QPushButton* m_setField = nullptr;
  PlotView* m_trace = nullptr;
};

} // namespace straightedge::gui
