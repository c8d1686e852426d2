#include "app/gui/bench/bench_console.h"

#include "app/gui/bench/bench_colors.h"
#include "app/gui/bench/tinted_label.h"

#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

// As often as an eye follows lines that run by.
constexpr int consolePeriodMs = 100;

} // namespace

BenchConsole::BenchConsole(BenchPresenter& presenter, QWidget* parent)
    : QWidget(parent), m_presenter(presenter), m_model(presenter.opener().dialogue()) {
  setObjectName(QStringLiteral("benchConsole"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(makeTools());
  m_table = new QTableView(this);
  m_table->setObjectName(QStringLiteral("dialogue"));
  m_table->setModel(&m_model);
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setShowGrid(false);
  m_table->setWordWrap(false);
  m_table->setTabKeyNavigation(false);
  m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->horizontalHeader()->setHighlightSections(false);
  const int character = fontMetrics().averageCharWidth();
  m_table->setColumnWidth(DialogueModel::Time, character * 17);
  m_table->setColumnWidth(DialogueModel::Instrument, character * 24);
  m_table->setColumnWidth(DialogueModel::Direction, character * 14);
  m_table->setMinimumHeight(fontMetrics().height() * 6);
  layout->addWidget(m_table, 1);
  layout->addWidget(makeCommandLine());
  m_problem = new TintedLabel(faultColor, this);
  m_problem->setObjectName(QStringLiteral("consoleProblem"));
  m_problem->setTextOrHide({});
  layout->addWidget(m_problem);

  m_timer.setInterval(consolePeriodMs);
  connect(&m_timer, &QTimer::timeout, this, &BenchConsole::takeNew);
  connect(&presenter.opener(), &BenchOpener::stateChanged, this, [this] {
    m_model.rebuild();
    showInstruments();
    showState();
  });
  connect(&presenter.opener(), &BenchOpener::said, this, [this](int, const QString& problem) {
    m_problem->setTextOrHide(problem);
    takeNew();
  });
  showInstruments();
  showState();
}

QWidget* BenchConsole::makeTools() {
  auto* tools = new QWidget(this);
  auto* row = new QHBoxLayout(tools);
  row->setContentsMargins(0, 0, 0, 0);
  m_instrument = new QComboBox(tools);
  m_instrument->setObjectName(QStringLiteral("consoleInstrument"));
  m_instrument->setAccessibleName(tr("Instrument"));
  m_instrument->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_instrument->setMinimumContentsLength(14);
  m_filter = new QLineEdit(tools);
  m_filter->setObjectName(QStringLiteral("consoleFilter"));
  m_filter->setPlaceholderText(tr("Only what contains…"));
  m_filter->setClearButtonEnabled(true);
  m_pause = new QPushButton(tr("Hold still"), tools);
  m_pause->setObjectName(QStringLiteral("consolePause"));
  m_pause->setCheckable(true);
  m_pause->setToolTip(tr("New exchanges are kept and shown when this is switched off again"));
  m_copy = new QPushButton(tr("Copy"), tools);
  m_copy->setObjectName(QStringLiteral("consoleCopy"));
  m_save = new QPushButton(tr("Save…"), tools);
  m_save->setObjectName(QStringLiteral("consoleSave"));
  m_save->setToolTip(tr("As a file that can go with a bug report; choose one instrument first"));
  row->addWidget(m_instrument, 2);
  row->addWidget(m_filter, 1);
  for (QPushButton* each : {m_pause, m_copy, m_save}) {
    row->addWidget(each);
  }
  connect(m_instrument, &QComboBox::currentIndexChanged, this, [this] {
    const auto names = m_presenter.opener().dialogue().instruments();
    const auto found = std::ranges::find(names, m_instrument->currentText().toStdString());
    m_model.setInstrument(m_instrument->currentIndex() > 0
                              ? std::optional(static_cast<std::size_t>(found - names.begin()))
                              : std::nullopt);
    m_table->scrollToBottom();
    showState();
  });
  connect(m_filter, &QLineEdit::textChanged, &m_model, &DialogueModel::setText);
  connect(m_pause, &QPushButton::toggled, this, [this](bool paused) {
    m_model.setPaused(paused);
    takeNew();
  });
  connect(m_copy, &QPushButton::clicked, this, &BenchConsole::copy);
  connect(m_save, &QPushButton::clicked, this, &BenchConsole::save);
  return tools;
}

QWidget* BenchConsole::makeCommandLine() {
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  m_command = new QLineEdit(line);
  m_command->setObjectName(QStringLiteral("consoleCommand"));
  m_command->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_command->setToolTip(tr("Bytes that cannot be typed: \\n \\r \\t \\\\ \\x05. Arrow up: what was sent before."));
  m_command->installEventFilter(this);
  m_end = new QComboBox(line);
  m_end->setObjectName(QStringLiteral("consoleEnd"));
  m_end->setAccessibleName(tr("End of a command"));
  m_end->setToolTip(tr("What is sent after the command"));
  m_end->addItem(tr("then \\n"), QByteArray("\n"));
  m_end->addItem(tr("then \\r\\n"), QByteArray("\r\n"));
  m_end->addItem(tr("then \\r"), QByteArray("\r"));
  m_end->addItem(tr("as it is"), QByteArray());
  m_send = new QPushButton(tr("Send"), line);
  m_send->setObjectName(QStringLiteral("consoleSend"));
  row->addWidget(m_command, 1);
  row->addWidget(m_end);
  row->addWidget(m_send);
  connect(m_command, &QLineEdit::returnPressed, this, &BenchConsole::send);
  connect(m_send, &QPushButton::clicked, this, &BenchConsole::send);
  return line;
}

void BenchConsole::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  m_timer.start();
  takeNew();
}

void BenchConsole::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  m_timer.stop();
}

