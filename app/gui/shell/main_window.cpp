#include "app/gui/shell/main_window.h"

#include "app/gui/shell/details_dialog.h"
#include "app/gui/shell/field_workspace.h"
#include "app/gui/shell/help_window.h"
#include "app/gui/shell/job_status.h"
#include "app/gui/shell/line_icon.h"
#include "app/gui/shell/message_bar.h"
#include "app/gui/shell/start_page.h"
#include "app/gui/shell/step_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace straightedge::gui {

MainWindow::MainWindow(std::unique_ptr<WindowPrompts> prompts, QWidget* parent)
    : QMainWindow(parent), m_prompts(prompts ? std::move(prompts) : std::make_unique<DialogPrompts>()) {
  setObjectName("mainWindow");
  setWindowIcon(QIcon(":/icons/straightedge.svg"));
  setAcceptDrops(true);
  m_angle = std::make_unique<AngleWorkspace>(m_jobs);
  makePages();
  makeMenus();
  statusBar()->addPermanentWidget(new JobStatus(m_jobs, this));
  statusBar()->setSizeGripEnabled(false);
  connectWorkspace(*m_angle);
  use(*m_angle);
  restoreLayout();
  showStart();
}

MainWindow::~MainWindow() {
  // Pages refer to the calibration, the bench and the jobs, which are members and would go first.
  delete takeCentralWidget();
  for (Workspace* workspace : {static_cast<Workspace*>(m_angle.get()), static_cast<Workspace*>(m_field.get())}) {
    if (workspace != nullptr) {
      workspace->disconnect(this);
      workspace->document().disconnect(this);
    }
  }
  m_jobs.disconnect(this);
}

void MainWindow::makePages() {
  auto* central = new QWidget(this);
  auto* rows = new QVBoxLayout(central);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  m_messages = new MessageBar(central);
  rows->addWidget(m_messages);
  m_outer = new QStackedWidget(central);
  rows->addWidget(m_outer, 1);
  setCentralWidget(central);

  m_start = new StartPage(m_recent, m_outer);
  m_outer->addWidget(m_start);
  connect(m_start, &StartPage::newCalibration, this, &MainWindow::newCalibration);
  connect(m_start, &StartPage::newFieldCalibration, this, &MainWindow::newFieldCalibration);
  connect(m_start, &StartPage::openFile, this, &MainWindow::openDialog);
  connect(m_start, &StartPage::simulatedBench, this, &MainWindow::startSimulatedBench);
  connect(m_start, &StartPage::openExample, this, &MainWindow::openExample);
  connect(m_start, &StartPage::openRecent, this, &MainWindow::openFile);
  connect(m_start, &StartPage::recover, this, &MainWindow::openFile);
  connect(m_start, &StartPage::deleteUnsaved, this, &MainWindow::deleteUnsaved);

  auto* work = new QWidget(m_outer);
  auto* columns = new QHBoxLayout(work);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(0);
  m_stepBar = new StepBar(work);
  m_stepBar->addFoot(makeRailFoot());
  columns->addWidget(m_stepBar);
  m_pages = new QStackedWidget(work);
  columns->addWidget(m_pages, 1);
  m_outer->addWidget(work);
  connect(m_stepBar, &StepBar::chosen, this, &MainWindow::goToStep);
}

QWidget* MainWindow::makeRailFoot() {
  auto* foot = new QWidget(m_stepBar);
  auto* layout = new QVBoxLayout(foot);
  layout->setContentsMargins(8, 0, 8, 0);
  layout->setSpacing(2);
  const auto add = [&](const char* icon, const QString& text, const QString& tip, auto action) {
    auto* button = new QToolButton(foot);
    button->setAutoRaise(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIcon(lineIcon(icon));
    button->setText(text);
    button->setToolTip(tip);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, this, action);
    layout->addWidget(button);
  };
  add("details", tr("Details…"), tr("Device, operator, reference instrument and ambient temperature (Ctrl+D)"),
      &MainWindow::showDetails);
  add("help", tr("Help"), tr("Help for this step (F1)"), [this] { showHelp({}); });
  return foot;
}

void MainWindow::connectWorkspace(Workspace& workspace) {
  m_stepPages[&workspace].resize(workspace.steps().size());
  auto& document = workspace.document();
  m_undo.addStack(&document.undoStack());
  connect(&document, &CalibrationDocument::opened, this, [this] {
    updateSteps();
    updateActions();
  });
  connect(&document, &CalibrationDocument::titleChanged, this, &MainWindow::updateTitle);
  connect(&document, &CalibrationDocument::storageFailed, this, &MainWindow::showProblem);
  connect(&workspace, &Workspace::stateChanged, this, [this] {
    updateSteps();
    updateActions();
    updateTitle();
  });
  connect(&workspace, &Workspace::failed, this, &MainWindow::showProblem);
  connect(&workspace, &Workspace::benchFailed, this, [this](const QString& message) {
    const StepPage* shown = page(m_currentStep);
    if (shown == nullptr || !shown->tellsBenchFaults()) {
      showProblem(message);
    }
  });
  connect(&workspace, &Workspace::dataReady, this,
          [this, &workspace](const ReadyData& ready) { takeData(workspace, ready); });
}

