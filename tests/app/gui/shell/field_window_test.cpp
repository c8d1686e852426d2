// The window with both kinds of calibration: which one a file opens, and that changing over never loses anything.
#include "app/gui/document/scratch_folder.h"
#include "app/gui/shell/data_kind.h"
#include "app/gui/shell/details_dialog.h"
#include "app/gui/shell/field_step_catalogue.h"
#include "app/gui/shell/field_workspace.h"
#include "app/gui/shell/help_window.h"
#include "app/gui/shell/import_dialog.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/message_bar.h"
#include "app/gui/shell/program_start.h"
#include "app/gui/shell/recent_files.h"
#include "app/gui/shell/step_bar.h"
#include "tests/app/gui/shell/scripted_prompts.h"

#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>

namespace straightedge::gui {

namespace {
const QString sweepExample = QStringLiteral(":/examples/side_shaft_32.csv");
const QString campaignExample = QStringLiteral(":/examples/hall_probe_campaign.csv");
} // namespace

class FieldWindowTest : public QObject {
  Q_OBJECT
private slots:
  void initTestCase();
  void init();
  void cleanup();

  void newFieldCalibrationReachesEveryStep();
  void openGlIsNotLoadedBeforeItIsWanted();
  void exampleOpensInReview();
  void droppedCampaignOpensInReview();
  void droppedCampaignGoesIntoTheOpenFieldCalibration();
  void campaignDroppedOnVerifyIsAFreshOne();
  void droppedSweepAsksBeforeTheFieldCalibrationIsLeft();
  void leavingAnAngleCalibrationAsks();
  void leavingAFieldCalibrationAsks();
  void savedSessionsOpenAsTheirKind();
  void unsavedFieldCalibrationIsRecovered();
  void undoIsTheOpenKinds();
  void aBrokenCampaignIsExplained();
  void detailsAskForTesla();
  void stepBarSaysWhatIsMissing();
  void headersTellTheKind_data();
  void headersTellTheKind();

private:
  void waitUntilIdle();
  void drop(const QString& file);
  QString campaignFile(const QString& name);
  bool fieldIsOpen() { return &m_window->workspace() == &m_window->field() && m_window->field().document().isOpen(); }
  std::size_t rows() { return m_window->field().document().campaign().rows.size(); }

  std::unique_ptr<QTemporaryDir> m_home;
  PromptScript m_script;
  std::unique_ptr<MainWindow> m_window;
};

void FieldWindowTest::initTestCase() { prepareApplication(*qApp); }

void FieldWindowTest::init() {
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

void FieldWindowTest::cleanup() {
  m_window.reset();
  m_home.reset();
}

void FieldWindowTest::waitUntilIdle() {
  QCoreApplication::processEvents();
  if (m_window->jobs().busy()) {
    QSignalSpy idle(&m_window->jobs(), &JobRunner::idle);
    QVERIFY(idle.wait(60000));
  }
  QCoreApplication::processEvents(); // what a finished job has asked for begins with the next turn
  if (m_window->jobs().busy()) {
    QSignalSpy idle(&m_window->jobs(), &JobRunner::idle);
    QVERIFY(idle.wait(60000));
  }
}

void FieldWindowTest::drop(const QString& file) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  const QPoint middle = m_window->rect().center();
  QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(m_window.get(), &enter);
  QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(m_window.get(), &event);
  QVERIFY(event.isAccepted());
  waitUntilIdle();
}

QString FieldWindowTest::campaignFile(const QString& name) {
  const QString file = m_home->filePath(name);
  if (!QFile::copy(campaignExample, file)) {
    qFatal("cannot write a test file");
  }
  return file;
}

void FieldWindowTest::newFieldCalibrationReachesEveryStep() {
  QTest::mouseClick(m_window->findChild<QAbstractButton*>("startNewField"), Qt::LeftButton);
  QVERIFY(fieldIsOpen());
  QVERIFY(m_window->field().document().isScratch());
  QCOMPARE(m_window->currentStep(), 0);
  QCOMPARE(m_window->windowTitle(), "Untitled[*] — Straightedge");
  const auto steps = fieldStepCatalogue();
  for (std::size_t i = steps.size(); i-- > 0;) {
    QTest::keyClick(m_window.get(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i)), Qt::ControlModifier);
    QCOMPARE(m_window->currentStep(), static_cast<int>(i));
    QVERIFY(m_window->stepBar().button(i)->isChecked());
    QVERIFY(m_window->page(static_cast<int>(i))->isVisible());
    QCOMPARE(m_window->page(static_cast<int>(i))->title(), QString(steps[i].title));
    m_window->showHelp({});
    QCOMPARE(m_window->helpWindow()->currentPage(), QString(steps[i].helpPage));
    QCOMPARE(m_window->helpWindow()->currentPage(), m_window->page(static_cast<int>(i))->helpPage());
    QVERIFY(m_window->helpWindow()->text().size() > 400);
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
  }
  QVERIFY(m_window->closeCalibration());
  QCOMPARE(m_script.closeAsked, 0); // nothing was in it
  QVERIFY(ScratchFolder::recoverable().isEmpty());
}

