// The window: start page, step bar, one page per step, menus. Holds the one open calibration.
#pragma once

#include "app/gui/document/angle_document.h"
#include "app/gui/document/bench_link.h"
#include "app/gui/jobs/job_runner.h"
#include "app/gui/shell/recent_files.h"
#include "app/gui/shell/step_catalogue.h"
#include "app/gui/shell/theme.h"
#include "app/gui/shell/window_prompts.h"
#include "core/angle/sweep_csv.h"

#include <QMainWindow>
#include <QPointer>

#include <array>
#include <memory>

class QAction;
class QActionGroup;
class QMenu;
class QStackedWidget;

namespace straightedge::gui {

class HelpWindow;
class ImportDialog;
class MessageBar;
class StartPage;
class StepBar;

class MainWindow : public QMainWindow {
  Q_OBJECT
public:
  /// Without `prompts`: message boxes and file dialogues.
  explicit MainWindow(std::unique_ptr<WindowPrompts> prompts = nullptr, QWidget* parent = nullptr);
  ~MainWindow() override;

  AngleDocument& document() { return m_document; }
  BenchLink& bench() { return m_bench; }
  JobRunner& jobs() { return m_jobs; }
  MessageBar& messages() { return *m_messages; }
  StepBar& stepBar() { return *m_stepBar; }
  int currentStep() const { return m_currentStep; } ///< −1 on the start page
  StepPage* page(int step) const;                   ///< null until it was first shown
  ImportDialog* importDialog() const;
  HelpWindow* helpWindow() const;

public slots:
  void newCalibration();
  void startSimulatedBench(); ///< a new calibration with the simulated bench connected, on Capture
  void openDialog();
  bool openFile(const QString& file); ///< a session, or a sweep to import; false where it was refused at once
  void openExample(const QString& resource);
  void importDialogForFile(); ///< asks for a CSV file first
  void importCsv(const QString& file);
  bool save(); ///< a scratch session asks for a name; false where it was cancelled or failed
  bool saveAs();
  bool closeCalibration(); ///< back to the start page; false where the user keeps it open
  void goToStep(int step);
  void showHelp(const QString& page);
  void showDetails();
  void showAbout();

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  // Building
  void makePages();
  void makeMenus();
  void makeFileMenu();
  void makeEditMenu();
  void makeStepMenu();
  void makeViewMenu();
  void makeHelpMenu();
  QWidget* makeRailFoot();
  void fillRecentMenu();
  void connectDocument();
  void restoreLayout();
  void saveLayout() const;

  // Life of the calibration
  void deleteUnsaved(const QString& file);
  bool leaveCalibration(); ///< asks what has to be asked and closes; false: stay
  bool saveTo(const QString& file);
  bool openSession(const QString& file);
  void showImport(const QString& file, const angle::CsvPreview& preview);
  void readSweep(const QString& file, const angle::SweepMapping& mapping, bool forVerification);
  void useSweep(angle::Sweep sweep, const QString& name, bool forVerification);
  void complain(const Error& error);
  void tell(const QString& text);

  void showStart();
  void createPage(int step);
  void updateTitle();
  void updateSteps();
  void updateActions();
  void copyFromFocus();
  void setTheme(ThemeChoice choice);
  QString folderForDialogs() const;

  std::unique_ptr<WindowPrompts> m_prompts;
  JobRunner m_jobs;
  AngleDocument m_document{m_jobs};
  BenchLink m_bench{m_document};
  RecentFiles m_recent;

  QStackedWidget* m_outer = nullptr; ///< start page, or rail and steps
  QStackedWidget* m_pages = nullptr;
  StartPage* m_start = nullptr;
  StepBar* m_stepBar = nullptr;
  MessageBar* m_messages = nullptr;
  std::array<StepPage*, stepCount> m_stepPages{};
  int m_currentStep = -1;
  bool m_wasCapturing = false;

  QMenu* m_recentMenu = nullptr;
  QActionGroup* m_themes = nullptr;
  QList<QAction*> m_needsCalibration;
  QPointer<HelpWindow> m_help;
  QPointer<ImportDialog> m_import;
};

} // namespace straightedge::gui
