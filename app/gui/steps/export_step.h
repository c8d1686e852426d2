// Step Export: files to take away — calibration, tables, comparison, plots, report.
#pragma once

#include "app/gui/steps/export_presenter.h"
#include "app/gui/steps/step_page.h"

#include <QList>

#include <memory>

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace straightedge::gui {

class NoticeList;

/// A kind of file with a box for each of its formats.
struct ExportRow {
  struct Box {
    QString text, name, hint; ///< "CSV"; of the widget; tooltip
    bool ExportChoices::* member;
  };
  QString caption;
  QList<Box> boxes;
};

class ExportStep : public StepPage {
  Q_OBJECT
public:
  ExportStep(std::unique_ptr<ExportPresenter> presenter, const QString& helpPage, const QList<ExportRow>& rows,
             QWidget* parent = nullptr);
  /// The rows that every kind of calibration ends with: plots and report.
  static QList<ExportRow> pictureRows();

  QString title() const override;
  QString helpPage() const override;
  QString missing() const override;
  void entered() override;
  void left() override;

private:
  QWidget* makeChoices(const QList<ExportRow>& rows);
  QWidget* makeFiles();
  void refresh();
  void chooseFolder();
  void startOrStop();

  std::unique_ptr<ExportPresenter> m_owned;
  ExportPresenter& m_presenter;
  QString m_helpPage;
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
