#include "app/gui/steps/angle_export_presenter.h"
#include "app/gui/steps/verify_presenter.h"
#include "tests/app/gui/steps_fit/document_fixture.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

using namespace straightedge;
using namespace straightedge::gui;
using gui::testing::OpenDocument;
using gui::testing::patienceMs;

class VerifyExportPresenterTest : public QObject {
  Q_OBJECT

private slots:
  void verifiesASweepFromAFile();
  void limitDecides();
  void capturesBetweenThePointsOfTheCalibration();
  void saysWhyNothingCanBeCaptured();
  void namesAFileThatCannotBeRead();
  void exportsWhatIsChosen();
  void exportReportsAFolderThatCannotBeMade();
};

void VerifyExportPresenterTest::verifiesASweepFromAFile() {
  OpenDocument open;
  QVERIFY(open.load());
  VerifyPresenter presenter(open.document, open.bench, open.jobs);
  QCOMPARE(presenter.outcome(), VerifyPresenter::Outcome::None);
  QVERIFY(presenter.verdictText().startsWith("Take a fresh sweep"));
  presenter.loadCsv(QString::fromStdString(gui::testing::exampleFile()));
  QVERIFY(QTest::qWaitFor([&] { return open.document.verification().has_value(); }, patienceMs));
  QVERIFY(presenter.verdictText().startsWith("Passed"));
  QVERIFY(!presenter.ruleText().isEmpty());
  QCOMPARE(presenter.sweepText(), QStringLiteral("side_shaft_32.csv, 32 readings"));
  QCOMPARE(presenter.beforeAfter().series.size(), 2);
  QCOMPARE(presenter.table().rows.size(), 3);
}

void VerifyExportPresenterTest::limitDecides() {
  OpenDocument open;
  QVERIFY(open.load());
  VerifyPresenter presenter(open.document, open.bench, open.jobs);
  presenter.loadCsv(QString::fromStdString(gui::testing::exampleFile()));
  QVERIFY(QTest::qWaitFor([&] { return open.document.verification().has_value(); }, patienceMs));
  presenter.setLimitDeg(0.01);
  QVERIFY(QTest::qWaitFor([&] { return presenter.verdictText().startsWith("Failed"); }, patienceMs));
  QVERIFY(presenter.outcome() == VerifyPresenter::Outcome::Failed ||
          presenter.outcome() == VerifyPresenter::Outcome::FailedInDoubt);
  presenter.selectModel(1);
  QCOMPARE(open.document.choices().selected.text(), std::string("linear:32"));
}

void VerifyExportPresenterTest::capturesBetweenThePointsOfTheCalibration() {
  OpenDocument open;
  QVERIFY(open.load());
  VerifyPresenter presenter(open.document, open.bench, open.jobs);
  devices::AnglePlan plan = open.document.plan();
  plan.pointsPerTurn = 36;
  plan.startDeg = 2.0;
  plan.turns = 3;
  open.document.setPlan(plan);
  presenter.setPoints(24);
  QCOMPARE(presenter.plan().startDeg, 7.0); // half of 10° further
  QCOMPARE(presenter.plan().pointsPerTurn, 24);
  QCOMPARE(presenter.plan().turns, 1);
  devices::SimulatedAngleSettings settings;
  settings.realTime = false;
  QVERIFY(open.bench.connectSimulated(settings).has_value());
  QCOMPARE(presenter.captureProblem(), QString());
  presenter.capture();
  QCOMPARE(presenter.problem(), QString());
  QVERIFY(presenter.isCapturing());
  QVERIFY(QTest::qWaitFor([&] { return !presenter.isCapturing() && open.document.verification(); }, patienceMs));
  QCOMPARE(open.document.verification()->points, std::size_t{24});
  QCOMPARE(open.document.sweep().size(), std::size_t{32}); // the calibration's own data stay
}

void VerifyExportPresenterTest::saysWhyNothingCanBeCaptured() {
  OpenDocument open;
  VerifyPresenter presenter(open.document, open.bench, open.jobs);
  QVERIFY(presenter.captureProblem().contains("Connect"));
  QVERIFY(presenter.missing().contains("no calibration yet"));
  presenter.capture();
  QVERIFY(!presenter.isCapturing());
}

void VerifyExportPresenterTest::namesAFileThatCannotBeRead() {
  OpenDocument open;
  QVERIFY(open.load());
  VerifyPresenter presenter(open.document, open.bench, open.jobs);
  presenter.loadCsv("/nonexistent/fresh.csv");
  QVERIFY(QTest::qWaitFor([&] { return !presenter.problem().isEmpty(); }, patienceMs));
  QVERIFY(presenter.problem().contains("fresh.csv"));
}

void VerifyExportPresenterTest::exportsWhatIsChosen() {
  const QTemporaryDir folder;
  OpenDocument open;
  AngleExportPresenter presenter(open.document, open.jobs);
  QVERIFY(!presenter.canStart());
  QVERIFY(presenter.missing().contains("nothing to export"));
  QVERIFY(open.load());
  QVERIFY(presenter.canStart());
  QVERIFY(presenter.folder().endsWith("Angle calibration export"));
  presenter.setFolder(folder.filePath("out"));
  presenter.setChoices({.plotsPng = false, .reportPdf = false});
  QCOMPARE(presenter.fileNames(), (QStringList{"calibration.json", "harmonic-4.csv", "linear-32.csv", "lut-64.csv",
                                               "sweep.csv", "comparison.csv"}));
  QCOMPARE(presenter.existing(), QStringList());
  presenter.start();
  QVERIFY(presenter.isRunning());
  QVERIFY(QTest::qWaitFor([&] { return !presenter.isRunning() && !presenter.statusText().isEmpty(); }, patienceMs));
  QVERIFY2(!presenter.failed(), qPrintable(presenter.statusText()));
  QCOMPARE(presenter.written().size(), 6);
  QVERIFY(presenter.statusText().startsWith("6 files written to "));
  for (const QString& name : presenter.written()) {
    QVERIFY2(QFile::exists(folder.filePath("out/" + name)), qPrintable(name));
  }
  QCOMPARE(presenter.existing().size(), 6);
  presenter.setChoices({.calibration = false,
                        .tablesCsv = false,
                        .sweep = false,
                        .comparison = false,
                        .plotsPng = false,
                        .reportPdf = false});
  QVERIFY(!presenter.canStart());                                             // nothing chosen
  QVERIFY(presenter.written().isEmpty() && presenter.statusText().isEmpty()); // not what these choices come to
}

void VerifyExportPresenterTest::exportReportsAFolderThatCannotBeMade() {
  const QTemporaryDir folder;
  QFile blocked(folder.filePath("blocked"));
  QVERIFY(blocked.open(QIODevice::WriteOnly));
  OpenDocument open;
  QVERIFY(open.load());
  AngleExportPresenter presenter(open.document, open.jobs);
  presenter.setFolder(folder.filePath("blocked/out"));
  presenter.setChoices({.plotsPng = false, .reportPdf = false});
  presenter.start();
  QVERIFY(QTest::qWaitFor([&] { return !presenter.isRunning() && !presenter.statusText().isEmpty(); }, patienceMs));
  QVERIFY(presenter.failed());
  QVERIFY(presenter.statusText().contains("blocked"));
  QVERIFY(presenter.written().isEmpty());
}

QTEST_GUILESS_MAIN(VerifyExportPresenterTest)
#include "verify_export_presenter_test.moc"