FieldWorkspace& MainWindow::field() {
  if (!m_field) {
    m_field = std::make_unique<FieldWorkspace>(m_jobs);
    connectWorkspace(*m_field);
  }
  return *m_field;
}

void MainWindow::use(Workspace& workspace) {
  if (m_workspace == &workspace) {
    return;
  }
  if (auto* shown = m_workspace == nullptr ? nullptr : page(m_currentStep)) {
    shown->left();
  }
  m_currentStep = -1;
  m_workspace = &workspace;
  m_stepBar->setSteps(workspace.steps());
  fillStepMenu();
  m_undo.setActiveStack(&workspace.document().undoStack());
  updateSteps();
}

void MainWindow::showStart() {
  if (auto* shown = page(m_currentStep)) {
    shown->left();
  }
  m_currentStep = -1;
  statusBar()->clearMessage();
  m_start->refresh();
  m_outer->setCurrentIndex(0);
  updateActions();
  updateTitle();
}

StepPage* MainWindow::page(int step) const {
  const auto& pages = m_stepPages.at(m_workspace);
  return step >= 0 && step < static_cast<int>(pages.size()) ? pages[static_cast<std::size_t>(step)] : nullptr;
}

void MainWindow::createPage(int step) {
  const auto index = static_cast<std::size_t>(step);
  auto& made = m_stepPages.at(m_workspace)[index];
  if (made != nullptr) {
    return;
  }
  auto* page = m_workspace->makePage(index, m_pages);
  made = page;
  // On a small or strongly scaled screen a page scrolls instead of making the window larger than the screen.
  auto* scroll = new QScrollArea(m_pages);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(page);
  m_pages->addWidget(scroll);
  connect(page, &StepPage::availabilityChanged, this, &MainWindow::updateSteps);
  connect(page, &StepPage::helpRequested, this, &MainWindow::showHelp);
  connect(page, &StepPage::detailsRequested, this, &MainWindow::showDetails);
  connect(page, &StepPage::goToStep, this, [this](const QString& title) {
    if (const int target = stepIndex(m_workspace->steps(), title); target >= 0) {
      goToStep(target);
    }
  });
}

void MainWindow::goToStep(int step) {
  if (!m_workspace->document().isOpen() || step < 0 || step >= static_cast<int>(m_workspace->steps().size())) {
    return;
  }
  const int former = m_currentStep;
  createPage(step);
  auto* next = page(step);
  m_outer->setCurrentIndex(1);
  m_stepBar->setCurrent(step);
  if (former != step) {
    if (auto* page = this->page(former)) {
      page->left();
    }
    m_currentStep = step;
    m_pages->setCurrentWidget(next->parentWidget()->parentWidget()); // the page's scroll area
    next->entered();
  }
  // The keyboard goes on where the eye is: on the rail's entry of this step, or in the page.
  const auto* focused = focusWidget();
  if (focused == nullptr || m_stepBar->isAncestorOf(focused)) {
    m_stepBar->button(static_cast<std::size_t>(step))->setFocus();
  } else if (!next->isAncestorOf(focused)) {
    next->setFocus();
  }
  updateSteps();
  updateActions();
}

void MainWindow::updateSteps() {
  const auto& pages = m_stepPages.at(m_workspace);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    StepState state = m_workspace->state(i);
    if (pages[i] != nullptr && state.progress != StepProgress::Failed) {
      if (const QString missing = pages[i]->missing(); !missing.isEmpty()) {
        state = {StepProgress::Missing, missing};
      }
    }
    m_stepBar->setState(i, state);
  }
}

void MainWindow::updateTitle() {
  const auto& document = m_workspace->document();
  if (!document.isOpen()) {
    setWindowTitle(tr("Straightedge"));
    setWindowModified(false);
    setWindowFilePath({});
    return;
  }
  const QString readOnly = document.isReadOnly() ? tr(" (read-only)") : QString();
  setWindowTitle(tr("%1[*]%2 — Straightedge").arg(document.displayName(), readOnly));
  setWindowModified(document.isScratch() ? document.hasContent() : document.hasUnsavedState());
}

void MainWindow::complain(const Error& error) { showProblem(QString::fromStdString(error.message())); }

void MainWindow::showProblem(const QString& message) { m_messages->showMessage(message, MessageBar::Kind::Problem); }

void MainWindow::tell(const QString& text) { statusBar()->showMessage(text, 6000); }

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::ActivationChange && isActiveWindow() && m_currentStep < 0 && m_start != nullptr) {
    m_start->refresh(); // files may have come or gone meanwhile
  }
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  if (!restoreGeometry(settings.value("geometry").toByteArray())) {
    resize(1240, 780);
  }
}

void MainWindow::saveLayout() const {
  QSettings settings;
  settings.setValue("geometry", saveGeometry());
}

} // namespace straightedge::gui
