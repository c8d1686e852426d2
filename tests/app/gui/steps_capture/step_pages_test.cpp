// The pages themselves: what is shown and enabled when, and that mouse and keyboard reach the presenter.
#include "app/gui/steps/coverage_ring.h"
#include "app/gui/steps/notice_list.h"
#include "app/gui/steps/step_page.h"
#include "tests/app/gui/steps_capture/failing_bench.h"
#include "tests/app/gui/steps_capture/open_calibration.h"
#include "tests/app/gui/steps_capture/test_classes.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>

#include <cmath>

namespace straightedge::gui {

class StepPagesTest : public QObject {
  Q_OBJECT
private slots:
  void connectButtonConnects();
  void captureRunsFromItsButton();
  void captureAsksBeforeReplacing();
  void clickedPointIsMeasuredAgain();
  void faultIsShownWithItsRemedy();
  void reviewSwitchesByClickRectangleAndKeys();
  void reviewCopiesTheTable();
  void reviewWithoutSweepSaysWhereToGetOne();
  void ringFills();
};

namespace {

struct Shown {
  OpenCalibration open;
  std::unique_ptr<StepPage> page;

  explicit Shown(StepPage* (*make)(StepContext, QWidget*))
      : page(make({open.document, open.bench, open.jobs}, nullptr)) {
    page->resize(1000, 700);
    page->show();
    page->entered();
  }
  template <typename T>
  T& find(const char* name) {
    T* child = page->findChild<T*>(QString::fromLatin1(name));
    if (child == nullptr) {
      qFatal("no %s", name);
    }
    return *child;
  }
  void click(const char* name) { QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton); }
};

angle::Sweep importedSweep(int points) {
  angle::Sweep sweep;
  for (int i = 0; i < points; ++i) {
    const double encoder = 360.0 * i / points;
    sweep.encoderDeg.push_back(encoder);
    sweep.sensorDeg.push_back(std::fmod(encoder + 20.0 + 3.0 * std::sin(encoder * 0.034906585), 360.0));
  }
  return sweep;
}

std::ptrdiff_t switchedOff(const AngleDocument& document) {
  return std::count(document.sweep().enabled.begin(), document.sweep().enabled.end(), false);
}

} // namespace

void StepPagesTest::connectButtonConnects() {
  Shown shown(makeConnectStep);
  shown.click("connectBench");
  QVERIFY(shown.open.bench.isConnected());
  QVERIFY(shown.find<QPushButton>("goToCapture").isVisible());
  QSignalSpy readings(&shown.open.bench, &BenchLink::liveReading);
  QVERIFY(readings.wait(60000));
  QSignalSpy leads(shown.page.get(), &StepPage::goToStep);
  shown.click("goToCapture");
  QCOMPARE(leads.first().first().toString(), QStringLiteral("Capture"));
  QSignalSpy details(shown.page.get(), &StepPage::detailsRequested);
  shown.click("editDetails");
  QCOMPARE(details.count(), 1);
  shown.click("connectBench");
  QVERIFY(!shown.open.bench.isConnected());
}

void StepPagesTest::captureRunsFromItsButton() {
  Shown shown(makeCaptureStep);
  QVERIFY(shown.find<QPushButton>("goToConnect").isVisible());
  QVERIFY(!shown.page->missing().isEmpty());
  auto held = std::make_shared<FailingBench>(fastSettings(), 1'000'000);
  QVERIFY(shown.open.bench.connectBench(held->bench(), held).has_value());
  QVERIFY(shown.page->missing().isEmpty());
  shown.open.document.setPlan(planOf(1000));
  QSignalSpy ended(&shown.open.bench, &BenchLink::captureEnded);
  held->hold(); // however slow this thread is, the sweep is not over before it is paused
  shown.click("startCapture");
  QVERIFY(shown.open.bench.isCapturing());
  QVERIFY(shown.find<QPushButton>("pauseCapture").isVisible());
  shown.click("pauseCapture");
  held->letGo();
  QTRY_COMPARE(shown.find<QPushButton>("pauseCapture").text(), QStringLiteral("&Resume"));
  shown.click("pauseCapture");
  QVERIFY(ended.wait(60000));
  QVERIFY(shown.find<QPushButton>("goOn").isVisible());
  QVERIFY(!shown.find<QPushButton>("pauseCapture").isVisible());
  QVERIFY(!shown.find<PlotView>("liveErrorPlot").spec().series[0].x.isEmpty());
}

void StepPagesTest::captureAsksBeforeReplacing() {
  Shown shown(makeCaptureStep);
  QVERIFY(shown.open.connectFast());
  QVERIFY(shown.open.captureToTheEnd(planOf(16)));
  shown.click("startCapture");
  auto* question = shown.page->findChild<QMessageBox*>(QStringLiteral("replaceSweep"));
  QVERIFY(question != nullptr);
  QVERIFY(!shown.open.bench.isCapturing());
  QTest::mouseClick(question->button(QMessageBox::Cancel), Qt::LeftButton);
  QCOMPARE(shown.open.document.sweep().size(), std::size_t{16});
  QVERIFY(!shown.open.bench.isCapturing());
}

