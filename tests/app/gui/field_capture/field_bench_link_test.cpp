#include "app/gui/document/capture_record.h"
#include "tests/app/gui/field_capture/open_campaign.h"
#include "tests/app/gui/field_capture/test_classes.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <cstdio>
#include <mutex>
#include <set>

namespace straightedge::gui {

using devices::CaptureState;
using field::CampaignStep;
using session::SweepRole;

class FieldBenchLinkTest : public QObject {
  Q_OBJECT
private slots:
  void capturesToTheEnd();
  void sameSeedGivesTheSameCampaign();
  void doesNotStartWithoutBench();
  void refusesBadPlan();
  void failingInstrumentPausesAndLosesNothing();
  void waitsForTheHandAndStopsThere();
  void leftOutStagesAreNotMeasured();
  void leavesOutBeforeAndAfter();
  void measuresOneStageAgain();
  void freshCampaignGoesToItsOwnRows();
  void liveReadingFollowsMagnetAndCarrier();
  void disconnectingEndsTheCapture();
  void goesOnOnlyOnTheBenchItBeganOn();
  void commandLineGoesOnWithTheWindowsCampaign();
  void windowGoesOnWithTheCommandLinesCampaign();
  void killedProgramLeavesCampaignThatIsResumed();

private:
  static int cli(const QStringList& arguments) {
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.setStandardOutputFile(QProcess::nullDevice());
    program.start(QStringLiteral(STRAIGHTEDGE_BINARY_DIR "/straightedge-cli"), arguments);
    return program.waitForFinished(captureWaitMs) && program.exitStatus() == QProcess::NormalExit ? program.exitCode()
                                                                                                  : -1;
  }
};

namespace {

/// In real time: killed long before its end, but not before its first row.
devices::FieldPlan planToBeKilledIn() {
  devices::FieldPlan plan = twoOrientations();
  plan.settleS = 0.01;
  plan.temperatureSettleS = 0.0;
  return plan;
}

class MemorySink : public session::FieldSampleSink {
public:
  Result<void> append(std::span<const session::FieldSample> samples) override {
    const std::scoped_lock lock(m_mutex);
    m_samples.insert(m_samples.end(), samples.begin(), samples.end());
    return {};
  }
  Result<void> recordGap(const session::SampleGap&) override { return {}; }
  Result<void> commit() override { return {}; }
  const std::vector<session::FieldSample>& samples() const { return m_samples; } ///< after the capture

private:
  std::mutex m_mutex;
  std::vector<session::FieldSample> m_samples;
};

std::size_t distinctSequences(const std::vector<session::FieldSample>& samples) {
  std::set<std::int64_t> sequences;
  for (const session::FieldSample& sample : samples) {
    sequences.insert(sample.sequence);
  }
  return sequences.size();
}

} // namespace

void FieldBenchLinkTest::capturesToTheEnd() {
  OpenCampaign open;
  QVERIFY(open.connectFast());
  QSignalSpy samples(&open.bench, &FieldBenchLink::samplesArrived);
  QVERIFY(open.captureToTheEnd(smallCampaign()));
  QCOMPARE(open.bench.progress().state, CaptureState::Finished);
  QCOMPARE(open.bench.progress().pointsDone, open.bench.progress().pointsPlanned);
  QCOMPARE(open.document.campaign().rows.size(), open.stored().size());
  QCOMPARE(open.bench.liveSamples(), open.stored());
  QVERIFY(open.document.isCaptured());
  QVERIFY(samples.count() > 0);
  QVERIFY(!open.bench.isCapturing());
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
}

void FieldBenchLinkTest::sameSeedGivesTheSameCampaign() {
  OpenCampaign open;
  QVERIFY(open.connectFast());
  QSignalSpy readings(&open.bench, &FieldBenchLink::liveReading);
  open.bench.setLiveReading(true); // takes from the noise, which the campaign begins anew with
  QVERIFY(readings.wait(captureWaitMs));
  const devices::FieldPlan plan = twoOrientations();
  QVERIFY(open.captureToTheEnd(plan));
  devices::SimulatedFieldBench alone(fastField());
  MemorySink sink;
  devices::FieldCapture capture(alone.bench(), sink);
  QVERIFY(capture.start(plan).has_value());
  capture.waitUntilDone();
  QCOMPARE(open.stored(), sink.samples());
}

void FieldBenchLinkTest::doesNotStartWithoutBench() {
  OpenCampaign open;
  const Result<void> started = open.bench.startCapture(smallCampaign(), SweepRole::Calibration, false);
  QVERIFY(!started);
  QCOMPARE(QString::fromStdString(started.error().message()),
           QStringLiteral("no bench is connected; connect one in the step Connect"));
  devices::FieldBench empty;
  QVERIFY(!open.bench.connectBench(empty, nullptr));
}

void FieldBenchLinkTest::refusesBadPlan() {
  OpenCampaign open;
  QVERIFY(open.connectFast());
  devices::FieldPlan plan = twoOrientations();
  plan.stages.front().rowS = -1.0;
  QVERIFY(!open.bench.startCapture(plan, SweepRole::Calibration, false));
  QVERIFY(!open.bench.isCapturing());
}

void FieldBenchLinkTest::failingInstrumentPausesAndLosesNothing() {
  OpenCampaign open;
  auto failing = std::make_shared<FailingFieldBench>(7);
  QVERIFY(open.bench.connectBench(failing->bench(), failing).has_value());
  QVERIFY(!open.bench.isSimulated());
  QSignalSpy failed(&open.bench, &FieldBenchLink::failed);
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  const devices::FieldPlan plan = twoOrientations();
  QVERIFY(open.bench.startCapture(plan, SweepRole::Calibration, false).has_value());
  QTRY_COMPARE(open.bench.progress().state, CaptureState::Paused);
  QVERIFY(failed.first().first().toString().contains(QStringLiteral("the teslameter was switched off; switch it on")));
  QCOMPARE(open.document.session()->fieldSampleCount(SweepRole::Calibration).value_or(0), std::int64_t{7});
  open.bench.stopCapture();
  QTRY_COMPARE(ended.count(), 1);
  QCOMPARE(open.bench.interruptedPlan(SweepRole::Calibration), std::optional(plan));
  failing->mend();
  QVERIFY(open.captureToTheEnd(plan, SweepRole::Calibration, true));
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
  const auto samples = open.stored();
  QCOMPARE(distinctSequences(samples), samples.size());
  QCOMPARE(std::ranges::count(samples, true, &session::FieldSample::locked), 2 * 3 * 3);
}

void FieldBenchLinkTest::waitsForTheHandAndStopsThere() {
  OpenCampaign open;
  QVERIFY(open.connectFast(true));
  const devices::FieldPlan plan = twoOrientations();
  QVERIFY(open.bench.startCapture(plan, SweepRole::Calibration, false).has_value());
  QVERIFY(open.waitsFor("place the probe with its +x axis along the field"));
  open.bench.confirm();
  QVERIFY(open.waitsFor("place the probe with its -x axis along the field"));
  QCOMPARE(open.bench.progress().stages.at(0).pointsDone, 3);
  open.bench.stopAndWait();
  QVERIFY(!open.bench.isCapturing());
  QCOMPARE(open.bench.interruptedPlan(SweepRole::Calibration), std::optional(plan));
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  QVERIFY(open.bench.startCapture(plan, SweepRole::Calibration, true).has_value());
  QVERIFY(open.waitsFor("place the probe with its -x axis along the field"));
  open.bench.confirm();
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  for (const session::FieldSample& sample : open.stored()) { // the hand has turned the simulated probe
    QVERIFY(!sample.locked || (sample.rawT[0] > 0.0) == (sample.stage == 0));
  }
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
}

void FieldBenchLinkTest::leftOutStagesAreNotMeasured() {
  OpenCampaign open;
  QVERIFY(open.connectFast(true));
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  QVERIFY(open.bench.startCapture(twoOrientations(), SweepRole::Calibration, false).has_value());
  QVERIFY(open.waitsFor("place the probe with its +x axis along the field"));
  open.bench.skipStage(0, true);
  QVERIFY(open.waitsFor("place the probe with its -x axis along the field"));
  QVERIFY(readFieldCaptureRecord(*open.document.session(), SweepRole::Calibration)->plan.stages[0].skipped);
  open.bench.confirm();
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QCOMPARE(open.bench.progress().state, CaptureState::Finished);
  for (const session::FieldSample& sample : open.stored()) {
    QCOMPARE(sample.stage, 1);
  }
  QVERIFY(readFieldCaptureRecord(*open.document.session(), SweepRole::Calibration)->finished);
}

void FieldBenchLinkTest::leavesOutBeforeAndAfter() {
  OpenCampaign open;
  open.document.setPlan(twoOrientations());
  open.bench.skipStage(1, true); // of the plan: nothing was measured yet
  QVERIFY(open.document.plan().stages[1].skipped);
  open.document.undoStack().undo();
  QVERIFY(!open.document.plan().stages[1].skipped);
  open.bench.skipStage(1, true);
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(open.document.plan()));
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
  open.bench.skipStage(1, false); // taken back in: now something is missing
  const auto interrupted = open.bench.interruptedPlan(SweepRole::Calibration);
  QVERIFY(interrupted);
  QVERIFY(!interrupted->stages[1].skipped);
  open.bench.skipStage(1, true);
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
  QSignalSpy failed(&open.bench, &FieldBenchLink::failed);
  open.bench.skipStage(0, true); // then nothing would be left
  QCOMPARE(failed.count(), 1);
  QVERIFY(!readFieldCaptureRecord(*open.document.session(), SweepRole::Calibration)->plan.stages[0].skipped);
}

