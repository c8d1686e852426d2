#include "app/gui/document/scratch_folder.h"
#include "app/gui/shell/details_dialog.h"
#include "app/gui/shell/help_window.h"
#include "app/gui/shell/import_dialog.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/message_bar.h"
#include "app/gui/shell/program_start.h"
#include "app/gui/shell/step_bar.h"
#include "app/gui/shell/step_catalogue.h"
#include "tests/app/gui/shell/scripted_prompts.h"

#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <set>

namespace straightedge::gui {

class MainWindowTest : public QObject {
  Q_OBJECT
private slots:
  void initTestCase();
  void init();
  void cleanup();

  void beginsOnTheStartPage();
  void keyboardReachesEveryStep();
  void pagesAreMadeWhenFirstShown();
  void everyActionHasAMnemonicOfItsOwn();
  void exampleOpensInReview();
  void titleShowsUnsavedState();
  void closingAsksAndCancelKeeps();
  void keepForLaterIsOfferedOnTheStartPage();
  void discardIsGone();
  void saveOnCloseAsksForAName();
  void failedSaveOnCloseKeepsTheWindow();
  void openingAnotherNeverLosesTheFirst();
  void droppedCsvIsPreviewedAndImported();
  void csvWithoutUsableColumnsCannotBeImported();
  void corruptFilesAreExplained_data();
  void corruptFilesAreExplained();
  void undoAndRedoByKeyboard();
  void detailsAreKept();
  void helpFollowsTheStep();
  void simulatedBenchGoesToCapture();
  void stepBarSaysWhatIsMissing();
  void recentFilesAreListed();

private:
  void waitUntilIdle();
  void drop(const QStringList& files);
  QString writeFile(const QString& name, const QByteArray& bytes);
  bool keepsOpen() { return m_window->isVisible(); }

  std::unique_ptr<QTemporaryDir> m_home;
  PromptScript m_script;
  std::unique_ptr<MainWindow> m_window;
};

void MainWindowTest::initTestCase() { prepareApplication(*qApp); }

void MainWindowTest::init() {
  m_home = std::make_unique<QTemporaryDir>();
  QVERIFY(m_home->isValid());
  qputenv("XDG_DATA_HOME", m_home->filePath("data").toUtf8());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_home->filePath("config"));
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_home->filePath("config"));
  m_script = {};
  m_window = std::make_unique<MainWindow>(std::make_unique<ScriptedPrompts>(m_script));
  m_window->show();
  QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void MainWindowTest::cleanup() {
  m_window.reset();
  m_home.reset();
}

void MainWindowTest::waitUntilIdle() {
  QCoreApplication::processEvents();
  if (m_window->jobs().busy()) {
    QSignalSpy idle(&m_window->jobs(), &JobRunner::idle);
    QVERIFY(idle.wait(60000));
  }
}

QString MainWindowTest::writeFile(const QString& name, const QByteArray& bytes) {
  QFile file(m_home->filePath(name));
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
    qFatal("cannot write a test file");
  }
  return file.fileName();
}

void MainWindowTest::drop(const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& file : files) {
    urls << QUrl::fromLocalFile(file);
  }
  data.setUrls(urls);
  const QPoint middle = m_window->rect().center();
  QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(m_window.get(), &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(m_window.get(), &event);
  QVERIFY(event.isAccepted());
  QCoreApplication::processEvents(); // the file is opened after the drop has ended
  waitUntilIdle();
}

void MainWindowTest::beginsOnTheStartPage() {
  QCOMPARE(m_window->currentStep(), -1);
  QCOMPARE(m_window->windowTitle(), "Straightedge");
  QTest::mouseClick(m_window->findChild<QAbstractButton*>("startNew"), Qt::LeftButton);
  QCOMPARE(m_window->currentStep(), 0);
  QVERIFY(m_window->document().isScratch());
}

