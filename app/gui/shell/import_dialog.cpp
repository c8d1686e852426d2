#include "app/gui/shell/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {
constexpr int roleRow = 0;  // combo boxes
constexpr int rangeRow = 1; // what numbers the column holds
constexpr int firstDataRow = 2;
} // namespace

ImportDialog::ImportDialog(const QString& file, const angle::CsvPreview& preview, bool preferVerification,
                           bool canVerify, QWidget* parent)
    : QDialog(parent), m_presenter(preview) {
  setObjectName("importDialog");
  setWindowTitle(tr("Import Sweep"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 16, 18, 16);
  layout->setSpacing(10);

  auto* name = new QLabel(QFileInfo(file).fileName(), this);
  QFont bold = name->font();
  bold.setBold(true);
  bold.setPointSizeF(bold.pointSizeF() * 1.15);
  name->setFont(bold);
  name->setTextFormat(Qt::PlainText);
  layout->addWidget(name);
  auto* how = new QLabel(m_presenter.layoutText(), this);
  how->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(how);
  m_table = makeTable();
  layout->addWidget(m_table, 1);
  if (canVerify) {
    layout->addWidget(makeUse(preferVerification));
  }

  auto* foot = new QHBoxLayout;
  m_problem = new QLabel(this);
  m_problem->setWordWrap(true);
  m_problem->setObjectName("importProblem");
  foot->addWidget(m_problem, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  m_import = buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
  m_import->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  foot->addWidget(buttons);
  layout->addLayout(foot);
  refresh();
  resize(qBound(560, 60 + 170 * static_cast<int>(preview.columns.size()), 1000), 500);
}

QTableWidget* ImportDialog::makeTable() {
  const auto& preview = m_presenter.preview();
  const int columns = static_cast<int>(preview.columns.size());
  auto* table = new QTableWidget(firstDataRow + static_cast<int>(preview.firstRows.size()), columns, this);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::ContiguousSelection);
  table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table->setTabKeyNavigation(false);
  QStringList titles;
  QStringList rowTitles{tr("Is"), tr("Range")};
  for (std::size_t row = 0; row < preview.firstRows.size(); ++row) {
    rowTitles << QString::number(row + 1);
  }
  for (int column = 0; column < columns; ++column) {
    const auto index = static_cast<std::size_t>(column);
    titles << QString::fromStdString(preview.columns[index].title);
    auto* box = new QComboBox(table);
    for (const auto role : ImportPresenter::roles()) {
      box->addItem(ImportPresenter::roleText(role), static_cast<int>(role));
    }
    box->setAccessibleName(tr("Meaning of column %1").arg(titles.last()));
    connect(box, &QComboBox::activated, this, [this, index, box] {
      m_presenter.setRole(index, static_cast<angle::SweepColumn>(box->currentData().toInt()));
      refresh();
    });
    table->setCellWidget(roleRow, column, box);
    m_roles << box;
    const auto put = [&](int row, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table->setItem(row, column, item);
      return item;
    };
    put(rangeRow, m_presenter.rangeText(index))->setForeground(palette().color(QPalette::PlaceholderText));
    for (std::size_t row = 0; row < preview.firstRows.size(); ++row) {
      const auto& cells = preview.firstRows[row];
      put(firstDataRow + static_cast<int>(row),
          index < cells.size() ? QString::fromStdString(cells[index]) : QString());
    }
  }
  table->setHorizontalHeaderLabels(titles);
  table->setVerticalHeaderLabels(rowTitles);
  table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  table->setRowHeight(roleRow, m_roles.isEmpty() ? 30 : m_roles.first()->sizeHint().height() + 6);
  table->horizontalHeader()->setSectionResizeMode(columns <= 5 ? QHeaderView::Stretch : QHeaderView::Interactive);
  table->horizontalHeader()->setDefaultSectionSize(170);
  table->horizontalHeader()->setHighlightSections(false);
  table->verticalHeader()->setHighlightSections(false);
  return table;
}

QWidget* ImportDialog::makeUse(bool preferVerification) {
  auto* box = new QWidget(this);
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new QLabel(tr("Use it as"), box));
  auto* calibration = new QRadioButton(tr("&calibration sweep (replaces the present one)"), box);
  m_verification = new QRadioButton(tr("&fresh sweep to verify"), box);
  (preferVerification ? m_verification : calibration)->setChecked(true);
  layout->addWidget(calibration);
  layout->addWidget(m_verification);
  layout->addStretch(1);
  return box;
}

bool ImportDialog::forVerification() const { return m_verification != nullptr && m_verification->isChecked(); }

void ImportDialog::refresh() {
  const auto& mapping = m_presenter.mapping();
  for (std::size_t column = 0; column < mapping.size(); ++column) {
    auto* box = m_roles[static_cast<qsizetype>(column)];
    box->setCurrentIndex(box->findData(static_cast<int>(mapping[column])));
    for (int row = firstDataRow; row < m_table->rowCount(); ++row) {
      const bool used = mapping[column] != angle::SweepColumn::Ignored;
      m_table->item(row, static_cast<int>(column))
          ->setForeground(palette().color(used ? QPalette::Text : QPalette::PlaceholderText));
    }
  }
  const QString problem = m_presenter.problem();
  m_problem->setText(problem);
  m_import->setEnabled(problem.isEmpty());
}

} // namespace straightedge::gui