void FieldBenchLinkTest::measuresOneStageAgain() {
  OpenCampaign open;
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(twoOrientations()));
  const std::size_t before = open.stored().size();
  const std::size_t rows = open.document.campaign().rows.size();
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  open.bench.redoStage(1);
  QVERIFY(ended.wait(captureWaitMs));
  const auto samples = open.stored();
  QVERIFY(samples.size() > before);
  for (std::size_t i = before; i < samples.size(); ++i) {
    QCOMPARE(samples[i].stage, 1);
    QCOMPARE(samples[i].attempt, 1);
  }
  QVERIFY(samples[before].rawT != samples[before - 1].rawT); // the noise goes on
  QVERIFY(open.document.campaign().rows.size() <= rows + 1); // only the latest attempt counts
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
}

void FieldBenchLinkTest::freshCampaignGoesToItsOwnRows() {
  OpenCampaign open;
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(twoOrientations()));
  const std::size_t rows = open.document.campaign().rows.size();
  const std::string plan = *open.document.session()->document("plan");
  devices::FieldPlan fresh = smallCampaign({CampaignStep::Verification});
  fresh.stages.resize(1);
  QVERIFY(open.captureToTheEnd(fresh, SweepRole::Verification));
  QCOMPARE(open.document.campaign().rows.size(), rows);
  QVERIFY(!open.document.verificationCampaign().rows.empty());
  QCOMPARE(open.document.verificationCampaign().rows.size(), open.stored(SweepRole::Verification).size());
  QCOMPARE(*open.document.session()->document("plan"), plan); // the calibration's
}

