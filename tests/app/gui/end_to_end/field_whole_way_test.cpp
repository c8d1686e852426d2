// A field calibration from the start page to the exported report by mouse and keyboard: the truth of the simulated
// bench has to come back.
#include "app/gui/figures/field_figure_parts.h"
#include "app/gui/shell/field_workspace.h"
#include "app/gui/shell/program_start.h"
#include "core/field/chain.h"
#include "tests/app/gui/end_to_end/exported_files.h"
#include "tests/app/gui/end_to_end/quiet_prompts.h"
#include "tests/app/gui/end_to_end/window_driver.h"

#include <QApplication>
#include <QDirIterator>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <cmath>

namespace straightedge::gui {

namespace {

// Typed into Verify.
constexpr double limitPercent = 0.03;
constexpr int waitMs = 240000;

/// Largest error of corrected readings in percent of full scale, against the bench's truth, in fields and at
/// temperatures that were not measured at.
double largestTrueErrorPercent(const FieldDocument& document, const devices::HallProbe& truth) {
  const field::CorrectionChain& chain = document.run()->result.chain;
  const auto applied = field::AppliedChain::prepare(chain);
  double largest = 0.0;
  for (int i = 0; i < 500; ++i) {
    const double turn = 0.37 * i;
    const double size = 1.9 * std::sin(0.11 * i + 0.3);
    const Eigen::Vector3d fieldT = size * Eigen::Vector3d(std::sin(turn) * std::cos(1.7 * turn),
                                                          std::sin(turn) * std::sin(1.7 * turn), std::cos(turn));
    const double probeC = 24.0 + 5.0 * std::sin(0.23 * i);
    const double electronicsC = 25.0 + 6.0 * std::cos(0.31 * i);
    const Eigen::Vector3d raw = truth.idealReadingT(fieldT, probeC, electronicsC);
    const Eigen::Vector3d corrected =
        applied->correct({truth.idealPt100Ohm(probeC), electronicsC, {raw.x(), raw.y(), raw.z()}});
    largest = std::max(largest, (corrected - fieldT).cwiseAbs().maxCoeff());
  }
  return 100.0 * largest / chain.fullScaleT;
}

} // namespace

class FieldWholeWayTest : public QObject {
  Q_OBJECT
private slots:
  void init();
  void cleanup();
  void simulatedBenchToReport();

private:
  FieldDocument& document() { return m_window->field().document(); }
  FieldBenchLink& bench() { return m_window->field().bench(); }
  void connectBench();
  void capture();
  void review();
  void fitAndCompare();
  void verify();
  void exportTo(const QString& folder);

  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<WindowDriver> m_driver;
};

void FieldWholeWayTest::init() {
  m_window = std::make_unique<MainWindow>(std::make_unique<QuietPrompts>());
  m_driver = std::make_unique<WindowDriver>(*m_window);
  m_window->resize(1280, 800);
  m_window->show();
  QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void FieldWholeWayTest::cleanup() {
  m_driver.reset();
  m_window.reset();
}

void FieldWholeWayTest::connectBench() {
  m_driver->click(QStringLiteral("startSimulatedField"));
  QVERIFY(bench().isConnected());
  m_driver->step(QStringLiteral("Connect"));
  m_driver->click(QStringLiteral("connectBench")); // disconnects the one with the usual settings
  QVERIFY(!bench().isConnected());
  m_driver->choose(QStringLiteral("speed"), QStringLiteral("As fast as possible"));
  m_driver->typeNumber(QStringLiteral("seed"), QStringLiteral("7"));
  m_driver->choose(QStringLiteral("placing"), QStringLiteral("By hand"));
  QSignalSpy readings(&bench(), &FieldBenchLink::liveReading);
  m_driver->click(QStringLiteral("connectBench"));
  QVERIFY(bench().isConnected());
  QVERIFY(bench().simulatedSettings().byHand);
  QVERIFY(!bench().inRealTime());
  QCOMPARE(bench().simulatedSettings().seed, std::uint64_t{7});
  QVERIFY(readings.wait(waitMs));
  m_driver->click(QStringLiteral("takeOverInstruments"));
  QVERIFY(!document().traceability().deviceSerial.empty());
  m_driver->click(QStringLiteral("goToCapture"));
}

void FieldWholeWayTest::capture() {
  m_driver->typeNumber(QStringLiteral("fieldStep"), QStringLiteral("0.2"));
  m_driver->typeNumber(QStringLiteral("plateauRows"), QStringLiteral("4"));
  m_driver->typeNumber(QStringLiteral("sweepRows"), QStringLiteral("60"));
  m_driver->typeNumber(QStringLiteral("rowTime"), QStringLiteral("4"));
  QCOMPARE(document().plan().stages.front().fieldsT.size(), std::size_t{20});
  auto* stages = m_driver->find<QTreeWidget>(QStringLiteral("captureStages"));
  QCOMPARE(stages->topLevelItemCount(), 21);
  QSignalSpy ended(&bench(), &FieldBenchLink::captureEnded);
  m_driver->click(QStringLiteral("startCapture"));
  int placed = 0;
  const auto placeUntilTheEnd = [&] { // the probe is placed by hand, as often as the campaign asks for it
    if (ended.isEmpty() && m_driver->isShown(QStringLiteral("confirmStage"))) {
      const QString asked = m_driver->find<QLabel>(QStringLiteral("stageInstruction"))->text();
      if (asked.startsWith(QStringLiteral("P"))) {
        ++placed;
        m_driver->click(QStringLiteral("confirmStage"));
      }
    }
    return !ended.isEmpty();
  };
  QVERIFY(QTest::qWaitFor(placeUntilTheEnd, waitMs));
  QVERIFY(placed >= 18); // x y z, zero field, x y z, zero field, x y z, six orientations, x y z
  QCOMPARE(stages->topLevelItem(20)->text(1), QStringLiteral("done"));
  // One stage once more, by keyboard
  ended.clear();
  stages->setFocus();
  stages->setCurrentItem(stages->topLevelItem(4));
  QTest::keyClick(stages, Qt::Key_F5);
  QVERIFY(QTest::qWaitFor(placeUntilTheEnd, waitMs));
  QCOMPARE(stages->topLevelItem(4)->text(3), QStringLiteral("no. 2"));
  QTRY_VERIFY_WITH_TIMEOUT(document().run() != nullptr, waitMs);
  m_driver->click(QStringLiteral("goOn"));
}

void FieldWholeWayTest::review() {
  auto* stages = m_driver->find<QTreeWidget>(QStringLiteral("stages"));
  QTRY_VERIFY_WITH_TIMEOUT(!m_window->jobs().busy(), waitMs);
  stages->setFocus();
  stages->setCurrentItem(stages->topLevelItem(0)->child(3));
  QTest::keyClick(stages, Qt::Key_Delete);
  QVERIFY(std::ranges::count(document().rowsEnabled(), false) >= 4);
  m_driver->undo();
  QCOMPARE(std::ranges::count(document().rowsEnabled(), false), 0);
  QTRY_VERIFY_WITH_TIMEOUT(!m_window->jobs().busy(), waitMs);
  m_driver->click(QStringLiteral("goToFit"));
}

void FieldWholeWayTest::fitAndCompare() {
  QVERIFY(document().run()->result.warnings.empty()); // every block was measured
  m_driver->click(QStringLiteral("goToCompare"));
  QTRY_VERIFY_WITH_TIMEOUT(document().comparison() != nullptr && !m_window->jobs().busy(), waitMs);
  m_driver->click(QStringLiteral("goToVerify"));
}

void FieldWholeWayTest::verify() {
  m_driver->typeNumber(QStringLiteral("fieldLimit"), QString::number(limitPercent));
  QCOMPARE(document().choices().limitPercent, limitPercent);
  QSignalSpy ended(&bench(), &FieldBenchLink::captureEnded);
  m_driver->click(QStringLiteral("captureVerification")); // shows Capture, where it is guided
  const auto placeUntilTheEnd = [&] {
    if (ended.isEmpty() && m_driver->isShown(QStringLiteral("confirmStage"))) {
      m_driver->click(QStringLiteral("confirmStage"));
    }
    return !ended.isEmpty();
  };
  QVERIFY(QTest::qWaitFor(placeUntilTheEnd, waitMs));
  QTRY_VERIFY_WITH_TIMEOUT(document().verificationIsFresh() && !m_window->jobs().busy(), waitMs);
  m_driver->click(QStringLiteral("goOn"));
  QCOMPARE(m_driver->find<QLabel>(QStringLiteral("verdictWord"))->text(), QStringLiteral("Passed"));
  QVERIFY(document().verification()->met);
  QVERIFY(document().verification()->peakBeforePercent > 1.0);
  m_driver->click(QStringLiteral("goToExport"));
}

void FieldWholeWayTest::exportTo(const QString& folder) {
  m_driver->typeText(QStringLiteral("exportFolder"), folder);
  m_driver->click(QStringLiteral("exportReportHtml"));
  QTRY_VERIFY_WITH_TIMEOUT(!m_window->jobs().busy(), waitMs);
  m_driver->click(QStringLiteral("startExport"));
  QTRY_VERIFY_WITH_TIMEOUT(m_driver->isShown(QStringLiteral("openFolder")) && !m_window->jobs().busy(), waitMs);
  QFile calibration(QDir(folder).filePath(QStringLiteral("calibration.json")));
  QVERIFY(calibration.open(QIODevice::ReadOnly));
  const QJsonObject written = QJsonDocument::fromJson(calibration.readAll()).object();
  QCOMPARE(written.value(QStringLiteral("kind")).toString(), QStringLiteral("field"));
  QCOMPARE(written.value(QStringLiteral("device")).toObject().value(QStringLiteral("serial")).toString(),
           QString::fromStdString(document().traceability().deviceSerial));
  QFile report(QDir(folder).filePath(QStringLiteral("report.html")));
  QVERIFY(report.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(report.readAll());
  QVERIFY(text.contains(QStringLiteral("SIM-H")) && text.contains(QStringLiteral("SIM-N")));
  // The figures that Verify shows are those of the report.
  const field::LimitReport& verified = *document().verification();
  for (const field::VerificationRow& row : verified.verification.rows) {
    const QString peak = peopleNumber(row.ofFullScale.peak);
    QVERIFY2(text.contains(peak), qPrintable(peak));
  }
  int files = 0;
  for (QDirIterator all(folder, QDir::Files, QDirIterator::Subdirectories); all.hasNext(); ++files) {
    const QString file = all.next();
    QVERIFY2(parses(file), qPrintable(file));
  }
  QVERIFY(files >= 10); // calibration, tables, campaign, report twice, plots
}

void FieldWholeWayTest::simulatedBenchToReport() {
  const QTemporaryDir folder;
  for (const auto step : {&FieldWholeWayTest::connectBench, &FieldWholeWayTest::capture, &FieldWholeWayTest::review,
                          &FieldWholeWayTest::fitAndCompare, &FieldWholeWayTest::verify}) {
    (this->*step)();
    if (QTest::currentTestFailed()) {
      return;
    }
  }
  const devices::SimulatedFieldBench truth(bench().simulatedSettings());
  const double error = largestTrueErrorPercent(document(), truth.truth());
  QVERIFY2(error <= 2.0 * limitPercent, qPrintable(QString::number(error))); // vectors: all axes at once
  QVERIFY(error > 0.0);
  exportTo(folder.path());
}

} // namespace straightedge::gui

int main(int argc, char** argv) {
  QTemporaryDir home; // scratch files and settings of the test, never the user's
  qputenv("XDG_DATA_HOME", home.path().toUtf8());
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  qputenv("HOME", home.path().toUtf8());
  QApplication application(argc, argv);
  straightedge::gui::prepareApplication(application);
  straightedge::gui::FieldWholeWayTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "field_whole_way_test.moc"