void StepPagesTest::clickedPointIsMeasuredAgain() {
  Shown shown(makeCaptureStep);
  QVERIFY(shown.open.connectFast());
  QVERIFY(shown.open.captureToTheEnd(planOf(16)));
  auto& plot = shown.find<PlotView>("liveErrorPlot");
  emit plot.pointClicked(0, 7);
  QVERIFY(shown.find<QPushButton>("redoPoint").isEnabled());
  QSignalSpy ended(&shown.open.bench, &BenchLink::captureEnded);
  shown.click("redoPoint");
  QVERIFY(ended.wait(60000));
  const auto samples = shown.open.document.session()->angleSamples(session::SweepRole::Calibration);
  QVERIFY(samples.has_value());
  QCOMPARE(samples->back().point, 7);
  QCOMPARE(samples->back().attempt, 1);
}

void StepPagesTest::faultIsShownWithItsRemedy() {
  Shown shown(makeCaptureStep);
  auto failing = std::make_shared<FailingBench>(fastSettings(), 10);
  QVERIFY(shown.open.bench.connectBench(failing->bench(), failing).has_value());
  shown.open.document.setPlan(planOf(32));
  shown.click("startCapture");
  auto* notices = shown.page->findChild<NoticeList*>();
  QTRY_VERIFY(!notices->notices().isEmpty());
  QVERIFY(notices->notices().front().text.contains(QStringLiteral("plug it in again")));
  QVERIFY(notices->isVisible());
  QTRY_COMPARE(shown.find<QPushButton>("pauseCapture").text(), QStringLiteral("&Resume"));
  failing->mend();
  QSignalSpy ended(&shown.open.bench, &BenchLink::captureEnded);
  shown.click("pauseCapture");
  QVERIFY(ended.wait(60000));
  QVERIFY(notices->notices().isEmpty());
  QCOMPARE(shown.open.document.sweep().size(), std::size_t{32});
}

void StepPagesTest::reviewSwitchesByClickRectangleAndKeys() {
  Shown shown(makeReviewStep);
  AngleDocument& document = shown.open.document;
  document.setSweep(importedSweep(48), QStringLiteral("import"));
  auto& plot = shown.find<PlotView>("reviewPlot");
  QTRY_VERIFY(!plot.spec().series.isEmpty() && !shown.open.jobs.busy());
  emit plot.pointClicked(0, 12);
  QVERIFY(!document.sweep().isEnabled(12));
  emit plot.pointClicked(0, 12);
  QVERIFY(document.sweep().isEnabled(12));
  emit plot.pointsSelected(0, {3, 4, 5});
  QCOMPARE(switchedOff(document), 3);
  document.undoStack().undo();
  QCOMPARE(switchedOff(document), 0);
  auto& table = shown.find<QTableView>("reviewTable");
  table.selectRow(20);
  QTest::keyClick(&table, Qt::Key_Space);
  QVERIFY(!document.sweep().isEnabled(20));
  QTest::keyClick(&table, Qt::Key_Space);
  QVERIFY(document.sweep().isEnabled(20));
  QTest::keyClick(&table, Qt::Key_Delete);
  QVERIFY(!document.sweep().isEnabled(20));
  shown.click("switchAllOn");
  QCOMPARE(switchedOff(document), 0);
}

void StepPagesTest::reviewCopiesTheTable() {
  Shown shown(makeReviewStep);
  shown.open.document.setSweep(importedSweep(12), QStringLiteral("import"));
  shown.click("copyTable");
  QCOMPARE(QGuiApplication::clipboard()->text().count(QLatin1Char('\n')), 13);
  auto& table = shown.find<QTableView>("reviewTable");
  table.selectRow(4);
  QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
  QCOMPARE(QGuiApplication::clipboard()->text().count(QLatin1Char('\n')), 2);
  QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("\n5\t")));
}

void StepPagesTest::reviewWithoutSweepSaysWhereToGetOne() {
  Shown shown(makeReviewStep);
  QVERIFY(shown.page->missing().contains(QStringLiteral("Capture one, or import")));
  QVERIFY(shown.find<QPushButton>("goToCapture").isVisible());
  QVERIFY(!shown.find<QTableView>("reviewTable").isVisible());
}

void StepPagesTest::ringFills() {
  CoverageRing ring;
  ring.setPlan({0.0, 90.0, 180.0, 270.0}, true);
  QCOMPARE(ring.coveredPercent(), 0);
  ring.measure(0.3, 1);
  ring.measure(359.9, 1); // the same planned point
  ring.measure(449.0, 1);
  QCOMPARE(ring.coveredPercent(), 25);
  ring.measure(180.0, -1);
  ring.measure(270.0, -1);
  QCOMPARE(ring.coveredPercent(), 50);
}

std::unique_ptr<QObject> makeStepPagesTest() { return std::make_unique<StepPagesTest>(); }

} // namespace straightedge::gui

#include "step_pages_test.moc"
