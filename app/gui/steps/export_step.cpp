#include "app/gui/steps/export_step.h"

#include "app/gui/steps/angle_export_presenter.h"
#include "app/gui/steps/notice_list.h"

#include <QCheckBox>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QUrl>
#include <QVBoxLayout>

namespace straightedge::gui {

ExportStep::ExportStep(std::unique_ptr<ExportPresenter> presenter, const QString& helpPage,
                       const QList<ExportRow>& rows, QWidget* parent)
    : StepPage(parent), m_owned(std::move(presenter)), m_presenter(*m_owned), m_helpPage(helpPage) {
  auto* page = new QVBoxLayout(this);
  m_notices = new NoticeList(this);
  page->addWidget(m_notices);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  page->addLayout(columns, 1);
  columns->addWidget(makeChoices(rows), 3);
  columns->addWidget(makeFiles(), 2);
  connect(&m_presenter, &ExportPresenter::changed, this, &ExportStep::refresh);
  connect(&m_presenter, &ExportPresenter::changed, this, &StepPage::availabilityChanged);
  connect(&m_presenter, &ExportPresenter::progressChanged, this,
          [this] { m_progress->setValue(static_cast<int>(m_presenter.progress() * 1000.0)); });
}

QString ExportStep::title() const { return tr("Export"); }

QString ExportStep::helpPage() const { return m_helpPage; }

QString ExportStep::missing() const { return m_presenter.missing(); }

void ExportStep::entered() {
  m_shown = true;
  refresh(); // files may have come or gone in the folder
}

void ExportStep::left() { m_shown = false; }

QWidget* ExportStep::makeChoices(const QList<ExportRow>& rows) {
  auto* area = new QWidget(this);
  auto* column = new QVBoxLayout(area);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);

  auto* where = new QGroupBox(tr("Folder"), area);
  auto* whereLayout = new QHBoxLayout(where);
  m_folder = new QLineEdit(where);
  m_folder->setObjectName(QStringLiteral("exportFolder"));
  m_folder->setAccessibleName(tr("Folder"));
  auto* browse = new QPushButton(tr("&Choose…"), where);
  browse->setObjectName(QStringLiteral("chooseFolder"));
  whereLayout->addWidget(m_folder, 1);
  whereLayout->addWidget(browse);
  column->addWidget(where);

  auto* what = new QGroupBox(tr("Files"), area);
  auto* grid = new QGridLayout(what);
  grid->setColumnStretch(4, 1);
  grid->setHorizontalSpacing(18);
  grid->setVerticalSpacing(9);
  for (const ExportRow& each : rows) {
    const int row = grid->rowCount();
    grid->addWidget(new QLabel(each.caption, what), row, 0);
    for (const ExportRow::Box& format : each.boxes) {
      auto* box = new QCheckBox(format.text, what);
      box->setObjectName(format.name);
      box->setToolTip(format.hint);
      box->setAccessibleName(each.caption + QStringLiteral(", ") + format.text);
      grid->addWidget(box, row, 1 + static_cast<int>(&format - each.boxes.data()));
      m_boxes.append({box, format.member});
      connect(box, &QCheckBox::toggled, this, [this, member = format.member](bool on) {
        ExportChoices choices = m_presenter.choices();
        choices.*member = on;
        m_presenter.setChoices(choices);
      });
    }
  }
  column->addWidget(what);

  auto* buttons = new QHBoxLayout;
  m_start = new QPushButton(tr("&Export"), area);
  m_start->setObjectName(QStringLiteral("startExport"));
  m_start->setDefault(true);
  m_open = new QPushButton(tr("&Open folder"), area);
  m_open->setObjectName(QStringLiteral("openFolder"));
  m_progress = new QProgressBar(area);
  m_progress->setRange(0, 1000);
  m_progress->setTextVisible(false);
  buttons->addWidget(m_start);
  buttons->addWidget(m_open);
  buttons->addWidget(m_progress, 1);
  buttons->addStretch(0);
  column->addLayout(buttons);
  column->addStretch(1);

  // The presenter is the context: a closing window takes the focus away when the presenter is gone already.
  connect(m_folder, &QLineEdit::editingFinished, &m_presenter, [this] {
    if (QDir::fromNativeSeparators(m_folder->text()) != m_presenter.folder()) {
      m_presenter.setFolder(QDir::fromNativeSeparators(m_folder->text()));
    }
  });
  connect(browse, &QPushButton::clicked, this, &ExportStep::chooseFolder);
  connect(m_start, &QPushButton::clicked, this, &ExportStep::startOrStop);
  connect(m_open, &QPushButton::clicked, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(m_presenter.writtenFolder())); });
  return area;
}

