// From the start page to exported files by mouse and keyboard: the truth of the simulated bench has to come back.
#include "app/gui/shell/program_start.h"
#include "core/angle/angles.h"
#include "tests/app/gui/end_to_end/exported_files.h"
#include "tests/app/gui/end_to_end/quiet_prompts.h"
#include "tests/app/gui/end_to_end/window_driver.h"

#include <QApplication>
#include <QComboBox>
#include <QDirIterator>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace straightedge::gui {

namespace {

// Typed into Compare and Verify.
constexpr double targetErrorDeg = 0.1;
constexpr double limitDeg = 0.25;
constexpr int waitMs = 120000;

const angle::Model* selectedModel(const AngleDocument& document) {
  for (const angle::Model& model : document.run()->result.models) {
    if (model.name == document.choices().selected) {
      return &model;
    }
  }
  return nullptr;
}

/// Largest error of the corrected angle over the turn, against the bench's truth.
double largestTrueErrorDeg(const AngleDocument& document, const BenchLink& bench) {
  const devices::SimulatedAngleBench truth(bench.simulatedSettings());
  const angle::Model* model = selectedModel(document);
  double largest = 0.0;
  for (int i = 0; i < 7200; ++i) {
    const double reading = 0.05 * i;
    const double error = angle::wrap180(model->correctionDeg(reading) - truth.trueCorrectionDeg(reading));
    largest = std::max(largest, std::abs(error));
  }
  return largest;
}

} // namespace

class WholeWayTest : public QObject {
  Q_OBJECT
private slots:
  void init();
  void cleanup();
  void simulatedBenchToExport_data();
  void simulatedBenchToExport();

private:
  void connectBench(const QString& geometry, bool decreasing);
  void capture();
  void review();
  void fitAndCompare();
  void verify();
  void exportTo(const QString& folder);

  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<WindowDriver> m_driver;
};