void FieldWindowTest::openGlIsNotLoadedBeforeItIsWanted() {
  // The first test that could show a picture in space: what is loaded stays loaded.
  const auto loaded = [](const char* library) {
    QFile maps(QStringLiteral("/proc/self/maps"));
    return maps.open(QIODevice::ReadOnly) && maps.readAll().contains(library);
  };
  const QList<const char*> heavy{"libvtkRenderingOpenGL2", "libvtkRenderingUI", "libGLEW", "swrast_dri", "libLLVM"};
  m_window->openExample(campaignExample);
  QVERIFY(m_window->currentStep() >= 0);
  for (int step = 0; step < static_cast<int>(fieldStepCatalogue().size()); ++step) {
    m_window->goToStep(step);
    QTest::qWait(0);
  }
  for (const char* library : heavy) {
    QVERIFY2(!loaded(library), library);
  }
}

void FieldWindowTest::exampleOpensInReview() {
  m_window->openExample(campaignExample);
  waitUntilIdle();
  QVERIFY(fieldIsOpen());
  QCOMPARE(m_window->currentStep(), 2);
  QVERIFY(rows() > 300);
  const auto run = m_window->field().document().run();
  QVERIFY(run);
  QVERIFY2(run->result.warnings.empty(), run->result.warnings.empty() ? "" : run->result.warnings[0].text.c_str());
  QVERIFY(m_window->field().document().verification());
  QVERIFY(m_window->field().document().verification()->met);
  QVERIFY(m_window->isWindowModified());
}

void FieldWindowTest::droppedCampaignOpensInReview() {
  drop(campaignFile("probe 7.csv"));
  QVERIFY(m_window->importDialog() == nullptr);
  QVERIFY(fieldIsOpen());
  QCOMPARE(m_window->currentStep(), 2);
  QCOMPARE(m_window->field().document().campaign().name, "probe 7.csv");
  QVERIFY(m_window->field().document().run());
  QVERIFY(!m_window->document().isOpen());
  QCOMPARE(QSettings().value("lastFolder").toString(), m_home->path());
}

void FieldWindowTest::droppedCampaignGoesIntoTheOpenFieldCalibration() {
  m_window->newFieldCalibration();
  const QString file = m_window->field().document().file();
  drop(campaignFile("first.csv"));
  QCOMPARE(m_window->field().document().file(), file);
  drop(campaignFile("second.csv"));
  QCOMPARE(m_script.closeAsked, 0);
  QCOMPARE(m_window->field().document().campaign().name, "second.csv");
  m_window->field().document().undoStack().undo();
  QCOMPARE(m_window->field().document().campaign().name, "first.csv");
}

void FieldWindowTest::campaignDroppedOnVerifyIsAFreshOne() {
  m_window->openExample(campaignExample);
  waitUntilIdle();
  QVERIFY(!m_window->field().document().verificationIsFresh());
  m_window->goToStep(5);
  drop(campaignFile("fresh.csv"));
  QCOMPARE(m_window->currentStep(), 5);
  QCOMPARE(m_window->field().document().verificationCampaign().name, "fresh.csv");
  QVERIFY(m_window->field().document().verificationIsFresh());
  QCOMPARE(m_window->field().document().campaign().name, "hall_probe_campaign.csv");
}

