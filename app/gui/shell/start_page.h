// What one sees first: begin, open, try, or go on with what was left.
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace straightedge::gui {

class RecentFiles;

class StartPage : public QWidget {
  Q_OBJECT
public:
  explicit StartPage(RecentFiles& recent, QWidget* parent = nullptr);
  /// Reads recent files and unsaved calibrations anew.
  void refresh();

signals:
  void newCalibration();
  void newFieldCalibration();
  void openFile();
  void simulatedBench();
  void simulatedFieldBench();
  void openExample(const QString& resource);
  void openRecent(const QString& file);
  void recover(const QString& scratchFile);
  void deleteUnsaved(const QString& scratchFile);

protected:
  void showEvent(QShowEvent* event) override;

private:
  QWidget* makeActions();
  QWidget* makeLists();
  void fillUnsaved();
  void fillRecent();

  RecentFiles& m_recent;
  QWidget* m_unsavedBox = nullptr;
  QVBoxLayout* m_unsaved = nullptr;
  QVBoxLayout* m_recentList = nullptr;
};

} // namespace straightedge::gui