void FieldBenchLinkTest::liveReadingFollowsMagnetAndCarrier() {
  OpenCampaign open;
  QVERIFY(open.connectFast());
  QVERIFY(!open.bench.canSetField());
  QSignalSpy readings(&open.bench, &FieldBenchLink::liveReading);
  open.bench.setLiveReading(true);
  QVERIFY(readings.wait(captureWaitMs));
  const auto last = [&readings] { return readings.last().first().value<FieldLiveReading>(); };
  QVERIFY(!last().locked); // in the zero-field chamber
  QVERIFY(std::abs(last().rawT[0]) < 1e-3);
  QVERIFY(last().pt100Ohm && std::abs(*last().pt100Ohm - 109.24) < 0.5);
  QVERIFY(last().electronicsC && std::abs(*last().electronicsC - 24.0) < 0.5);
  QVERIFY(last().probeChamberC && last().electronicsChamberC);
  QVERIFY(open.bench.canSetField() && open.bench.canPlaceProbe());
  open.bench.placeProbe(devices::ProbePlacement::PlusY);
  open.bench.setFieldT(0.5);
  QTRY_VERIFY(last().locked && std::abs(*last().referenceT - 0.5) < 1e-3);
  QTRY_VERIFY(std::abs(last().rawT[1] - 0.48) < 0.02);
  open.bench.setLiveReading(false);
  QVERIFY(!open.bench.canPlaceProbe());
}

