// Step Connect: choose a bench, see its instruments and what they read right now.
#pragma once

#include "app/gui/bench/bench_presenter.h"
#include "app/gui/steps/connect_presenter.h"
#include "app/gui/steps/step_page.h"

class QLabel;
class QPushButton;
class QDoubleSpinBox;
class QTabWidget;

namespace straightedge::gui {

class BenchPanel;
class LiveDial;
class NoticeList;
class SimulatedBenchForm;
class ValueLabel;

class ConnectStep : public StepPage {
  Q_OBJECT
public:
  explicit ConnectStep(StepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeBenchColumn();
  QWidget* makeSimulatedTab();
  void connectInstruments();
  QWidget* makeLiveBox();
  QWidget* makeInstrumentsBox();
  QWidget* makeTraceabilityBox();
  void showConnection();
  void showReading();
  void showProblem();
  void showTraceability();

  ConnectPresenter m_presenter;
  BenchPresenter m_realBench;
  QTabWidget* m_tabs = nullptr;
  BenchPanel* m_panel = nullptr;
  NoticeList* m_notices = nullptr;
  SimulatedBenchForm* m_form = nullptr;
  QPushButton* m_connect = nullptr;
  QPushButton* m_next = nullptr;
  QLabel* m_status = nullptr;
  LiveDial* m_dial = nullptr;
  ValueLabel* m_encoder = nullptr;
  ValueLabel* m_sensor = nullptr;
  ValueLabel* m_difference = nullptr;
  ValueLabel* m_noise = nullptr;
  QDoubleSpinBox* m_shaft = nullptr;
  QPushButton* m_move = nullptr;
  PlotView* m_trace = nullptr;
  QLabel* m_instruments = nullptr;
  QLabel* m_traceability = nullptr;
  QPushButton* m_takeOver = nullptr;
};

} // namespace straightedge::gui
