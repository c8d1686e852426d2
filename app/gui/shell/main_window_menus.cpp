// The window's menus: every action with a mnemonic, and a shortcut where it is used often.
#include "app/gui/shell/about_dialog.h"
#include "app/gui/shell/details_dialog.h"
#include "app/gui/shell/help_window.h"
#include "app/gui/shell/line_icon.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/table_clipboard.h"

#include <QActionGroup>
#include <QApplication>
#include <QFileInfo>
#include <QMenuBar>
#include <QSettings>

namespace straightedge::gui {

namespace {
void showShortcut(QAction& action, const QList<QKeySequence>& keys) { action.setShortcuts(keys); }
} // namespace

void MainWindow::makeMenus() {
  makeFileMenu();
  makeEditMenu();
  makeStepMenu();
  makeViewMenu();
  makeHelpMenu();
}

void MainWindow::makeFileMenu() {
  auto* menu = menuBar()->addMenu(tr("&File"));
  menu->addAction(lineIcon("new"), tr("&New Angle Calibration"), QKeySequence::New, this, &MainWindow::newCalibration);
  menu->addAction(lineIcon("new"), tr("New &Field Calibration"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_N), this,
                  &MainWindow::newFieldCalibration);
  menu->addAction(lineIcon("bench"), tr("New on the Simulated Angle &Bench"),
                  QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N), this, &MainWindow::startSimulatedBench);
  menu->addAction(lineIcon("bench"), tr("New on the Si&mulated Field Bench"),
                  QKeySequence(Qt::CTRL | Qt::ALT | Qt::SHIFT | Qt::Key_N), this,
                  &MainWindow::startSimulatedFieldBench);
  menu->addAction(lineIcon("open"), tr("&Open…"), QKeySequence::Open, this, &MainWindow::openDialog);
  m_recentMenu = menu->addMenu(tr("Open &Recent"));
  connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
  menu->addAction(lineIcon("import"), tr("&Import CSV…"), QKeySequence(Qt::CTRL | Qt::Key_I), this,
                  &MainWindow::importDialogForFile);
  menu->addSeparator();
  m_needsCalibration << menu->addAction(lineIcon("save"), tr("&Save"), QKeySequence::Save, this, &MainWindow::save);
  auto* saveAsAction = menu->addAction(tr("Save &As…"), this, &MainWindow::saveAs);
  saveAsAction->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
  m_needsCalibration << saveAsAction;
  m_needsCalibration << menu->addAction(lineIcon("details"), tr("&Details…"), QKeySequence(Qt::CTRL | Qt::Key_D), this,
                                        &MainWindow::showDetails);
  menu->addSeparator();
  m_needsCalibration << menu->addAction(tr("&Close"), QKeySequence::Close, this, &MainWindow::closeCalibration);
  auto* quit = menu->addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), this, &QWidget::close);
  quit->setMenuRole(QAction::QuitRole);
}

void MainWindow::makeEditMenu() {
  auto* menu = menuBar()->addMenu(tr("&Edit"));
  auto* undo = m_undo.createUndoAction(this, tr("&Undo"));
  undo->setIcon(lineIcon("undo"));
  undo->setShortcut(QKeySequence::Undo);
  auto* redo = m_undo.createRedoAction(this, tr("&Redo"));
  redo->setIcon(lineIcon("redo"));
  showShortcut(*redo, {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  menu->addAction(undo);
  menu->addAction(redo);
  menu->addSeparator();
  menu->addAction(lineIcon("copy"), tr("&Copy"), QKeySequence::Copy, this, &MainWindow::copyFromFocus);
}

void MainWindow::makeStepMenu() {
  auto* menu = menuBar()->addMenu(tr("&Step"));
  m_stepMenu = menu;
  m_afterSteps = menu->addSeparator();
  auto* previous = menu->addAction(tr("&Previous Step"), this, [this] { goToStep(m_currentStep - 1); });
  showShortcut(*previous, {QKeySequence(Qt::ALT | Qt::Key_Left), QKeySequence(Qt::ALT | Qt::Key_Up)});
  auto* next = menu->addAction(tr("&Next Step"), this, [this] { goToStep(m_currentStep + 1); });
  showShortcut(*next, {QKeySequence(Qt::ALT | Qt::Key_Right), QKeySequence(Qt::ALT | Qt::Key_Down)});
  m_needsCalibration << previous << next;
}

void MainWindow::fillStepMenu() {
  qDeleteAll(m_stepActions);
  m_stepActions.clear();
  for (const StepEntry& step : m_workspace->steps()) {
    const auto index = static_cast<int>(m_stepActions.size());
    auto* action = new QAction(tr(step.menuText), m_stepMenu);
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + index)));
    connect(action, &QAction::triggered, this, [this, index] { goToStep(index); });
    m_stepMenu->insertAction(m_afterSteps, action);
    m_stepActions << action;
  }
  updateActions();
}

