#include "app/gui/steps/connect_step.h"

#include "app/gui/bench/bench_console.h"
#include "app/gui/bench/bench_panel.h"
#include "app/gui/steps/live_dial.h"
#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/simulated_bench_form.h"
#include "app/gui/steps/value_label.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>
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
  columns->addWidget(makeBenchColumn());
  auto* live = new QSplitter(Qt::Vertical, this);
  live->addWidget(makeLiveBox());
  live->addWidget(&m_panel->console());
  live->setChildrenCollapsible(false);
  live->setStretchFactor(0, 3);
  live->setStretchFactor(1, 2);
  columns->addWidget(live, 1);

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
  connect(&m_realBench.opener(), &BenchOpener::opened, this, [this](const auto& bench) {
    if (!m_presenter.useInstruments(bench)) {
      m_realBench.close();
    }
  });
  connect(&m_realBench.opener(), &BenchOpener::closed, &m_presenter, &ConnectPresenter::letGoOfInstruments);
  connect(&m_realBench.opener(), &BenchOpener::angleRead, &m_presenter, &ConnectPresenter::takeReading);
  connect(&m_presenter, &ConnectPresenter::connectionChanged, this, [this] {
    m_realBench.setCapturing(!m_presenter.mayChange());
    if (const auto& bench = m_realBench.opener().bench(); bench && !m_presenter.usesInstruments(bench.get())) {
      m_realBench.close(); // another bench was connected in its place
    }
  });
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

QWidget* ConnectStep::makeBenchColumn() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);

  m_tabs = new QTabWidget(content);
  m_tabs->setObjectName(QStringLiteral("benchTabs"));
  m_tabs->addTab(makeSimulatedTab(), tr("Si&mulated bench"));
  auto* instruments = new QWidget;
  auto* tab = new QVBoxLayout(instruments);
  m_panel = new BenchPanel(m_realBench, instruments);
  tab->addWidget(m_panel);
  tab->addStretch(1);
  m_tabs->addTab(instruments, tr("I&nstruments"));
  m_tabs->setCurrentIndex(m_realBench.benchName().isEmpty() ? 0 : 1); // what was used last
  column->addWidget(m_tabs);
  m_next = new QPushButton(tr("Go on to Capture"), content);
  m_next->setObjectName(QStringLiteral("goToCapture"));
  auto* onward = new QHBoxLayout;
  onward->addStretch(1);
  onward->addWidget(m_next);
  column->addLayout(onward);
  column->addWidget(makeInstrumentsBox());
  column->addWidget(makeTraceabilityBox());
  column->addStretch(1);
  connect(m_next, &QPushButton::clicked, this, [this] { emit goToStep(tr("Capture")); });

  auto* scroll = new QScrollArea(this); // a small window must not cut the form
  scroll->setObjectName(QStringLiteral("connectColumn"));
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(content->fontMetrics().averageCharWidth() * 66);
  return scroll;
}

QWidget* ConnectStep::makeSimulatedTab() {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  auto* about = new QLabel(tr("A magnet, a sensor and an encoder in software, with a truth that is known. For learning "
                              "the method and for trying out plans."),
                           box);
  about->setWordWrap(true);
  layout->addWidget(about);
  m_form = new SimulatedBenchForm(box);
  layout->addWidget(m_form);
  m_status = new QLabel(box);
  m_status->setObjectName(QStringLiteral("benchStatus"));
  m_status->setWordWrap(true);
  layout->addWidget(m_status);
  auto* buttons = new QHBoxLayout;
  m_connect = new QPushButton(box);
  m_connect->setObjectName(QStringLiteral("connectBench"));
  buttons->addWidget(m_connect);
  buttons->addStretch(1);
  layout->addLayout(buttons);
  layout->addStretch(1);
  connect(m_connect, &QPushButton::clicked, this, [this] {
    if (m_presenter.simulated()) {
      m_presenter.disconnectBench();
    } else {
      m_presenter.connectSimulated(m_form->settings());
    }
  });
  return box;
}

QWidget* ConnectStep::makeInstrumentsBox() {
  auto* box = new QGroupBox(tr("Connected"), this);
  auto* layout = new QVBoxLayout(box);
  m_instruments = new QLabel(box);
  m_instruments->setObjectName(QStringLiteral("instruments"));
  m_instruments->setTextFormat(Qt::RichText);
  m_instruments->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_instruments->setWordWrap(true);
  layout->addWidget(m_instruments);
  return box;
}

QWidget* ConnectStep::makeTraceabilityBox() {
  auto* box = new QGroupBox(tr("Traceability"), this);
  auto* layout = new QVBoxLayout(box);
  m_traceability = new QLabel(box);
  m_traceability->setObjectName(QStringLiteral("traceabilitySummary"));
  m_traceability->setTextFormat(Qt::PlainText);
  m_traceability->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_traceability->setWordWrap(true);
  layout->addWidget(m_traceability);
  auto* buttons = new QHBoxLayout;
  auto* details = new QPushButton(tr("Edit details…"), box);
  details->setObjectName(QStringLiteral("editDetails"));
  details->setToolTip(tr("Device, reference instrument, operator and ambient temperature; they go into every result"));
  m_takeOver = new QPushButton(tr("Use connected instruments"), box);
  m_takeOver->setObjectName(QStringLiteral("takeOverInstruments"));
  m_takeOver->setToolTip(tr("Writes model and serial of the connected sensor and encoder into the details"));
  buttons->addWidget(details);
  buttons->addWidget(m_takeOver);
  buttons->addStretch(1);
  layout->addLayout(buttons);
  connect(details, &QPushButton::clicked, this, &StepPage::detailsRequested);
  connect(m_takeOver, &QPushButton::clicked, &m_presenter, &ConnectPresenter::takeOverInstruments);
  return box;
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
  const bool connected = m_presenter.connected();
  const bool simulated = m_presenter.simulated();
  m_form->setEnabled(!simulated);
  m_connect->setText(simulated ? tr("&Disconnect") : tr("&Connect"));
  m_connect->setEnabled(m_presenter.mayChange());
  m_connect->setDefault(!connected);
  m_next->setVisible(connected);
  m_status->setText(m_presenter.statusText());
  QStringList rows;
  for (const ConnectPresenter::Instrument& instrument : m_presenter.instruments()) {
    rows << QStringLiteral("<b>%1</b><br>%2, %3")
                .arg(instrument.role.toHtmlEscaped(), instrument.model.toHtmlEscaped(),
                     instrument.serial.isEmpty() ? tr("no serial number")
                                                 : tr("serial %1").arg(instrument.serial.toHtmlEscaped()));
  }
  m_instruments->setText(rows.isEmpty() ? tr("None. They are listed here with model and serial number once the bench "
                                             "is connected.")
                                        : rows.join(QStringLiteral("<br>")));
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
  m_traceability->setText(m_presenter.traceabilitySummary());
  m_takeOver->setVisible(m_presenter.canTakeOverInstruments());
}

StepPage* makeConnectStep(StepContext context, QWidget* parent) { return new ConnectStep(context, parent); }

} // namespace straightedge::gui