void FieldBenchLinkTest::disconnectingEndsTheCapture() {
  OpenCampaign open;
  QVERIFY(open.connectFast(true));
  QVERIFY(open.bench.startCapture(twoOrientations(), SweepRole::Calibration, false).has_value());
  QVERIFY(open.waitsFor("place the probe with its +x axis along the field"));
  open.bench.confirm();
  QVERIFY(open.waitsFor("place the probe with its -x axis along the field"));
  open.bench.disconnectBench();
  QVERIFY(!open.bench.isConnected());
  QVERIFY(!open.bench.isCapturing());
  QCOMPARE(open.document.campaign().rows.size(), open.stored().size());
  QVERIFY(!open.document.campaign().rows.empty());
}

void FieldBenchLinkTest::goesOnOnlyOnTheBenchItBeganOn() {
  OpenCampaign open;
  QVERIFY(open.connectFast(true));
  const devices::FieldPlan plan = twoOrientations();
  QVERIFY(open.bench.startCapture(plan, SweepRole::Calibration, false).has_value());
  QVERIFY(open.waitsFor("place the probe with its +x axis along the field"));
  open.bench.confirm();
  QVERIFY(open.waitsFor("place the probe with its -x axis along the field"));
  open.bench.stopAndWait();
  auto other = std::make_shared<FailingFieldBench>(1000);
  QVERIFY(open.bench.connectBench(other->bench(), other).has_value());
  const Result<void> mixed = open.bench.startCapture(plan, SweepRole::Calibration, true);
  QVERIFY(!mixed);
  QCOMPARE(QString::fromStdString(mixed.error().message()),
           QStringLiteral("this campaign was begun on the simulated bench; connect that in the step Connect, or start "
                          "over"));
  QVERIFY(!open.bench.isCapturing());
  QVERIFY(open.captureToTheEnd(plan));
  QVERIFY(open.connectFast());
  QVERIFY(!open.bench.startCapture(plan, SweepRole::Calibration, true));
}

