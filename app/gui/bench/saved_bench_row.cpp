#include "app/gui/bench/saved_bench_row.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace straightedge::gui {

SavedBenchRow::SavedBenchRow(BenchPresenter& presenter, QWidget* parent)
    : QWidget(parent), m_presenter(presenter), m_saved(new QComboBox(this)), m_save(new QPushButton(tr("Save"), this)),
      m_saveAs(new QPushButton(tr("Save as…"), this)), m_delete(new QPushButton(tr("Delete…"), this)) {
  m_saved->setObjectName(QStringLiteral("savedBenches"));
  m_saved->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_saved->setMinimumContentsLength(10);
  m_saved->setToolTip(tr("Benches remember which instrument fills which role, and how it is set"));
  m_save->setObjectName(QStringLiteral("saveBench"));
  m_saveAs->setObjectName(QStringLiteral("saveBenchAs"));
  m_delete->setObjectName(QStringLiteral("deleteBench"));
  auto* caption = new QLabel(tr("&Bench"), this);
  QFont bold = caption->font();
  bold.setBold(true);
  caption->setFont(bold);
  caption->setBuddy(m_saved);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  auto* choice = new QHBoxLayout;
  choice->addWidget(caption);
  choice->addWidget(m_saved, 1);
  rows->addLayout(choice);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  for (QPushButton* each : {m_save, m_saveAs, m_delete}) {
    buttons->addWidget(each);
  }
  rows->addLayout(buttons);

  connect(&presenter, &BenchPresenter::savedChanged, this, &SavedBenchRow::showSaved);
  connect(m_saved, &QComboBox::activated, this, [this](int index) {
    if (index == 0) {
      m_presenter.startAnew();
    } else {
      m_presenter.load(m_saved->itemData(index).toString());
    }
  });
  connect(m_save, &QPushButton::clicked, this, [this] { m_presenter.save(m_presenter.benchName()); });
  connect(m_saveAs, &QPushButton::clicked, this, &SavedBenchRow::saveAs);
  connect(m_delete, &QPushButton::clicked, this, &SavedBenchRow::deleteBench);
  showSaved();
}

void SavedBenchRow::showSaved() {
  const QSignalBlocker quiet(m_saved);
  const QString name = m_presenter.benchName();
  m_saved->clear();
  m_saved->addItem(tr("New bench"));
  for (const QString& saved : m_presenter.savedNames()) {
    m_saved->addItem(saved == name && m_presenter.isChanged() ? tr("%1 (changed)").arg(saved) : saved, saved);
  }
  m_saved->setCurrentIndex(std::max(0, name.isEmpty() ? 0 : m_saved->findData(name)));
  const bool edits = m_presenter.mayEdit();
  m_saved->setEnabled(edits);
  m_save->setEnabled(edits && !name.isEmpty() && m_presenter.isChanged());
  m_saveAs->setEnabled(edits && !m_presenter.draft().bench().instruments.empty());
  m_delete->setEnabled(edits && !name.isEmpty());
}

void SavedBenchRow::saveAs() {
  auto* ask = new QInputDialog(this);
  ask->setObjectName(QStringLiteral("benchNameDialog"));
  ask->setAttribute(Qt::WA_DeleteOnClose);
  ask->setWindowTitle(tr("Save the bench"));
  ask->setLabelText(tr("Name of the bench, as for straightedge-cli capture --bench NAME:"));
  ask->setTextValue(m_presenter.benchName());
  connect(ask, &QInputDialog::textValueSelected, this, [this](const QString& name) { m_presenter.save(name); });
  ask->open();
}

void SavedBenchRow::deleteBench() {
  const QString name = m_presenter.benchName();
  auto* question = new QMessageBox(QMessageBox::Warning, tr("Delete the bench?"),
                                   tr("The bench “%1” is deleted. Its instruments and roles stay as they are until you "
                                      "choose another.")
                                       .arg(name),
                                   QMessageBox::Cancel, this);
  question->setObjectName(QStringLiteral("deleteBenchQuestion"));
  question->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* yes = question->addButton(tr("Delete"), QMessageBox::DestructiveRole);
  question->setDefaultButton(QMessageBox::Cancel);
  connect(yes, &QPushButton::clicked, this, [this, name] { m_presenter.deleteSaved(name); });
  question->open();
}

} // namespace straightedge::gui