void MainWindowTest::keyboardReachesEveryStep() {
  QTest::keyClick(m_window.get(), Qt::Key_3, Qt::ControlModifier);
  QCOMPARE(m_window->currentStep(), -1); // nothing is open: nowhere to go
  QTest::keyClick(m_window.get(), Qt::Key_N, Qt::ControlModifier);
  for (int step = static_cast<int>(stepCount) - 1; step >= 0; --step) {
    QTest::keyClick(m_window.get(), static_cast<Qt::Key>(Qt::Key_1 + step), Qt::ControlModifier);
    QCOMPARE(m_window->currentStep(), step);
    QVERIFY(m_window->stepBar().button(static_cast<std::size_t>(step))->isChecked());
    QVERIFY(m_window->page(step)->isVisible());
    QVERIFY(m_window->stepBar().button(static_cast<std::size_t>(step))->hasFocus() ||
            m_window->page(step)->isAncestorOf(m_window->focusWidget()) ||
            m_window->page(step) == m_window->focusWidget());
    QCOMPARE(stepIndex(m_window->page(step)->title()), step);
  }
  for (int step = 1; step < static_cast<int>(stepCount); ++step) {
    QTest::keyClick(m_window.get(), Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(m_window->currentStep(), step);
  }
  QTest::keyClick(m_window.get(), Qt::Key_Right, Qt::AltModifier);
  QCOMPARE(m_window->currentStep(), 6);
  QTest::keyClick(m_window.get(), Qt::Key_Up, Qt::AltModifier);
  QCOMPARE(m_window->currentStep(), 5);
}

void MainWindowTest::pagesAreMadeWhenFirstShown() {
  m_window->newCalibration();
  QVERIFY(m_window->page(0) != nullptr);
  QVERIFY(m_window->page(4) == nullptr);
  QTest::mouseClick(m_window->stepBar().button(4), Qt::LeftButton);
  QVERIFY(m_window->page(4) != nullptr);
  QVERIFY(m_window->page(3) == nullptr);
}

void MainWindowTest::everyActionHasAMnemonicOfItsOwn() {
  std::set<QString> shortcuts;
  const auto menus = m_window->menuBar()->actions();
  QVERIFY(menus.size() >= 5);
  for (const QAction* top : menus) {
    std::set<QChar> letters;
    const auto actions = top->menu()->actions();
    for (const QAction* action : actions) {
      if (action->isSeparator()) {
        continue;
      }
      const auto at = action->text().indexOf('&');
      QVERIFY2(at >= 0, qPrintable(action->text()));
      QVERIFY2(letters.insert(action->text()[at + 1].toLower()).second, qPrintable(action->text()));
      const auto keys = action->shortcuts();
      for (const QKeySequence& key : keys) {
        QVERIFY2(shortcuts.insert(key.toString()).second, qPrintable(key.toString()));
      }
    }
  }
}

void MainWindowTest::exampleOpensInReview() {
  QTest::mouseClick(m_window->findChild<QAbstractButton*>("startExample"), Qt::LeftButton);
  waitUntilIdle();
  QCOMPARE(m_window->currentStep(), 2);
  QCOMPARE(m_window->document().sweep().size(), 32U);
  QVERIFY(m_window->document().run());
  QCOMPARE(m_window->stepBar().button(3)->state().progress, StepProgress::Done);
}

void MainWindowTest::titleShowsUnsavedState() {
  m_window->newCalibration();
  QCOMPARE(m_window->windowTitle(), "Untitled[*] — Straightedge");
  QVERIFY(!m_window->isWindowModified());
  m_window->openExample(":/examples/side_shaft_32.csv");
  QVERIFY(m_window->isWindowModified());
  m_script.saveFile = m_home->filePath("bearing.sedge");
  QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier);
  QVERIFY(QFile::exists(m_script.saveFile));
  QCOMPARE(m_window->windowTitle(), "bearing[*] — Straightedge");
  QVERIFY(!m_window->isWindowModified());
}

void MainWindowTest::closingAsksAndCancelKeeps() {
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Cancel;
  QVERIFY(!m_window->close());
  QCOMPARE(m_script.closeAsked, 1);
  QVERIFY(keepsOpen());
  QCOMPARE(m_window->document().sweep().size(), 32U);
}

void MainWindowTest::keepForLaterIsOfferedOnTheStartPage() {
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_script.closeAnswer = WindowPrompts::CloseAnswer::KeepForLater;
  QVERIFY(m_window->closeCalibration());
  QCOMPARE(m_window->currentStep(), -1);
  auto* row = m_window->findChild<QAbstractButton*>("unsavedRow");
  QVERIFY(row != nullptr);
  QTest::mouseClick(row, Qt::LeftButton, {}, QPoint(20, row->height() / 2));
  QVERIFY(m_window->document().isOpen());
  QVERIFY(m_window->document().isScratch());
  QCOMPARE(m_window->document().sweep().size(), 32U);
  QCOMPARE(m_window->currentStep(), 2);
}