void FieldWindowTest::droppedSweepAsksBeforeTheFieldCalibrationIsLeft() {
  m_window->openExample(campaignExample);
  waitUntilIdle();
  const QString file = m_home->filePath("sweep.csv");
  QVERIFY(QFile::copy(sweepExample, file));
  for (const auto answer : {WindowPrompts::CloseAnswer::Cancel, WindowPrompts::CloseAnswer::KeepForLater}) {
    m_script.closeAnswer = answer;
    drop(file);
    QVERIFY(m_window->importDialog() != nullptr);
    QTest::mouseClick(m_window->importDialog()->importButton(), Qt::LeftButton);
    waitUntilIdle();
    if (answer == WindowPrompts::CloseAnswer::Cancel) {
      QVERIFY(fieldIsOpen());
      QVERIFY(rows() > 300);
      QVERIFY(!m_window->document().isOpen());
      QCOMPARE(m_window->document().sweep().size(), 0U);
    }
  }
  QCOMPARE(m_script.closeAsked, 2);
  QCOMPARE(m_window->document().sweep().size(), 32U);
  QVERIFY(&m_window->workspace() != &m_window->field());
  QVERIFY(!m_window->field().document().isOpen());
  QCOMPARE(ScratchFolder::recoverable().size(), 1);
}

void FieldWindowTest::leavingAnAngleCalibrationAsks() {
  m_window->openExample(sweepExample);
  waitUntilIdle();
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Cancel;
  m_window->newFieldCalibration();
  QCOMPARE(m_script.closeAsked, 1);
  QCOMPARE(m_window->document().sweep().size(), 32U);
  QCOMPARE(m_window->currentStep(), 2);
  const QString file = campaignFile("probe.csv");
  drop(file);
  QCOMPARE(m_script.closeAsked, 2);
  QCOMPARE(m_window->document().sweep().size(), 32U);
  QCOMPARE(rows(), 0U);
  m_script.closeAnswer = WindowPrompts::CloseAnswer::KeepForLater;
  drop(file);
  QVERIFY(fieldIsOpen());
  QVERIFY(!m_window->document().isOpen());
  QVERIFY(rows() > 300);
  QCOMPARE(ScratchFolder::recoverable().size(), 1);
}

void FieldWindowTest::leavingAFieldCalibrationAsks() {
  m_window->openExample(campaignExample);
  waitUntilIdle();
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Cancel;
  m_window->newCalibration();
  QVERIFY(fieldIsOpen());
  QVERIFY(!m_window->close());
  QCOMPARE(m_script.closeAsked, 2);
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Discard;
  m_window->newCalibration();
  QVERIFY(m_window->document().isOpen());
  QVERIFY(!m_window->field().document().isOpen());
  QVERIFY(ScratchFolder::recoverable().isEmpty());
}

void FieldWindowTest::savedSessionsOpenAsTheirKind() {
  const QString probe = m_home->filePath("probe.sedge");
  const QString bearing = m_home->filePath("bearing.sedge");
  m_window->openExample(campaignExample);
  waitUntilIdle();
  m_script.saveFile = probe;
  QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier);
  QCOMPARE(m_window->windowTitle(), "probe[*] — Straightedge");
  m_window->openExample(sweepExample);
  waitUntilIdle();
  m_script.saveFile = bearing;
  QVERIFY(m_window->saveAs());

  QVERIFY(m_window->openFile(probe));
  QVERIFY(fieldIsOpen());
  QCOMPARE(m_window->currentStep(), 2);
  QVERIFY(rows() > 300);
  QCOMPARE(m_window->windowTitle(), "probe[*] — Straightedge");
  QVERIFY(m_window->openFile(bearing));
  QCOMPARE(m_window->document().sweep().size(), 32U);
  QVERIFY(!m_window->field().document().isOpen());
  QCOMPARE(m_script.closeAsked, 0);
  QVERIFY(m_window->closeCalibration());
  QCOMPARE(RecentFiles().files(), QStringList({bearing, probe}));
}