void FieldBenchLinkTest::commandLineGoesOnWithTheWindowsCampaign() {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("window.sedge"));
  const devices::FieldPlan plan = twoOrientations();
  std::size_t before = 0;
  {
    OpenCampaign open;
    QVERIFY(open.document.saveAs(file).has_value());
    QVERIFY(open.connectFast(true));
    QVERIFY(open.bench.startCapture(plan, SweepRole::Calibration, false).has_value());
    QVERIFY(open.waitsFor("place the probe with its +x axis along the field"));
    open.bench.confirm();
    QVERIFY(open.waitsFor("place the probe with its -x axis along the field"));
    open.bench.stopAndWait();
    before = open.stored().size();
    open.document.setPlan(smallCampaign()); // for another time; the campaign that was begun keeps its own
    QVERIFY(open.document.close().has_value());
  }
  QCOMPARE(cli({"capture", "field", "--bench", "simulated", "--session", file, "--resume"}), 0);
  OpenCampaign open;
  QVERIFY(open.document.open(file).has_value());
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
  const auto samples = open.stored();
  QVERIFY(samples.size() > before);
  QCOMPARE(distinctSequences(samples), samples.size());
  QCOMPARE(std::ranges::count(samples, true, &session::FieldSample::locked), 2 * 3 * 3);
  for (const session::FieldSample& sample : samples) {
    QVERIFY(!sample.locked || (sample.rawT[0] > 0.0) == (sample.stage == 0));
  }
}

void FieldBenchLinkTest::windowGoesOnWithTheCommandLinesCampaign() {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("cli.sedge"));
  QCOMPARE(cli({"capture", "field", "--bench", "simulated", "--session", file, "--seed", "77", "--stages",
                "offset,electronics", "--sweep-rows", "20"}),
           0);
  OpenCampaign open;
  QVERIFY(open.document.open(file).has_value());
  QVERIFY(!open.bench.interruptedPlan(SweepRole::Calibration));
  QCOMPARE(open.bench.simulatedSettings().seed, std::uint64_t{77}); // the form shows what the session says
  QCOMPARE(open.document.campaign().rows.size(), std::size_t{40});
  QVERIFY(open.bench.connectSimulated(open.bench.simulatedSettings()).has_value());
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  open.bench.redoStage(1);
  QVERIFY(ended.wait(captureWaitMs));
  QCOMPARE(open.stored().size(), std::size_t{60});
  QCOMPARE(open.stored().back().attempt, 1);
  QCOMPARE(open.document.campaign().rows.size(), std::size_t{40});
}

void FieldBenchLinkTest::killedProgramLeavesCampaignThatIsResumed() {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("killed.sedge"));
  QProcess program;
  program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
  program.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--capture-into"), file});
  QVERIFY(program.waitForReadyRead(captureWaitMs));
  QVERIFY(program.readAllStandardOutput().contains("captured"));
  program.kill();
  QVERIFY(program.waitForFinished(captureWaitMs));
  QCOMPARE(program.exitStatus(), QProcess::CrashExit);

  OpenCampaign open;
  QVERIFY(open.document.open(file).has_value());
  QVERIFY(open.document.session()->fieldSampleCount(SweepRole::Calibration).value_or(0) >= 1);
  const std::optional<devices::FieldPlan> plan = open.bench.interruptedPlan(SweepRole::Calibration);
  QCOMPARE(plan, std::optional(planToBeKilledIn()));
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(*plan, SweepRole::Calibration, true));
  const auto samples = open.stored();
  QCOMPARE(distinctSequences(samples), samples.size());
  QCOMPARE(std::ranges::count(samples, true, &session::FieldSample::locked), 2 * 3 * 3);
}

std::unique_ptr<QObject> makeFieldBenchLinkTest() { return std::make_unique<FieldBenchLinkTest>(); }

int captureCampaignUntilKilled(const QString& file) {
  OpenCampaign open;
  devices::SimulatedFieldSettings settings;
  settings.placingS = 0.01;
  if (!open.document.saveAs(file) || !open.bench.connectSimulated(settings) ||
      !open.bench.startCapture(planToBeKilledIn(), SweepRole::Calibration, false)) {
    return 1;
  }
  QObject::connect(&open.bench, &FieldBenchLink::progressChanged, &open.bench, [&open] {
    if (open.document.session()->fieldSampleCount(SweepRole::Calibration).value_or(0) >= 1) {
      std::fputs("captured\n", stdout);
      std::fflush(stdout);
    }
  });
  return QCoreApplication::exec();
}

} // namespace straightedge::gui

#include "field_bench_link_test.moc"
