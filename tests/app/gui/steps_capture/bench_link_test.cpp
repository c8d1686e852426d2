#include "app/gui/document/capture_record.h"
#include "devices/instruments/bench_connection.h"
#include "tests/app/gui/steps_capture/failing_bench.h"
#include "tests/app/gui/steps_capture/open_calibration.h"
#include "tests/app/gui/steps_capture/test_classes.h"

#include <QProcess>
#include <QTemporaryDir>

#include <cstdio>
#include <set>

namespace straightedge::gui {

using devices::CaptureState;
using session::SweepRole;

class BenchLinkTest : public QObject {
  Q_OBJECT
private slots:
  void capturesToTheEnd();
  void doesNotStartWithoutBench();
  void refusesBadPlan();
  void pausesAndResumes();
  void stoppedSweepIsResumed();
  void measuresOnePointAgain();
  void unpluggedSensorPausesAndLosesNothing();
  void anInstrumentThatIsBackAndOtherIsToldToo();
  void verificationGoesToItsOwnSweep();
  void liveReadingFollowsTheShaft();
  void disconnectingEndsTheCapture();
  void killedProgramLeavesSweepThatIsResumed();
};

void BenchLinkTest::capturesToTheEnd() {
  OpenCalibration open;
  QVERIFY(open.connectFast());
  QSignalSpy samples(&open.bench, &BenchLink::samplesArrived);
  QVERIFY(open.captureToTheEnd(planOf(64, true, 2)));
  QCOMPARE(open.bench.progress().state, CaptureState::Finished);
  QCOMPARE(open.document.sweep().size(), std::size_t{64 * 2 * 2});
  QCOMPARE(open.bench.liveSamples().size(), std::size_t{64 * 2 * 2});
  QVERIFY(samples.count() > 0);
  QVERIFY(!open.bench.isCapturing());
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
}

void BenchLinkTest::doesNotStartWithoutBench() {
  OpenCalibration open;
  const Result<void> started = open.bench.startCapture(planOf(64), SweepRole::Calibration, false);
  QVERIFY(!started);
  QCOMPARE(QString::fromStdString(started.error().message()),
           QStringLiteral("no bench is connected; connect one in the step Connect"));
}

void BenchLinkTest::refusesBadPlan() {
  OpenCalibration open;
  QVERIFY(open.connectFast());
  QVERIFY(!open.bench.startCapture(planOf(3), SweepRole::Calibration, false));
  QVERIFY(!open.bench.isCapturing());
}

void BenchLinkTest::pausesAndResumes() {
  OpenCalibration open;
  auto held = std::make_shared<FailingBench>(fastSettings(), 5000);
  QVERIFY(open.bench.connectBench(held->bench(), held).has_value());
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  held->hold();
  QVERIFY(open.bench.startCapture(planOf(4000), SweepRole::Calibration, false).has_value());
  open.bench.pauseCapture();
  held->letGo();
  QTRY_COMPARE(open.bench.progress().state, CaptureState::Paused);
  QVERIFY(open.bench.isCapturing());
  QVERIFY(open.bench.progress().pointsDone < 4000);
  QVERIFY(!open.bench.progress().error);
  open.bench.resumeCapture();
  QVERIFY(ended.wait(60000));
  QCOMPARE(open.bench.progress().state, CaptureState::Finished);
  QCOMPARE(open.document.sweep().size(), std::size_t{4000});
}

void BenchLinkTest::stoppedSweepIsResumed() {
  OpenCalibration open;
  auto failing = std::make_shared<FailingBench>(fastSettings(), 300);
  QVERIFY(open.bench.connectBench(failing->bench(), failing).has_value());
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  const devices::AnglePlan plan = planOf(4000);
  QVERIFY(open.bench.startCapture(plan, SweepRole::Calibration, false).has_value());
  QTRY_COMPARE(open.bench.progress().state, CaptureState::Paused);
  open.bench.stopCapture();
  QTRY_COMPARE(ended.count(), 1);
  QCOMPARE(open.document.sweep().size(), std::size_t{300});
  QCOMPARE(open.bench.interruptedPlan(SweepRole::Calibration), std::optional(plan));
  failing->mend();
  QVERIFY(open.captureToTheEnd(plan, SweepRole::Calibration, true));
  QCOMPARE(open.document.sweep().size(), std::size_t{4000});
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
}

void BenchLinkTest::measuresOnePointAgain() {
  OpenCalibration open;
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(planOf(16)));
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  open.bench.redoPoint(5);
  QVERIFY(ended.wait(60000));
  const auto samples = open.document.session()->angleSamples(SweepRole::Calibration);
  QVERIFY(samples.has_value());
  QCOMPARE(samples->size(), std::size_t{17});
  QCOMPARE(samples->back().point, 5);
  QCOMPARE(samples->back().attempt, 1);
  QCOMPARE(open.document.sweep().size(), std::size_t{16}); // only the latest attempt counts
  QCOMPARE(open.document.sweep().sensorDeg[5], samples->back().sensorDeg);
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
}

void BenchLinkTest::unpluggedSensorPausesAndLosesNothing() {
  OpenCalibration open;
  auto failing = std::make_shared<FailingBench>(fastSettings(), 20);
  QVERIFY(open.bench.connectBench(failing->bench(), failing).has_value());
  QSignalSpy failed(&open.bench, &BenchLink::failed);
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  QVERIFY(open.bench.startCapture(planOf(64), SweepRole::Calibration, false).has_value());
  QVERIFY(failed.wait(60000));
  QVERIFY(failed.first().first().toString().contains(QStringLiteral("the sensor was unplugged; plug it in again")));
  QCOMPARE(open.bench.progress().state, CaptureState::Paused);
  QVERIFY(open.bench.progress().error.has_value());
  QCOMPARE(open.document.session()->angleSampleCount(SweepRole::Calibration).value_or(0), std::int64_t{20});
  failing->mend();
  open.bench.resumeCapture();
  QVERIFY(ended.wait(60000));
  QCOMPARE(open.bench.progress().state, CaptureState::Finished);
  QCOMPARE(open.document.sweep().size(), std::size_t{64});
  QCOMPARE(failed.count(), 1);
}

