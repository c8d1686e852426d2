#include "app/gui/steps/connect_step.h"

#include "app/gui/bench/bench_console.h"
#include "app/gui/bench/bench_panel.h"
#include "app/gui/steps/connect_column.h"
#include "app/gui/steps/connect_wiring.h"
#include "app/gui/steps/live_dial.h"
#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/simulated_bench_form.h"
#include "app/gui/steps/value_label.h"

#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

namespace straightedge::gui {

ConnectStep::ConnectStep(StepContext context, QWidget* parent)
    : StepPage(parent), m_presenter(context.document, context.bench),
      m_realBench(context.jobs, {.kind = QStringLiteral("angle"), .roles = angleRoleSlots()}) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  page->addLayout(columns, 1);
  columns->addWidget(makeColumn());
  columns->addWidget(withConsole(makeLiveBox(), m_panel->console(), this), 1);

  m_form->setSettings(context.bench.simulatedSettings());
  connect(&m_presenter, &ConnectPresenter::connectionChanged, this, &ConnectStep::showConnection);
  connect(&m_presenter, &ConnectPresenter::readingChanged, this, &ConnectStep::showReading);
  connect(&m_presenter, &ConnectPresenter::problemChanged, this, &ConnectStep::showProblem);
  connect(&m_presenter, &ConnectPresenter::traceabilityChanged, this, &ConnectStep::showTraceability);
  connectInstruments();
  showConnection();
  showReading();
  showTraceability();
}

void ConnectStep::connectInstruments() {
  wireInstruments(*this, m_presenter, m_realBench);
  connect(&m_realBench.opener(), &BenchOpener::angleRead, &m_presenter, &ConnectPresenter::takeReading);
  connect(&m_realBench.opener(), &BenchOpener::angleLost, &m_presenter, &ConnectPresenter::loseReading);
}

QString ConnectStep::title() const { return tr("Connect"); }

QString ConnectStep::helpPage() const { return QStringLiteral("connect"); }

void ConnectStep::entered() {
  m_presenter.setShown(true);
  m_realBench.setShown(true);
}

void ConnectStep::left() {
  m_presenter.setShown(false);
  m_realBench.setShown(false);
}

QWidget* ConnectStep::makeColumn() {
  m_column = new ConnectColumn(this);
  m_form = new SimulatedBenchForm(m_column);
  m_panel = fillConnectColumn(
      *m_column,
      tr("A magnet, a sensor and an encoder in software, with a truth that is known. For learning the "
         "method and for trying out plans."),
      *m_form, *this, m_presenter, m_realBench);
  return m_column;
}

QWidget* ConnectStep::makeLiveBox() {
  auto* box = new QGroupBox(tr("Live reading"), this);
  auto* layout = new QVBoxLayout(box);
  auto* top = new QHBoxLayout;
  top->setSpacing(24);
  m_dial = new LiveDial(box);
  m_dial->setFixedSize(200, 200);
  top->addWidget(m_dial);

  auto* numbers = new QGridLayout;
  numbers->setHorizontalSpacing(28);
  numbers->setVerticalSpacing(2);
  const auto number = [&](int row, int column, const QString& caption, const QString& name, ValueLabel::Size size,
                          QPalette::ColorRole role) {
    auto* value = new ValueLabel(caption, size, role, box);
    value->setObjectName(name);
    numbers->addWidget(value, row, column, Qt::AlignLeft | Qt::AlignTop);
    return value;
  };
  m_encoder =
      number(0, 0, tr("Encoder"), QStringLiteral("encoderReading"), ValueLabel::Size::Large, QPalette::WindowText);
  m_sensor = number(0, 1, tr("Sensor"), QStringLiteral("sensorReading"), ValueLabel::Size::Large, QPalette::Link);
  m_difference = number(1, 0, tr("Sensor − encoder"), QStringLiteral("difference"), ValueLabel::Size::Medium,
                        QPalette::WindowText);
  m_noise = number(1, 1, tr("Noise at standstill (1 σ)"), QStringLiteral("noise"), ValueLabel::Size::Medium,
                   QPalette::WindowText);
  numbers->setColumnStretch(2, 1);
  numbers->setRowStretch(2, 1);

  auto* move = new QHBoxLayout;
  move->setSpacing(8);
  m_shaft = new QDoubleSpinBox(box);
  m_shaft->setObjectName(QStringLiteral("shaftTarget"));
  m_shaft->setRange(0.0, 360.0);
  m_shaft->setWrapping(true);
  m_shaft->setDecimals(2);
  m_shaft->setSingleStep(15.0);
  m_shaft->setSuffix(QStringLiteral("°"));
  m_move = new QPushButton(tr("Turn"), box);
  m_move->setObjectName(QStringLiteral("turnShaft"));
  auto* caption = new QLabel(tr("Turn the &shaft to"), box);
  caption->setBuddy(m_shaft);
  move->addWidget(caption);
  move->addWidget(m_shaft);
  move->addWidget(m_move);
  move->addStretch(1);
  numbers->addLayout(move, 3, 0, 1, 3);
  top->addLayout(numbers, 1);
  layout->addLayout(top);

  m_trace = new PlotView(box);
  m_trace->setObjectName(QStringLiteral("liveTrace"));
  m_trace->setMinimumHeight(180);
  layout->addWidget(m_trace, 1);
  connect(m_move, &QPushButton::clicked, this, [this] { m_presenter.moveShaftTo(m_shaft->value()); });
  return box;
}

void ConnectStep::showConnection() {
  m_column->showConnection({.connected = m_presenter.connected(),
                            .form = m_presenter.simulated() ? m_form : nullptr,
                            .mayChange = m_presenter.mayChange(),
                            .status = m_presenter.statusText(),
                            .instruments = m_presenter.instruments()});
  showTraceability();
  showReading();
}

void ConnectStep::showReading() {
  m_encoder->setText(m_presenter.encoderText());
  m_sensor->setText(m_presenter.sensorText());
  m_difference->setText(m_presenter.differenceText());
  m_noise->setText(m_presenter.noiseText());
  m_shaft->setEnabled(m_presenter.canMoveShaft());
  m_move->setEnabled(m_presenter.canMoveShaft());
  if (const auto reading = m_presenter.reading()) {
    m_dial->setReading(reading->encoderDeg, reading->sensorDeg);
  } else {
    m_dial->clearReading();
  }
  m_trace->setSpec(m_presenter.tracePlot());
}

void ConnectStep::showProblem() {
  m_notices->setNotices(m_presenter.problem().isEmpty()
                            ? QList<Notice>{}
                            : QList<Notice>{{Notice::Level::Problem, m_presenter.problem()}});
}

void ConnectStep::showTraceability() {
  m_column->showTraceability(m_presenter.traceabilitySummary(), m_presenter.canTakeOverInstruments());
}

StepPage* makeConnectStep(StepContext context, QWidget* parent) { return new ConnectStep(context, parent); }

} // namespace straightedge::gui
