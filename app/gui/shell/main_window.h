// The window: start page, step bar, one page per step, menus. Knows a calibration only as its workspace.
#pragma once

#include "app/gui/jobs/job_runner.h"
#include "app/gui/shell/angle_workspace.h"
#include "app/gui/shell/recent_files.h"
#include "app/gui/shell/theme.h"
#include "app/gui/shell/window_prompts.h"

#include <QMainWindow>
#include <QPointer>
#include <QUndoGroup>

#include <map>
#include <memory>
#include <vector>

class QAction;
class QActionGroup;
class QMenu;
class QStackedWidget;

namespace straightedge::gui {

class FieldWorkspace;
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

  Workspace& workspace() { return *m_workspace; } ///< the kind of calibration that is open, or was last
  AngleDocument& document() { return m_angle->document(); }
  BenchLink& bench() { return m_angle->bench(); }
  FieldWorkspace& field(); ///< made when first asked for
  JobRunner& jobs() { return m_jobs; }
  MessageBar& messages() { return *m_messages; }
  StepBar& stepBar() { return *m_stepBar; }
  int currentStep() const { return m_currentStep; } ///< −1 on the start page
  StepPage* page(int step) const;                   ///< of the workspace; null until it was first shown
  ImportDialog* importDialog() const { return m_angle->importDialog(); }
  HelpWindow* helpWindow() const;

public slots:
  void newCalibration(); ///< of an angle sensor
  void newFieldCalibration();
  void startSimulatedFieldBench(); ///< likewise, of a field calibration
  void startSimulatedBench();      ///< a new calibration with the simulated bench connected, on Capture
  void openDialog();
  bool
  openFile(const QString& file); ///< a session, or a sweep or campaign to import; false where it was refused at once
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
  void fillStepMenu();
  void makeViewMenu();
  void makeHelpMenu();
  QWidget* makeRailFoot();
  void fillRecentMenu();
  void connectWorkspace(Workspace& workspace);
  void use(Workspace& workspace); ///< the step bar, menus and undo are this one's from now on
  void restoreLayout();
  void saveLayout() const;

  // Life of the calibration
  void deleteUnsaved(const QString& file);
  bool leaveCalibration(); ///< asks what has to be asked and closes; false: stay
  bool
  begin(Workspace& workspace); ///< a new calibration of this kind; false where the open one stays, or none could be
  template <typename OwnWorkspace>
  void startOnSimulatedBench(OwnWorkspace& workspace);
  bool saveTo(const QString& file);
  bool openSession(const QString& file);
  Workspace& workspaceOf(session::SessionKind kind);
  void takeData(Workspace& workspace, const ReadyData& ready);
  void complain(const Error& error);
  void showProblem(const QString& message);
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
  std::unique_ptr<AngleWorkspace> m_angle;
  std::unique_ptr<FieldWorkspace> m_field; ///< null until first needed
  Workspace* m_workspace = nullptr;        ///< never null
  QUndoGroup m_undo;
  RecentFiles m_recent;

  QStackedWidget* m_outer = nullptr; ///< start page, or rail and steps
  QStackedWidget* m_pages = nullptr;
  StartPage* m_start = nullptr;
  StepBar* m_stepBar = nullptr;
  MessageBar* m_messages = nullptr;
  std::map<const Workspace*, std::vector<StepPage*>> m_stepPages; ///< null until first shown
  int m_currentStep = -1;

  QMenu* m_recentMenu = nullptr;
  QActionGroup* m_themes = nullptr;
  QMenu* m_stepMenu = nullptr;
  QAction* m_afterSteps = nullptr; ///< separator
  QList<QAction*> m_stepActions;
  QList<QAction*> m_needsCalibration;
  QPointer<HelpWindow> m_help;
};

} // namespace straightedge::gui