void MainWindowTest::discardIsGone() {
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Discard;
  QVERIFY(m_window->close());
  QVERIFY(ScratchFolder::recoverable().isEmpty());
}

void MainWindowTest::saveOnCloseAsksForAName() {
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Save;
  m_script.saveFile = QString(); // the file dialogue is cancelled
  QVERIFY(!m_window->close());
  m_script.saveFile = m_home->filePath("kept.sedge");
  QVERIFY(m_window->close());
  AngleDocument again(m_window->jobs());
  QVERIFY(again.open(m_script.saveFile));
  QCOMPARE(again.sweep().size(), 32U);
}

void MainWindowTest::failedSaveOnCloseKeepsTheWindow() {
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Save;
  m_script.saveFile = m_home->filePath("no/such/folder/kept.sedge");
  QVERIFY(!m_window->close());
  QVERIFY(!m_window->messages().text().isEmpty());
  QCOMPARE(m_window->document().sweep().size(), 32U);
}

void MainWindowTest::openingAnotherNeverLosesTheFirst() {
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Cancel;
  m_window->newCalibration();
  QCOMPARE(m_window->document().sweep().size(), 32U);
  m_script.closeAnswer = WindowPrompts::CloseAnswer::KeepForLater;
  m_window->newCalibration();
  QCOMPARE(m_window->document().sweep().size(), 0U);
  QCOMPARE(ScratchFolder::recoverable().size(), 1);
}

void MainWindowTest::droppedCsvIsPreviewedAndImported() {
  drop({writeFile("messung.csv", "Drehgeber;Messwert [°];encoder_deg\n0,0;10,5;0\n30;40,5;30\n60;70,5;60\n90;100,5;90\n"
                                 "120;130,5;120\n150;160,5;150\n180;190,5;180\n210;220,5;210\n240;250,5;240\n"
                                 "270;280,5;270\n300;310,5;300\n330;340,5;330\n")});
  auto* dialog = m_window->importDialog();
  QVERIFY(dialog != nullptr);
  QVERIFY(dialog->isVisible());
  // The sensor's column was not recognised: the dialogue says so, and one chooses.
  QVERIFY(!dialog->problem().isEmpty());
  QVERIFY(!dialog->importButton()->isEnabled());
  auto* box = dialog->roleBox(1);
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down); // Encoder: taken over from column 3
  QTest::keyClick(box, Qt::Key_Down); // Sensor
  QCOMPARE(box->currentText(), "Sensor angle (°)");
  QVERIFY(!dialog->problem().isEmpty());
  QTest::keyClick(dialog->roleBox(0), Qt::Key_Down);
  QCOMPARE(dialog->problem(), QString());
  QTest::mouseClick(dialog->importButton(), Qt::LeftButton);
  waitUntilIdle();
  QCOMPARE(m_window->document().sweep().size(), 12U);
  QCOMPARE(m_window->document().sweep().sensorDeg[1], 40.5);
  QCOMPARE(m_window->document().sweep().encoderDeg[1], 30.0);
  QCOMPARE(m_window->currentStep(), 2);
}

void MainWindowTest::csvWithoutUsableColumnsCannotBeImported() {
  drop({writeFile("words.csv", "name,colour\nanna,red\nbert,blue\n")});
  auto* dialog = m_window->importDialog();
  if (dialog != nullptr) { // a table of words is a table; its columns are no angles
    QVERIFY(!dialog->problem().isEmpty());
    QVERIFY(!dialog->importButton()->isEnabled());
  } else {
    QVERIFY(!m_window->messages().text().isEmpty());
  }
}

void MainWindowTest::corruptFilesAreExplained_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  QTest::newRow("session that is text") << "a.sedge" << QByteArray("nothing of the kind");
  QTest::newRow("empty session") << "b.sedge" << QByteArray();
  QTest::newRow("session cut short") << "c.sedge" << QByteArray("SQLite format 3\0", 16);
  QTest::newRow("empty csv") << "d.csv" << QByteArray();
  QTest::newRow("picture") << "e.png" << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
}

