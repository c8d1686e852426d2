#include "app/gui/shell/start_page.h"

#include "app/gui/document/scratch_folder.h"
#include "app/gui/shell/action_card.h"
#include "app/gui/shell/examples.h"
#include "app/gui/shell/file_row.h"
#include "app/gui/shell/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

QLabel* heading(const QString& text, qreal scale, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * scale);
  font.setBold(true);
  label->setFont(font);
  return label;
}

void clear(QVBoxLayout& layout) {
  while (auto* item = layout.takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide(); // gone from sight at once, not with the next turn of the event loop
      item->widget()->deleteLater();
    }
    delete item;
  }
}

QString folderOf(const QString& file) {
  QString folder = QFileInfo(file).absolutePath();
  const QString home = QDir::homePath();
  if (folder == home || folder.startsWith(home + '/')) {
    folder.replace(0, home.size(), "~");
  }
  return folder;
}

} // namespace

StartPage::StartPage(RecentFiles& recent, QWidget* parent) : QWidget(parent), m_recent(recent) {
  setObjectName("startPage");
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  outer->addWidget(scroll);

  auto* page = new QWidget(scroll);
  auto* centred = new QHBoxLayout(page);
  centred->setContentsMargins(24, 24, 24, 20);
  auto* content = new QWidget(page);
  content->setMaximumWidth(980);
  centred->addStretch(1);
  centred->addWidget(content, 100);
  centred->addStretch(1);

  auto* rows = new QVBoxLayout(content);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  rows->addWidget(heading("Straightedge", 2.0, content));
  auto* subtitle = new QLabel(tr("Calibrate an angle sensor or a three-axis Hall teslameter, and see what each way of "
                                 "storing the correction costs and leaves."),
                              content);
  subtitle->setWordWrap(true);
  subtitle->setForegroundRole(QPalette::PlaceholderText);
  rows->addWidget(subtitle);
  rows->addSpacing(20);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(36);
  columns->addWidget(makeActions(), 10);
  columns->addWidget(makeLists(), 9);
  rows->addLayout(columns, 1);
  scroll->setWidget(page);
  connect(&m_recent, &RecentFiles::changed, this, &StartPage::fillRecent);
}

QWidget* StartPage::makeActions() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(heading(tr("Begin"), 1.15, box));
  const auto card = [&](const char* icon, const QString& title, const QString& text, void (StartPage::*signal)(),
                        const char* name) {
    auto* button = new ActionCard(icon, title, text, box);
    button->setObjectName(name);
    connect(button, &ActionCard::clicked, this, signal);
    layout->addWidget(button);
  };
  card("new", tr("&New angle calibration"), tr("Capture a sweep, or import one from a CSV file"),
       &StartPage::newCalibration, "startNew");
  card("new", tr("New fiel&d calibration"), tr("Capture a campaign, or import one from a CSV file"),
       &StartPage::newFieldCalibration, "startNewField");
  card("open", tr("&Open…"), tr("A .sedge file, a sweep or a campaign (.csv)"), &StartPage::openFile, "startOpen");
  card("bench", tr("&Simulated angle bench"), tr("Try the whole way without hardware"), &StartPage::simulatedBench,
       "startSimulated");
  card("bench", tr("Simulated field &bench"), tr("A Hall probe, an NMR, a magnet and chambers, all simulated"),
       &StartPage::simulatedFieldBench, "startSimulatedField");
  layout->addSpacing(12);
  layout->addWidget(heading(tr("Examples"), 1.15, box));
  for (const Example& example : examples()) {
    auto* button = new ActionCard("example", example.title, example.description, box);
    button->setObjectName("startExample");
    connect(button, &ActionCard::clicked, this, [this, resource = example.resource] { emit openExample(resource); });
    layout->addWidget(button);
  }
  layout->addStretch(1);
  return box;
}

QWidget* StartPage::makeLists() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);

  m_unsavedBox = new QWidget(box);
  auto* unsaved = new QVBoxLayout(m_unsavedBox);
  unsaved->setContentsMargins(0, 0, 0, 14);
  unsaved->setSpacing(6);
  unsaved->addWidget(heading(tr("Unsaved calibrations"), 1.15, m_unsavedBox));
  m_unsaved = new QVBoxLayout;
  m_unsaved->setSpacing(2);
  unsaved->addLayout(m_unsaved);
  layout->addWidget(m_unsavedBox);

  layout->addWidget(heading(tr("Recent"), 1.15, box));
  m_recentList = new QVBoxLayout;
  m_recentList->setSpacing(2);
  layout->addLayout(m_recentList);
  layout->addStretch(1);
  return box;
}

void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void StartPage::refresh() {
  fillUnsaved();
  fillRecent();
}

void StartPage::fillUnsaved() {
  clear(*m_unsaved);
  const auto entries = ScratchFolder::recoverable();
  m_unsavedBox->setVisible(!entries.isEmpty());
  for (const auto& entry : entries) {
    const QString when = QLocale().toString(entry.modified, QLocale::ShortFormat);
    const QString size = QLocale().formattedDataSize(QFileInfo(entry.file).size(), 0);
    auto* row = new FileRow(tr("Untitled, last changed %1").arg(when), tr("Not saved under a name yet · %1").arg(size),
                            true, tr("Delete this unsaved calibration"), m_unsavedBox);
    row->setObjectName("unsavedRow");
    connect(row, &FileRow::clicked, this, [this, file = entry.file] { emit recover(file); });
    connect(row, &FileRow::removeRequested, this, [this, file = entry.file] { emit deleteUnsaved(file); });
    m_unsaved->addWidget(row);
  }
}

void StartPage::fillRecent() {
  clear(*m_recentList);
  const QStringList files = m_recent.files();
  if (files.isEmpty()) {
    auto* none = new QLabel(tr("Calibrations you open or save appear here."), this);
    none->setForegroundRole(QPalette::PlaceholderText);
    none->setWordWrap(true);
    none->setContentsMargins(10, 4, 0, 0);
    m_recentList->addWidget(none);
  }
  for (const QString& file : files) {
    const bool exists = QFileInfo::exists(file);
    const QString folder = exists ? folderOf(file) : tr("Not found in %1").arg(folderOf(file));
    auto* row = new FileRow(QFileInfo(file).fileName(), folder, exists, tr("Remove from this list"), this);
    row->setObjectName("recentRow");
    connect(row, &FileRow::clicked, this, [this, file] { emit openRecent(file); });
    connect(row, &FileRow::removeRequested, this, [this, file] { m_recent.remove(file); });
    m_recentList->addWidget(row);
  }
}

} // namespace straightedge::gui
