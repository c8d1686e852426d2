// Step Export: files to take away — calibration, tables, comparison, plots, report.
#pragma once

#include "app/gui/steps/export_presenter.h"
#include "app/gui/steps/step_page.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace straightedge::gui {

class NoticeList;

class ExportStep : public StepPage {
  Q_OBJECT
public:
  explicit ExportStep(StepContext context, QWidget* parent = nullptr);

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeChoices();
  QWidget* makeFiles();
  QCheckBox* addChoice(QGridLayout* grid, int row, int column, const QString& text, const QString& name,
                       bool ExportChoices::* member);
  void refresh();
  void chooseFolder();
  void startOrStop();

  ExportPresenter m_presenter;
  bool m_shown = false;
  bool m_stale = true;
  NoticeList* m_notices = nullptr;
  QLineEdit* m_folder = nullptr;
  QList<std::pair<QCheckBox*, bool ExportChoices::*>> m_boxes;
  QPushButton* m_start = nullptr;
  QPushButton* m_open = nullptr;
  QProgressBar* m_progress = nullptr;
  QLabel* m_count = nullptr;
  QListWidget* m_files = nullptr;
};

} // namespace straightedge::gui