void MainWindowTest::corruptFilesAreExplained() {
  QFETCH(QString, name);
  QFETCH(QByteArray, bytes);
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_script.closeAnswer = WindowPrompts::CloseAnswer::KeepForLater;
  drop({writeFile(name, bytes)});
  QVERIFY2(m_window->messages().text().contains(name), qPrintable(m_window->messages().text()));
  QVERIFY(m_window->importDialog() == nullptr);
  // What was open is open still, and nothing was asked for the sake of a file that cannot be opened.
  QCOMPARE(m_window->document().sweep().size(), 32U);
  QCOMPARE(m_script.closeAsked, 0);
}

void MainWindowTest::undoAndRedoByKeyboard() {
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_window->document().setPointsEnabled({1, 2}, false);
  QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(m_window->document().sweep().isEnabled(1));
  QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(!m_window->document().sweep().isEnabled(1));
}

void MainWindowTest::detailsAreKept() {
  m_window->newCalibration();
  QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ControlModifier);
  auto* dialog = m_window->findChild<DetailsDialog*>();
  QVERIFY(dialog != nullptr);
  QTest::keyClicks(dialog->findChild<QLineEdit*>("deviceSerial"), "A1335-0042");
  auto* uncertainty = dialog->findChild<QLineEdit*>("uncertainty");
  QTest::keyClicks(uncertainty, "much");
  QVERIFY(!dialog->okButton()->isEnabled());
  uncertainty->clear();
  QTest::keyClicks(uncertainty, "0,002"); // a decimal comma is understood
  QVERIFY(dialog->okButton()->isEnabled());
  QTest::mouseClick(dialog->okButton(), Qt::LeftButton);
  QCOMPARE(m_window->document().traceability().deviceSerial, "A1335-0042");
  QCOMPARE(m_window->document().traceability().reference.uncertainty, 0.002);
}

void MainWindowTest::helpFollowsTheStep() {
  QTest::keyClick(m_window.get(), Qt::Key_F1);
  QVERIFY(m_window->helpWindow() != nullptr);
  QCOMPARE(m_window->helpWindow()->currentPage(), "start");
  m_window->newCalibration();
  for (int step = 0; step < static_cast<int>(stepCount); ++step) {
    m_window->goToStep(step);
    m_window->showHelp({});
    QCOMPARE(m_window->helpWindow()->currentPage(), QString(stepCatalogue()[static_cast<std::size_t>(step)].helpPage));
    QCOMPARE(m_window->helpWindow()->currentPage(), m_window->page(step)->helpPage());
    QVERIFY(m_window->helpWindow()->text().size() > 400);
  }
}

void MainWindowTest::simulatedBenchGoesToCapture() {
  QTest::mouseClick(m_window->findChild<QAbstractButton*>("startSimulated"), Qt::LeftButton);
  QVERIFY(m_window->bench().isConnected());
  QCOMPARE(m_window->currentStep(), 1);
  QCOMPARE(m_window->stepBar().button(0)->state().progress, StepProgress::Done);
}

void MainWindowTest::stepBarSaysWhatIsMissing() {
  m_window->newCalibration();
  const auto& fit = m_window->stepBar().button(3)->state();
  QCOMPARE(fit.progress, StepProgress::Missing);
  QVERIFY(fit.note.contains("sweep"));
  QVERIFY(m_window->stepBar().button(3)->toolTip().contains("sweep"));
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_window->document().setPointsEnabled(
      {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27}, false);
  waitUntilIdle();
  QCOMPARE(m_window->stepBar().button(3)->state().progress, StepProgress::Failed);
  QVERIFY(!m_window->stepBar().button(3)->state().note.isEmpty());
}

void MainWindowTest::recentFilesAreListed() {
  m_window->openExample(":/examples/side_shaft_32.csv");
  m_script.saveFile = m_home->filePath("first & last.sedge");
  QVERIFY(m_window->saveAs());
  QVERIFY(m_window->closeCalibration());
  auto* row = m_window->findChild<QAbstractButton*>("recentRow");
  QVERIFY(row != nullptr);
  QCOMPARE(row->accessibleName(), "first & last.sedge");
  QVERIFY(QFile::remove(m_script.saveFile));
  QTest::mouseClick(row, Qt::LeftButton, {}, QPoint(20, row->height() / 2));
  QVERIFY(m_window->messages().text().contains("no such file"));
  QCOMPARE(m_window->currentStep(), -1);
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::MainWindowTest)
#include "main_window_test.moc"