QWidget* ExportStep::makeFiles() {
  auto* box = new QGroupBox(tr("What is written"), this);
  auto* layout = new QVBoxLayout(box);
  m_count = new QLabel(box);
  m_count->setObjectName(QStringLiteral("fileCount"));
  m_count->setWordWrap(true);
  layout->addWidget(m_count);
  m_files = new QListWidget(box);
  m_files->setObjectName(QStringLiteral("fileList"));
  m_files->setAlternatingRowColors(true);
  m_files->setSelectionMode(QAbstractItemView::ExtendedSelection);
  layout->addWidget(m_files, 1);
  connect(m_files, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    if (m_presenter.written().contains(item->text())) {
      QDesktopServices::openUrl(QUrl::fromLocalFile(m_presenter.writtenFolder() + QLatin1Char('/') + item->text()));
    }
  });
  return box;
}

void ExportStep::refresh() {
  m_stale = !m_shown;
  if (m_stale) {
    return;
  }
  if (!m_folder->hasFocus() || m_folder->text().isEmpty()) {
    m_folder->setText(QDir::toNativeSeparators(m_presenter.folder()));
  }
  for (const auto& [box, member] : m_boxes) {
    const QSignalBlocker quiet(box);
    box->setChecked(m_presenter.choices().*member);
  }
  QList<Notice> notices;
  if (const QString missing = m_presenter.missing(); !missing.isEmpty()) {
    notices.append({Notice::Level::Information, missing});
  }
  if (!m_presenter.statusText().isEmpty()) {
    notices.append(
        {m_presenter.failed() ? Notice::Level::Problem : Notice::Level::Information, m_presenter.statusText()});
  }
  m_notices->setNotices(notices);
  const bool running = m_presenter.isRunning();
  m_start->setText(running ? tr("Stop") : tr("&Export"));
  m_start->setEnabled(running || m_presenter.canStart());
  m_open->setVisible(!m_presenter.written().isEmpty());
  m_progress->setVisible(running);
  m_progress->setValue(static_cast<int>(m_presenter.progress() * 1000.0));
  const bool done = !m_presenter.written().isEmpty();
  const QStringList names = done ? m_presenter.written() : m_presenter.fileNames();
  const qsizetype replaced = done ? 0 : m_presenter.existing().size();
  m_count->setText(
      done ? tr("%1 files written. Double click opens one.").arg(names.size())
      : replaced == 0
          ? tr("%1 files will be written.").arg(names.size())
          : tr("%1 files will be written; %2 of them replace a file of that name.").arg(names.size()).arg(replaced));
  m_files->clear();
  m_files->addItems(names);
}

void ExportStep::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the files"), m_presenter.folder());
  if (!folder.isEmpty()) {
    m_presenter.setFolder(folder);
    m_folder->setText(QDir::toNativeSeparators(m_presenter.folder()));
  }
}

void ExportStep::startOrStop() {
  if (m_presenter.isRunning()) {
    m_presenter.stop();
    return;
  }
  m_presenter.start();
}

QList<ExportRow> ExportStep::pictureRows() {
  return {{tr("Plots"),
           {{tr("PNG"), QStringLiteral("exportPng"), {}, &ExportChoices::plotsPng},
            {tr("SVG"), QStringLiteral("exportSvg"), {}, &ExportChoices::plotsSvg},
            {tr("PDF"), QStringLiteral("exportPdf"), {}, &ExportChoices::plotsPdf}}},
          {tr("Report"),
           {{tr("PDF"), QStringLiteral("exportReportPdf"), tr("Every plot and table, numbered, on A4 pages"),
             &ExportChoices::reportPdf},
            {tr("HTML"), QStringLiteral("exportReportHtml"), tr("The same as one page for a browser"),
             &ExportChoices::reportHtml}}}};
}

StepPage* makeExportStep(StepContext context, QWidget* parent) {
  const auto say = [](const char* text) { return ExportStep::tr(text); };
  const QList<ExportRow> rows{
      {say("Calibration"),
       {{say("JSON"), QStringLiteral("exportCalibration"),
         say("calibration.json: all models with errors, uncertainty and traceability"), &ExportChoices::calibration}}},
      {say("Table of each model"),
       {{say("CSV"), QStringLiteral("exportTablesCsv"), {}, &ExportChoices::tablesCsv},
        {say("JSON"), QStringLiteral("exportTablesJson"), {}, &ExportChoices::tablesJson}}},
      {say("Readings"),
       {{say("CSV"), QStringLiteral("exportSweep"), say("sweep.csv: the readings the calibration was made from"),
         &ExportChoices::sweep}}},
      {say("Comparison of methods"),
       {{say("CSV"), QStringLiteral("exportComparison"), {}, &ExportChoices::comparison}}}};
  return new ExportStep(std::make_unique<AngleExportPresenter>(context.document, context.jobs),
                        QStringLiteral("export"), rows + ExportStep::pictureRows(), parent);
}

} // namespace straightedge::gui