void FieldWindowTest::unsavedFieldCalibrationIsRecovered() {
  m_window->openExample(campaignExample);
  waitUntilIdle();
  const std::size_t all = rows();
  m_script.closeAnswer = WindowPrompts::CloseAnswer::KeepForLater;
  m_window->newCalibration(); // the window was another kind's last
  QVERIFY(m_window->closeCalibration());
  auto* row = m_window->findChild<QAbstractButton*>("unsavedRow");
  QVERIFY(row != nullptr);
  QTest::mouseClick(row, Qt::LeftButton, {}, QPoint(20, row->height() / 2));
  QVERIFY(fieldIsOpen());
  QVERIFY(m_window->field().document().isScratch());
  QCOMPARE(rows(), all);
  QCOMPARE(m_window->currentStep(), 2);
}

void FieldWindowTest::undoIsTheOpenKinds() {
  m_window->openExample(campaignExample);
  m_window->field().document().setRowsEnabled({1, 2}, false);
  QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(m_window->field().document().isRowEnabled(1));
  QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(!m_window->field().document().isRowEnabled(1));
  m_script.closeAnswer = WindowPrompts::CloseAnswer::Discard;
  m_window->openExample(sweepExample);
  m_window->document().setPointsEnabled({1}, false);
  QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(m_window->document().sweep().isEnabled(1));
}

void FieldWindowTest::aBrokenCampaignIsExplained() {
  m_window->openExample(campaignExample);
  waitUntilIdle();
  const std::size_t all = rows();
  QFile file(m_home->filePath("broken.csv"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("step,axis,reference_T,raw_x_T,raw_y_T,raw_z_T\nnonlinearity,x,0.5,0.5,0,0\nnonlinearity,q,0.5,0.5,0,0\n");
  file.close();
  drop(file.fileName());
  QVERIFY2(m_window->messages().text().contains("broken.csv:3"), qPrintable(m_window->messages().text()));
  QCOMPARE(rows(), all);
  QCOMPARE(m_script.closeAsked, 0);
}

void FieldWindowTest::detailsAskForTesla() {
  m_window->newFieldCalibration();
  m_window->showDetails();
  auto* dialog = m_window->findChild<DetailsDialog*>();
  QVERIFY(dialog != nullptr);
  const auto labels = dialog->findChildren<QLabel*>();
  QVERIFY(std::any_of(labels.begin(), labels.end(),
                      [](const QLabel* label) { return label->text().contains("(T, k = 2)"); }));
}

void FieldWindowTest::stepBarSaysWhatIsMissing() {
  m_window->newFieldCalibration();
  QCOMPARE(m_window->stepBar().button(3)->state().progress, StepProgress::Missing);
  QVERIFY(m_window->stepBar().button(3)->toolTip().contains("campaign"));
  m_window->openExample(campaignExample);
  waitUntilIdle();
  QCOMPARE(m_window->stepBar().button(3)->state().progress, StepProgress::Done);
  QCOMPARE(m_window->stepBar().button(5)->state().progress, StepProgress::Done);
  FieldChoices choices;
  choices.limitPercent = 1e-6;
  m_window->field().document().setChoices(choices, "limit");
  waitUntilIdle();
  QCOMPARE(m_window->stepBar().button(5)->state().progress, StepProgress::Failed);
}

void FieldWindowTest::headersTellTheKind_data() {
  QTest::addColumn<QByteArray>("beginning");
  QTest::addColumn<bool>("field");
  QTest::newRow("campaign") << QByteArray("step,axis,raw_x_T,raw_y_T,raw_z_T\nx") << true;
  QTest::newRow("comments, order, case, semicolons, BOM")
      << QByteArray("\xEF\xBB\xBF# step\r\n\r\nRAW_X_T; \"Step\" ;raw_y_T\r\n") << true;
  QTest::newRow("only named in a comment") << QByteArray("# step,raw_x_T\nencoder_deg,sensor_deg\n0,1\n") << false;
  QTest::newRow("sweep") << QByteArray("encoder_deg,sensor_deg\n0,1\n") << false;
  QTest::newRow("steps of something else") << QByteArray("step,angle\n0,1\n") << false;
  QTest::newRow("nothing") << QByteArray() << false;
}

void FieldWindowTest::headersTellTheKind() {
  QFETCH(QByteArray, beginning);
  QFETCH(bool, field);
  QCOMPARE(dataKindOf(beginning) == session::SessionKind::Field, field);
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::FieldWindowTest)
#include "field_window_test.moc"
