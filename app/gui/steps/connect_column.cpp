#include "app/gui/steps/connect_column.h"

#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace straightedge::gui {

ConnectColumn::ConnectColumn(QWidget* parent) : QScrollArea(parent) {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);
  column->addWidget(makeBenchBox());
  column->addWidget(makeInstrumentsBox());
  column->addWidget(makeTraceabilityBox());
  column->addStretch(1);
  setWidget(content); // scrolls: a small window must not cut the form
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFixedWidth(content->fontMetrics().averageCharWidth() * 66);
}

QWidget* ConnectColumn::makeBenchBox() {
  m_box = new QGroupBox(this);
  auto* layout = new QVBoxLayout(m_box);
  m_benches = new QTabWidget(m_box);
  m_benches->setObjectName(QStringLiteral("benches"));
  m_benches->setDocumentMode(true);
  m_benches->setTabBarAutoHide(true);
  layout->addWidget(m_benches);
  m_status = new QLabel(m_box);
  m_status->setObjectName(QStringLiteral("benchStatus"));
  m_status->setWordWrap(true);
  layout->addWidget(m_status);
  auto* buttons = new QHBoxLayout;
  m_connect = new QPushButton(m_box);
  m_connect->setObjectName(QStringLiteral("connectBench"));
  m_next = new QPushButton(tr("Go on to Capture"), m_box);
  m_next->setObjectName(QStringLiteral("goToCapture"));
  buttons->addWidget(m_connect);
  buttons->addStretch(1);
  buttons->addWidget(m_next);
  layout->addLayout(buttons);
  connect(m_connect, &QPushButton::clicked, this, [this] {
    if (isChosenConnected()) {
      emit disconnectWanted();
    } else if (const int chosen = m_benches->currentIndex(); chosen >= 0) {
      emit connectWanted(m_forms[chosen].form);
    }
  });
  connect(m_benches, &QTabWidget::currentChanged, this, &ConnectColumn::showButton);
  connect(m_next, &QPushButton::clicked, this, &ConnectColumn::nextWanted);
  return m_box;
}

QWidget* ConnectColumn::makeInstrumentsBox() {
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

QWidget* ConnectColumn::makeTraceabilityBox() {
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
  m_takeOver->setToolTip(
      tr("Writes model and serial of what is under calibration and of its reference into the details"));
  buttons->addWidget(details);
  buttons->addWidget(m_takeOver);
  buttons->addStretch(1);
  layout->addLayout(buttons);
  connect(details, &QPushButton::clicked, this, &ConnectColumn::detailsWanted);
  connect(m_takeOver, &QPushButton::clicked, this, &ConnectColumn::takeOverWanted);
  return box;
}

void ConnectColumn::addBench(const QString& title, const QString& about, QWidget* form, bool connects) {
  auto* page = new QWidget(m_benches);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  if (!about.isEmpty()) {
    auto* text = new QLabel(about, page);
    text->setWordWrap(true);
    layout->addWidget(text);
  }
  layout->addWidget(form);
  layout->addStretch(1);
  m_forms.append({form, connects}); // before the tab is there: it becomes the current one
  m_benches->addTab(page, title);
  m_box->setTitle(m_benches->count() == 1 ? title : tr("Bench"));
  const int needed = widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width();
  setFixedWidth(std::max(width(), needed));
}

void ConnectColumn::showConnection(const Connection& connection) {
  m_connected = connection.connected;
  m_mayChange = connection.mayChange;
  m_connectedForm = connection.form;
  for (const Bench& bench : m_forms) {
    bench.form->setEnabled(!bench.connects || !connection.connected || bench.form != connection.form);
  }
  showButton();
  m_next->setVisible(connection.connected);
  m_status->setText(connection.status);
  QStringList rows;
  for (const ConnectedInstrument& instrument : connection.instruments) {
    rows << QStringLiteral("<b>%1</b><br>%2, %3")
                .arg(instrument.role.toHtmlEscaped(), instrument.model.toHtmlEscaped(),
                     instrument.serial.isEmpty() ? tr("no serial number")
                                                 : tr("serial %1").arg(instrument.serial.toHtmlEscaped()));
  }
  m_instruments->setText(rows.isEmpty() ? tr("None. They are listed here with model and serial number once the bench "
                                             "is connected.")
                                        : rows.join(QStringLiteral("<br>")));
}

void ConnectColumn::showButton() {
  const int chosen = m_benches->currentIndex();
  m_connect->setText(isChosenConnected() ? tr("&Disconnect") : tr("&Connect"));
  m_connect->setEnabled(m_mayChange);
  m_connect->setDefault(!m_connected);
  m_connect->setVisible(chosen >= 0 && chosen < m_forms.size() && m_forms[chosen].connects);
  m_status->setVisible(m_connect->isVisibleTo(this) || m_connected);
}

bool ConnectColumn::isChosenConnected() const {
  const int chosen = m_benches->currentIndex();
  return m_connected && chosen >= 0 && chosen < m_forms.size() && m_forms[chosen].form == m_connectedForm;
}

void ConnectColumn::chooseBench(int index) { m_benches->setCurrentIndex(index); }

void ConnectColumn::showTraceability(const QString& lines, bool canTakeOver) {
  m_traceability->setText(lines);
  m_takeOver->setVisible(canTakeOver);
}

} // namespace straightedge::gui