void WholeWayTest::init() {
  m_window = std::make_unique<MainWindow>(std::make_unique<QuietPrompts>());
  m_driver = std::make_unique<WindowDriver>(*m_window);
  m_window->resize(1280, 800);
  m_window->show();
  QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void WholeWayTest::cleanup() {
  m_driver.reset();
  m_window.reset();
}

void WholeWayTest::connectBench(const QString& geometry, bool decreasing) {
  m_driver->click(QStringLiteral("startSimulated"));
  QVERIFY(m_window->bench().isConnected());
  m_driver->step(QStringLiteral("Connect"));
  m_driver->click(QStringLiteral("connectBench")); // disconnects the one in real time
  QVERIFY(!m_window->bench().isConnected());
  m_driver->choose(QStringLiteral("geometry"), geometry);
  m_driver->choose(QStringLiteral("speed"), QStringLiteral("As fast as possible"));
  m_driver->typeNumber(QStringLiteral("seed"), QStringLiteral("7"));
  if (decreasing) {
    m_driver->click(QStringLiteral("decreasing"));
  }
  QSignalSpy readings(&m_window->bench(), &BenchLink::liveReading);
  m_driver->click(QStringLiteral("connectBench"));
  QVERIFY(m_window->bench().isConnected());
  QVERIFY(!m_window->bench().simulatedSettings().realTime);
  QCOMPARE(m_window->bench().simulatedSettings().seed, std::uint64_t{7});
  QVERIFY(readings.wait(waitMs));
  m_driver->click(QStringLiteral("takeOverInstruments"));
  QVERIFY(!m_window->document().traceability().deviceSerial.empty());
  m_driver->click(QStringLiteral("goToCapture"));
}

void WholeWayTest::capture() {
  m_driver->typeNumber(QStringLiteral("pointsPerTurn"), QStringLiteral("96"));
  m_driver->typeNumber(QStringLiteral("averages"), QStringLiteral("4"));
  m_driver->click(QStringLiteral("bothDirections"));
  QCOMPARE(m_window->document().plan().pointsPerTurn, 96);
  QSignalSpy ended(&m_window->bench(), &BenchLink::captureEnded);
  m_driver->click(QStringLiteral("startCapture"));
  QVERIFY(ended.count() > 0 || ended.wait(waitMs));
  QCOMPARE(m_window->document().sweep().size(), std::size_t{96 * 4 * 2});
  QTRY_VERIFY_WITH_TIMEOUT(m_window->document().run() != nullptr, waitMs);
  m_driver->click(QStringLiteral("goOn"));
}

void WholeWayTest::review() {
  AngleDocument& document = m_window->document();
  auto* plot = m_driver->find<PlotView>(QStringLiteral("reviewPlot"));
  QTRY_VERIFY_WITH_TIMEOUT(!plot->spec().series.isEmpty() && !m_window->jobs().busy(), waitMs);
  QCoreApplication::processEvents();
  m_driver->clickPoint(*plot, 0, 20);
  const auto off = [&document] {
    const auto& enabled = document.sweep().enabled;
    return std::count(enabled.begin(), enabled.end(), false);
  };
  QCOMPARE(off(), 1);
  m_driver->undo();
  QCOMPARE(off(), 0);
  QTRY_VERIFY_WITH_TIMEOUT(!m_window->jobs().busy(), waitMs);
  m_driver->click(QStringLiteral("goToFit"));
}

void WholeWayTest::fitAndCompare() {
  AngleDocument& document = m_window->document();
  QVERIFY(!document.run()->result.models.empty());
  m_driver->click(QStringLiteral("goToCompare"));
  QTRY_VERIFY_WITH_TIMEOUT(document.comparisonComplete(), waitMs);
  auto* plot = m_driver->find<PlotView>(QStringLiteral("comparisonPlot"));
  QTRY_VERIFY(!plot->spec().series.isEmpty());
  QSignalSpy painted(plot, &PlotView::painted);
  plot->update();
  QVERIFY(painted.wait(waitMs));

  const double before = document.choices().targetErrorDeg;
  m_driver->dragGuide(*plot, QStringLiteral("target"), before * 2.0);
  QVERIFY(document.choices().targetErrorDeg > before * 1.8 && document.choices().targetErrorDeg < before * 2.2);

  const angle::ModelName chosenBefore = document.choices().selected;
  const QList<PlotSeries> series = plot->spec().series;
  const auto linear = std::find_if(series.begin(), series.end(), [](const PlotSeries& each) {
    return each.name.startsWith(QStringLiteral("Linear"));
  });
  QVERIFY(linear != series.end());
  m_driver->clickPoint(*plot, static_cast<int>(linear - series.begin()), 3);
  QVERIFY(document.choices().selected != chosenBefore);

  m_driver->typeNumber(QStringLiteral("targetError"), QString::number(targetErrorDeg));
  QCOMPARE(document.choices().targetErrorDeg, targetErrorDeg);
  m_driver->click(QStringLiteral("targetUse"));
  QTRY_VERIFY_WITH_TIMEOUT(!m_window->jobs().busy() && selectedModel(document) != nullptr, waitMs);
  QVERIFY(selectedModel(document)->errors.maxCurveDeg <= targetErrorDeg);
  m_driver->click(QStringLiteral("goToVerify"));
}

void WholeWayTest::verify() {
  AngleDocument& document = m_window->document();
  m_driver->typeNumber(QStringLiteral("verifyLimit"), QString::number(limitDeg));
  QCOMPARE(document.choices().limitDeg, limitDeg);
  QSignalSpy verified(&document, &AngleDocument::verificationChanged);
  m_driver->click(QStringLiteral("captureVerification"));
  QTRY_VERIFY_WITH_TIMEOUT(document.verification().has_value(), waitMs);
  QVERIFY(document.verification()->met);
  QVERIFY(document.verification()->maxErrorBeforeDeg > 1.0);
  QVERIFY(!m_driver->find<QLabel>(QStringLiteral("verdictWord"))->text().isEmpty());
  m_driver->click(QStringLiteral("goToExport"));
}

void WholeWayTest::exportTo(const QString& folder) {
  m_driver->typeText(QStringLiteral("exportFolder"), folder);
  QTRY_VERIFY_WITH_TIMEOUT(!m_window->jobs().busy(), waitMs);
  m_driver->click(QStringLiteral("startExport"));
  QTRY_VERIFY_WITH_TIMEOUT(m_driver->isShown(QStringLiteral("openFolder")) && !m_window->jobs().busy(), waitMs);
  QFile calibration(QDir(folder).filePath(QStringLiteral("calibration.json")));
  QVERIFY(calibration.open(QIODevice::ReadOnly));
  const QJsonObject written = QJsonDocument::fromJson(calibration.readAll()).object();
  QCOMPARE(written.value(QStringLiteral("format")).toString(), QStringLiteral("straightedge-calibration"));
  QCOMPARE(written.value(QStringLiteral("device")).toObject().value(QStringLiteral("serial")).toString(),
           QString::fromStdString(m_window->document().traceability().deviceSerial));
  int files = 0;
  for (QDirIterator all(folder, QDir::Files, QDirIterator::Subdirectories); all.hasNext(); ++files) {
    const QString file = all.next();
    QVERIFY2(parses(file), qPrintable(file));
  }
  QVERIFY(files >= 4); // calibration, a table per model, comparison
}

void WholeWayTest::simulatedBenchToExport_data() {
  QTest::addColumn<QString>("geometry");
  QTest::addColumn<bool>("decreasing");
  QTest::newRow("beside the shaft") << QStringLiteral("Beside") << false;
  QTest::newRow("end of the shaft, backwards") << QStringLiteral("End") << true;
}

void WholeWayTest::simulatedBenchToExport() {
  QFETCH(QString, geometry);
  QFETCH(bool, decreasing);
  const QTemporaryDir folder;
  connectBench(geometry, decreasing);
  for (const auto step :
       {&WholeWayTest::capture, &WholeWayTest::review, &WholeWayTest::fitAndCompare, &WholeWayTest::verify}) {
    if (QTest::currentTestFailed()) {
      return;
    }
    (this->*step)();
  }
  if (QTest::currentTestFailed()) {
    return;
  }
  const double error = largestTrueErrorDeg(m_window->document(), m_window->bench());
  QVERIFY2(error <= limitDeg, qPrintable(QString::number(error)));
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
  straightedge::gui::WholeWayTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "whole_way_test.moc"