void BenchLinkTest::anInstrumentThatIsBackAndOtherIsToldToo() {
  struct Plug : devices::BenchConnection {
    std::optional<devices::TransportFault> lastFault() const override { return devices::TransportFault::Gone; }
    Result<bool> restore() override {
      return fail(ErrorKind::Instrument, "the sensor is back and has another zero", "begin again");
    }
  };
  OpenCalibration open;
  Plug plug;
  auto failing = std::make_shared<FailingBench>(fastSettings(), 20);
  devices::AngleBench bench = failing->bench();
  bench.connection = &plug;
  QVERIFY(open.bench.connectBench(bench, failing).has_value());
  QSignalSpy failed(&open.bench, &BenchLink::failed);
  QVERIFY(open.bench.startCapture(planOf(64), SweepRole::Calibration, false).has_value());
  QTRY_VERIFY(!failed.isEmpty() && failed.last().first().toString().contains(QStringLiteral("another zero")));
  QVERIFY(failed.count() <= 2); // once each, however often it is looked for; the first may have lasted no frame
  QVERIFY(open.bench.isCapturing());
  open.bench.stopAndWait();
}

void BenchLinkTest::verificationGoesToItsOwnSweep() {
  OpenCalibration open;
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(planOf(32)));
  QVERIFY(open.captureToTheEnd(planOf(24), SweepRole::Verification));
  QCOMPARE(open.document.sweep().size(), std::size_t{32});
  QCOMPARE(open.document.verificationSweep().size(), std::size_t{24});
}

void BenchLinkTest::liveReadingFollowsTheShaft() {
  OpenCalibration open;
  QVERIFY(open.connectFast());
  QSignalSpy readings(&open.bench, &BenchLink::liveReading);
  open.bench.setLiveReading(true);
  QVERIFY(readings.wait(60000));
  QVERIFY(open.bench.canMoveShaft());
  open.bench.moveShaftTo(30.0);
  const auto encoder = [&readings] { return readings.isEmpty() ? -1.0 : readings.last().first().toDouble(); };
  QTRY_VERIFY(std::abs(encoder() - 30.0) < 0.1);
  open.bench.setLiveReading(false);
  QVERIFY(!open.bench.canMoveShaft());
}

void BenchLinkTest::disconnectingEndsTheCapture() {
  OpenCalibration open;
  QVERIFY(open.connectFast());
  QVERIFY(open.bench.startCapture(planOf(4000), SweepRole::Calibration, false).has_value());
  open.bench.disconnectBench();
  QVERIFY(!open.bench.isConnected());
  QVERIFY(!open.bench.isCapturing());
  const auto committed = open.document.session()->angleSampleCount(SweepRole::Calibration).value_or(-1);
  QCOMPARE(static_cast<std::int64_t>(open.document.sweep().size()), committed);
}

void BenchLinkTest::killedProgramLeavesSweepThatIsResumed() {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("killed.sedge"));
  QProcess program;
  program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
  program.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--capture-into"), file});
  QVERIFY(program.waitForReadyRead(60000));
  QVERIFY(program.readAllStandardOutput().contains("captured"));
  program.kill();
  QVERIFY(program.waitForFinished(20000));
  QCOMPARE(program.exitStatus(), QProcess::CrashExit);

  OpenCalibration open;
  QVERIFY(open.document.open(file).has_value());
  const auto left = open.document.session()->angleSampleCount(SweepRole::Calibration).value_or(0);
  QVERIFY(left >= 20);
  const std::optional<devices::AnglePlan> plan = open.bench.interruptedPlan(SweepRole::Calibration);
  QVERIFY(plan.has_value());
  QCOMPARE(plan->pointsPerTurn, 720);
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(*plan, SweepRole::Calibration, true));
  const auto samples = open.document.session()->angleSamples(SweepRole::Calibration);
  QVERIFY(samples.has_value());
  std::set<std::int64_t> sequences;
  std::set<int> points;
  for (const session::AngleSample& sample : *samples) {
    sequences.insert(sample.sequence);
    points.insert(sample.point);
  }
  QCOMPARE(sequences.size(), samples->size());
  QCOMPARE(points.size(), std::size_t{720});
  QCOMPARE(open.document.sweep().size(), std::size_t{720});
}

std::unique_ptr<QObject> makeBenchLinkTest() { return std::make_unique<BenchLinkTest>(); }

int captureUntilKilled(const QString& file) {
  OpenCalibration open;
  devices::SimulatedAngleSettings settings; // in real time: it is killed long before its end
  settings.noiseDeg = 0.01;
  devices::AnglePlan plan = planOf(720);
  plan.settleS = 0.01;
  if (!open.document.saveAs(file) || !open.bench.connectSimulated(settings) ||
      !open.bench.startCapture(plan, SweepRole::Calibration, false)) {
    return 1;
  }
  QObject::connect(&open.bench, &BenchLink::samplesArrived, &open.bench, [&open](int) {
    if (open.document.session()->angleSampleCount(SweepRole::Calibration).value_or(0) >= 20) {
      std::fputs("captured\n", stdout);
      std::fflush(stdout);
    }
  });
  return QCoreApplication::exec();
}

} // namespace straightedge::gui

#include "bench_link_test.moc"