void MainWindow::makeViewMenu() {
  auto* menu = menuBar()->addMenu(tr("&View"));
  m_themes = new QActionGroup(this);
  const ThemeChoice now = themeFromName(QSettings().value("theme").toString());
  const auto add = [&](const QString& text, ThemeChoice choice, const QKeySequence& key) {
    auto* action = menu->addAction(text, key, this, [this, choice] { setTheme(choice); });
    action->setCheckable(true);
    action->setChecked(choice == now);
    m_themes->addAction(action);
  };
  add(tr("&Light"), ThemeChoice::Light, QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_L));
  add(tr("&Dark"), ThemeChoice::Dark, QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_D));
  add(tr("As the &System"), ThemeChoice::System, QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S));
  menu->addSeparator();
  menu->addAction(tr("&Full Screen"), QKeySequence(Qt::Key_F11), this,
                  [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
}

void MainWindow::makeHelpMenu() {
  auto* menu = menuBar()->addMenu(tr("&Help"));
  menu->addAction(lineIcon("help"), tr("Help for This &Step"), QKeySequence(Qt::Key_F1), this,
                  [this] { showHelp({}); });
  menu->addAction(tr("The &Method"), QKeySequence(Qt::SHIFT | Qt::Key_F1), this, [this] { showHelp("method"); });
  menu->addAction(tr("&Files and Command Line"), this, [this] { showHelp("files"); });
  menu->addAction(tr("&Keyboard"), this, [this] { showHelp("keyboard"); });
  menu->addSeparator();
  auto* about = menu->addAction(tr("&About Straightedge"), this, &MainWindow::showAbout);
  about->setMenuRole(QAction::AboutRole);
}

void MainWindow::fillRecentMenu() {
  m_recentMenu->clear();
  int number = 0;
  for (const QString& file : m_recent.files()) {
    QString name = QFileInfo(file).fileName();
    name.replace('&', "&&");
    const QString text = ++number < 10 ? QStringLiteral("&%1  %2").arg(number).arg(name) : name;
    auto* action = m_recentMenu->addAction(text, this, [this, file] { openFile(file); });
    action->setEnabled(QFileInfo::exists(file));
    action->setToolTip(file);
  }
  if (number == 0) {
    m_recentMenu->addAction(tr("No recent files"))->setEnabled(false);
  }
}

void MainWindow::updateActions() {
  const bool open = m_workspace->document().isOpen();
  for (const auto* actions : {&m_needsCalibration, &m_stepActions}) {
    for (QAction* action : *actions) {
      action->setEnabled(open);
    }
  }
}

void MainWindow::setTheme(ThemeChoice choice) {
  QSettings().setValue("theme", themeName(choice));
  applyTheme(*qApp, choice);
}

void MainWindow::copyFromFocus() {
  if (!copyFrom(QApplication::focusWidget())) {
    tell(tr("Nothing to copy: select cells of a table, or text, first."));
  }
}

void MainWindow::showDetails() {
  auto& document = m_workspace->document();
  if (!document.isOpen()) {
    return;
  }
  auto* dialog = new DetailsDialog(document.traceability(), m_workspace->referenceUnit(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, &document,
          [&document, dialog] { document.setTraceability(dialog->traceability()); });
  dialog->open();
}

void MainWindow::showHelp(const QString& wanted) {
  const QString page = !wanted.isEmpty()    ? wanted
                       : m_currentStep >= 0 ? this->page(m_currentStep)->helpPage()
                                            : QStringLiteral("start");
  if (!m_help) {
    m_help = new HelpWindow(this);
    m_help->setAttribute(Qt::WA_DeleteOnClose);
  }
  m_help->showPage(page);
  m_help->show();
  m_help->raise();
  m_help->activateWindow();
}

HelpWindow* MainWindow::helpWindow() const { return m_help; }

void MainWindow::showAbout() {
  auto* dialog = new AboutDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

} // namespace straightedge::gui
