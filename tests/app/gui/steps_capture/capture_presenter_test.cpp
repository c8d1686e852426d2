#include "app/gui/steps/capture_presenter.h"
#include "tests/app/gui/steps_capture/failing_bench.h"
#include "tests/app/gui/steps_capture/open_calibration.h"
#include "tests/app/gui/steps_capture/test_classes.h"

namespace straightedge::gui {

using Phase = CapturePresenter::Phase;

class CapturePresenterTest : public QObject {
  Q_OBJECT
private slots:
  void needsBench();
  void plansDuration();
  void refusesPlanInWords();
  void runsToTheEnd();
  void pausesResumesStopsAndContinues();
  void redoesMeasuredPointsOnly();
  void faultIsAPhaseOfItsOwn();
  void asksBeforeReplacing();
  void saysWhereTheShaftIsToBeTurned();
};

void CapturePresenterTest::needsBench() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  QCOMPARE(presenter.phase(), Phase::NoBench);
  QVERIFY(!presenter.canStart());
  QVERIFY(open.connectFast());
  QCOMPARE(presenter.phase(), Phase::Ready);
  QVERIFY(presenter.canStart());
}

void CapturePresenterTest::plansDuration() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  devices::AnglePlan plan = planOf(100, true, 3);
  plan.settleS = 0.5;
  presenter.setPlan(plan);
  // 200 points of 0.5 s and 3 readings of 2 ms, and two turns at 360°/s
  QCOMPARE(presenter.plannedDurationS(), 200 * (0.5 + 3 * 0.002) + 2.0);
  QCOMPARE(presenter.planSummary(), QStringLiteral("200 points, 600 readings, about 1 min 43 s"));
  plan.sampleRateHz = 1000.0;
  presenter.setPlan(plan);
  QCOMPARE(presenter.plannedDurationS(), 2.0);
  QVERIFY(presenter.planSummary().startsWith(QStringLiteral("About 2\u202f000 readings")));
}

void CapturePresenterTest::refusesPlanInWords() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  presenter.setPlan(planOf(4));
  QVERIFY(presenter.planProblem().contains(QStringLiteral("number of points per turn is 4")));
  QVERIFY(!presenter.canStart());
}

void CapturePresenterTest::runsToTheEnd() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  presenter.setPlan(planOf(32, true));
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  presenter.start();
  QCOMPARE(presenter.phase(), Phase::Running);
  QVERIFY(presenter.canPause() && presenter.canStop() && !presenter.canStart());
  QVERIFY(ended.wait(60000));
  QCOMPARE(presenter.phase(), Phase::Ready);
  QCOMPARE(presenter.points().measuredPoints(), 64);
  QCOMPARE(presenter.progressFraction(), 1.0);
  QCOMPARE(presenter.progressText(), QStringLiteral("64 of 64 points"));
  QCOMPARE(presenter.samplesText(), QStringLiteral("64 readings"));
  QCOMPARE(presenter.trace().errorPlot().series[0].x.size(), 32);
  QCOMPARE(presenter.trace().errorPlot().series[1].x.size(), 32);
}

void CapturePresenterTest::saysWhereTheShaftIsToBeTurned() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  auto simulated = std::make_shared<devices::SimulatedAngleBench>(devices::SimulatedAngleSettings{});
  devices::AngleBench byHand = simulated->bench();
  byHand.stage = nullptr; // it stands at 0° until somebody turns it
  QVERIFY(open.bench.connectBench(byHand, simulated).has_value());
  devices::AnglePlan plan = planOf(16);
  plan.sampleRateHz = 100.0;
  presenter.setPlan(plan);
  QSignalSpy changed(&presenter, &CapturePresenter::phaseChanged);
  presenter.start();
  QTRY_COMPARE(presenter.guidance(), QStringLiteral("Turn the shaft to below 0°, then steadily to 360°."));
  QVERIFY(changed.count() > 0);
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  presenter.stop();
  QTRY_COMPARE(ended.count(), 1);
}

void CapturePresenterTest::pausesResumesStopsAndContinues() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  auto failing = std::make_shared<FailingBench>(fastSettings(), 1000);
  QVERIFY(open.bench.connectBench(failing->bench(), failing).has_value());
  presenter.setPlan(planOf(4000));
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  failing->hold(); // however slow this thread is, the pause comes before the fault
  presenter.start();
  presenter.pause();
  failing->letGo();
  QTRY_COMPARE(presenter.phase(), Phase::Paused);
  QVERIFY(presenter.canResume());
  presenter.resume();
  QTRY_COMPARE(presenter.phase(), Phase::Faulted); // after a thousand points, however fast the machine is
  presenter.stop();
  QTRY_COMPARE(ended.count(), 1);
  QCOMPARE(presenter.phase(), Phase::Interrupted);
  QVERIFY(presenter.canContinueInterrupted());
  QCOMPARE(presenter.points().measuredPoints(), 1000);
  failing->mend();
  presenter.continueInterrupted();
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, 60000);
  QCOMPARE(presenter.phase(), Phase::Ready);
  QCOMPARE(presenter.points().measuredPoints(), 4000);
}

void CapturePresenterTest::redoesMeasuredPointsOnly() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  QVERIFY(!presenter.canRedo(3));
  QVERIFY(open.captureToTheEnd(planOf(16)));
  QVERIFY(presenter.canRedo(3));
  QVERIFY(!presenter.canRedo(16));
  QVERIFY(!presenter.canRedo(std::nullopt));
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  presenter.redo(3);
  QVERIFY(ended.wait(60000));
  QCOMPARE(presenter.points().data(presenter.points().index(3, CapturePointsModel::State), Qt::DisplayRole).toString(),
           QStringLiteral("1 reading, measured again"));
  QCOMPARE(presenter.trace().errorPlot().series[0].x.size(), 16); // the first attempt is not drawn any more
}

void CapturePresenterTest::faultIsAPhaseOfItsOwn() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  auto failing = std::make_shared<FailingBench>(fastSettings(), 10);
  QVERIFY(open.bench.connectBench(failing->bench(), failing).has_value());
  presenter.setPlan(planOf(32));
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  presenter.start();
  QTRY_COMPARE(presenter.phase(), Phase::Faulted);
  QVERIFY(presenter.problem().contains(QStringLiteral("the sensor was unplugged; plug it in again")));
  QVERIFY(presenter.guidance().contains(QStringLiteral("every reading so far is stored")));
  QCOMPARE(presenter.points().measuredPoints(), 10);
  failing->mend();
  presenter.resume();
  QVERIFY(presenter.problem().isEmpty());
  QVERIFY(ended.wait(60000));
  QCOMPARE(presenter.points().measuredPoints(), 32);
}

void CapturePresenterTest::asksBeforeReplacing() {
  OpenCalibration open;
  CapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  QVERIFY(!presenter.startReplacesData());
  QVERIFY(open.captureToTheEnd(planOf(16)));
  QVERIFY(presenter.startReplacesData());
  QVERIFY(presenter.replaceQuestion().contains(QStringLiteral("16 readings")));
}

std::unique_ptr<QObject> makeCapturePresenterTest() { return std::make_unique<CapturePresenterTest>(); }

} // namespace straightedge::gui

#include "capture_presenter_test.moc"