void BenchConsole::takeNew() {
  if (!isVisible()) {
    return;
  }
  const QScrollBar* bar = m_table->verticalScrollBar();
  const bool follows = bar->value() >= bar->maximum();
  const int before = m_model.rowCount();
  m_model.takeNew();
  if (m_model.rowCount() != before) {
    showInstruments();
  }
  if (follows) {
    m_table->scrollToBottom();
  }
}

void BenchConsole::showInstruments() {
  QStringList names;
  if (const auto& bench = m_presenter.opener().bench()) {
    for (std::size_t i = 0; i < bench->saved().instruments.size(); ++i) {
      names << QString::fromStdString(bench->instrumentName(i));
    }
  } else {
    for (const std::string& name : m_presenter.opener().dialogue().instruments()) {
      names << QString::fromStdString(name);
    }
  }
  if (names == m_names && m_instrument->count() > 0) {
    return;
  }
  m_names = names;
  const QString kept = m_instrument->currentText();
  {
    const QSignalBlocker quiet(m_instrument);
    m_instrument->clear();
    m_instrument->addItem(tr("All instruments"));
    m_instrument->addItems(names);
    m_instrument->setCurrentIndex(std::max(0, m_instrument->findText(kept)));
  }
  emit m_instrument->currentIndexChanged(m_instrument->currentIndex());
}

std::optional<std::size_t> BenchConsole::chosen() const {
  if (m_instrument->currentIndex() > 0) {
    return static_cast<std::size_t>(m_instrument->currentIndex()) - 1;
  }
  return m_names.size() == 1 ? std::optional<std::size_t>(0) : std::nullopt;
}

void BenchConsole::showState() {
  const bool open = m_presenter.opener().state() == BenchOpener::State::Open;
  const bool canSay = m_presenter.opener().canSay() && chosen().has_value();
  m_command->setEnabled(canSay);
  m_end->setEnabled(canSay);
  m_send->setEnabled(canSay);
  m_save->setEnabled(chosen().has_value());
  m_command->setPlaceholderText(!open                            ? tr("Connect the bench to send a command")
                                : !m_presenter.opener().canSay() ? tr("No commands during a capture")
                                : !chosen()                      ? tr("Choose an instrument to send a command")
                                            : tr("Command for %1").arg(m_names[static_cast<qsizetype>(*chosen())]));
}

void BenchConsole::send() {
  const std::optional<std::size_t> instrument = chosen();
  if (!instrument || !m_presenter.opener().canSay() || m_command->text().isEmpty()) {
    return;
  }
  const auto bytes = devices::unescaped(m_command->text().toStdString());
  if (!bytes) {
    m_problem->setTextOrHide(tr("This cannot be sent; write bytes beyond ASCII as \\xHH, and a backslash as \\\\"));
    return;
  }
  m_problem->setTextOrHide({});
  m_presenter.opener().say(*instrument, *bytes + m_end->currentData().toByteArray().toStdString());
  m_sent.removeAll(m_command->text());
  m_sent << m_command->text();
  m_recalled = m_sent.size();
  m_command->clear();
}

bool BenchConsole::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_command && event->type() == QEvent::KeyPress && !m_sent.isEmpty()) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Up || key == Qt::Key_Down) {
      m_recalled = std::clamp<qsizetype>(m_recalled + (key == Qt::Key_Up ? -1 : 1), 0, m_sent.size());
      m_command->setText(m_sent.value(m_recalled));
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

QWidget* withConsole(QWidget* content, BenchConsole& console, QWidget* parent) {
  auto* splitter = new QSplitter(Qt::Vertical, parent);
  splitter->addWidget(content);
  splitter->addWidget(&console);
  splitter->setChildrenCollapsible(false);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  return splitter;
}

void BenchConsole::copy() { QGuiApplication::clipboard()->setText(m_model.text()); }

bool BenchConsole::saveTo(const QString& file) {
  if (!chosen()) {
    m_problem->setTextOrHide(tr("A file holds the dialogue with one instrument; choose it in the list first"));
    return false;
  }
  const auto names = m_presenter.opener().dialogue().instruments();
  const auto found = std::ranges::find(names, m_names[static_cast<qsizetype>(*chosen())].toStdString());
  const Result<void> saved =
      m_presenter.opener().dialogue().save(file.toStdString(), static_cast<std::size_t>(found - names.begin()));
  m_problem->setTextOrHide(saved ? QString() : QString::fromStdString(saved.error().message()));
  return saved.has_value();
}

void BenchConsole::save() {
  auto* dialog = new QFileDialog(this, tr("Save the dialogue"), QString(), tr("Dialogues (*.txt)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("txt"));
  connect(dialog, &QFileDialog::fileSelected, this, &BenchConsole::saveTo);
  dialog->open();
}

} // namespace straightedge::gui
