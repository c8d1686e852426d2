#include "app/gui/field_steps/field_capture_presenter.h"
#include "app/gui/field_steps/field_connect_presenter.h"
#include "app/gui/field_steps/fresh_capture.h"
#include "app/gui/shell/field_step_state.h"
#include "devices/instruments/bench_connection.h"
#include "tests/app/gui/field_capture/open_campaign.h"
#include "tests/app/gui/field_capture/test_classes.h"

#include <QTemporaryDir>

namespace straightedge::gui {

using field::CampaignStep;
using session::SweepRole;
using Phase = FieldCapturePresenter::Phase;

/// The presenters of Connect, Capture and of the fresh campaign, without widgets.
class FieldCapturePresenterTest : public QObject {
  Q_OBJECT
private slots:
  void connectTellsWhatIsConnected();
  void connectShowsReadings();
  void connectTakesInstrumentsOver();
  void connectIsLockedDuringCapture();
  void needsBench();
  void plansDuration();
  void refusesPlanInWords();
  void runsToTheEnd();
  void waitsGuidesAndGoesOn();
  void leavesOutWhileItWaits();
  void repeatsTheStageThatIsMeasured();
  void continuesAfterStop();
  void continuesAfterReopening();
  void faultIsAPhaseOfItsOwn();
  void neverLockedIsAFault();
  void unpluggedIsWaitedFor();
  void repeatsAfterTheEnd();
  void takesBackInAfterTheEnd();
  void asksBeforeReplacing();
  void showsAChosenStage();
  void freshCampaignIsShownWhileItRuns();
  void freshCampaignThatWasCutIsGoneOnWith();
  void stepBarFollows();
};

namespace {

/// Waits until the presenter is in a phase.
bool reaches(const FieldCapturePresenter& presenter, Phase phase) {
  return QTest::qWaitFor([&] { return presenter.phase() == phase; }, captureWaitMs);
}

/// A bench whose connection says that its teslameter is gone until it is plugged in again.
class PluggedBench : public devices::BenchConnection {
public:
  explicit PluggedBench(int goodReadings) : m_failing(goodReadings) {}
  devices::FieldBench bench() {
    devices::FieldBench bench = m_failing.bench();
    bench.connection = this;
    return bench;
  }
  void plugIn() { m_there = true; }
  std::optional<devices::TransportFault> lastFault() const override { return devices::TransportFault::Gone; }
  Result<bool> restore() override {
    if (m_there) {
      m_failing.mend();
    }
    return m_there.load();
  }

private:
  FailingFieldBench m_failing;
  std::atomic<bool> m_there = false;
};

} // namespace

void FieldCapturePresenterTest::connectTellsWhatIsConnected() {
  OpenCampaign open;
  FieldConnectPresenter presenter(open.document, open.bench);
  QVERIFY(!presenter.connected());
  QVERIFY(presenter.statusText().startsWith(QStringLiteral("No bench is connected")));
  QVERIFY(presenter.instruments().isEmpty());
  presenter.connectSimulated(fastField());
  QVERIFY(presenter.connected());
  QVERIFY(presenter.problem().isEmpty());
  QStringList roles;
  for (const ConnectedInstrument& instrument : presenter.instruments()) {
    roles << instrument.role;
    QVERIFY(!instrument.model.isEmpty() && !instrument.serial.isEmpty());
  }
  QCOMPARE(roles, QStringList({"Teslameter under calibration", "Reference field", "PT100", "Magnet", "Probe chamber",
                               "Electronics chamber"}));
  presenter.disconnectBench();
  QVERIFY(!presenter.connected());
  const auto refused = open.bench.connectBench(devices::FieldBench{}, nullptr);
  QVERIFY(!refused);
  QCOMPARE(refused.error().message(), std::string("the bench has no teslameter; choose an instrument for it"));
}

void FieldCapturePresenterTest::connectShowsReadings() {
  OpenCampaign open;
  FieldConnectPresenter presenter(open.document, open.bench);
  QCOMPARE(presenter.axisText(field::Axis::X), QStringLiteral("–"));
  QVERIFY(open.connectFast());
  FieldLiveReading reading;
  reading.rawT = {-0.123456, 0.5, 0.0};
  reading.pt100Ohm = 109.25;
  for (int i = 0; i < 20; ++i) {
    reading.rawT[1] = i % 2 == 0 ? 0.5 : 0.50001;
    emit open.bench.liveReading(reading);
  }
  QCOMPARE(presenter.axisText(field::Axis::X), QStringLiteral("−0.123456"));
  QCOMPARE(presenter.noiseText(field::Axis::X), QStringLiteral("1 σ 0.0 µT"));
  QCOMPARE(presenter.noiseText(field::Axis::Y), QStringLiteral("1 σ 7.1 µT")); // 10 µT/√2
  QStringList texts;
  for (const auto& value : presenter.values()) {
    texts << value.text;
  }
  QCOMPARE(texts, QStringList({"not locked", "109.2500 Ω", "–", "–", "–"}));
  reading.locked = true;
  reading.referenceT = 0.5000012;
  reading.overRange = true;
  emit open.bench.liveReading(reading);
  QCOMPARE(presenter.values().front().text, QStringLiteral("0.5000012 T"));
  QCOMPARE(presenter.axisText(field::Axis::X), QStringLiteral("over range"));
  QCOMPARE(presenter.tracePlot().series.size(), 3);
  QCOMPARE(presenter.tracePlot().series[0].y.size(), 21);
  presenter.disconnectBench();
  QCOMPARE(presenter.axisText(field::Axis::X), QStringLiteral("–"));
  QVERIFY(presenter.tracePlot().series[0].y.isEmpty());
}

void FieldCapturePresenterTest::connectTakesInstrumentsOver() {
  OpenCampaign open;
  FieldConnectPresenter presenter(open.document, open.bench);
  QVERIFY(!presenter.canTakeOverInstruments());
  QVERIFY(open.connectFast());
  QVERIFY(presenter.canTakeOverInstruments());
  presenter.takeOverInstruments();
  QCOMPARE(open.document.traceability().deviceSerial, std::string("SIM-H"));
  QCOMPARE(open.document.traceability().reference.serial, std::string("SIM-N"));
  QVERIFY(presenter.traceabilitySummary().contains(QStringLiteral("serial SIM-N")));
  QVERIFY(!presenter.canTakeOverInstruments());
  open.document.undoStack().undo();
  QVERIFY(presenter.canTakeOverInstruments());
}

void FieldCapturePresenterTest::connectIsLockedDuringCapture() {
  OpenCampaign open;
  FieldConnectPresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast(true));
  QVERIFY(open.bench.startCapture(twoOrientations(), SweepRole::Calibration, false).has_value());
  QVERIFY(!presenter.mayChange());
  presenter.connectSimulated(fastField());
  QVERIFY(presenter.problem().contains(QStringLiteral("stop the capture first")));
  QVERIFY(presenter.statusText().contains(QStringLiteral("is capturing")));
  open.bench.stopAndWait();
  QVERIFY(presenter.mayChange());
}

void FieldCapturePresenterTest::needsBench() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QCOMPARE(presenter.phase(), Phase::NoBench);
  QVERIFY(!presenter.canStart());
  QVERIFY(presenter.guidance().contains(QStringLiteral("step Connect")));
  QVERIFY(open.connectFast());
  QCOMPARE(presenter.phase(), Phase::Ready);
  QVERIFY(presenter.canStart());
  QCOMPARE(presenter.stages().size(), devices::makeFieldPlan().stages.size());
}

void FieldCapturePresenterTest::plansDuration() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  presenter.setPlan(twoOrientations()); // six plateaus of 5 s and 3 rows of 6 s
  QCOMPARE(presenter.planSummary(), QStringLiteral("2 stages, 6 plateaus and sweeps, about 2 min 18 s"));
  presenter.leaveOut(1, true);
  QCOMPARE(presenter.planSummary(), QStringLiteral("1 stages, 3 plateaus and sweeps, about 1 min 9 s"));
  QCOMPARE(presenter.stages()[1].state, QStringLiteral("left out"));
  QVERIFY(open.connectFast());
  QVERIFY(presenter.planSummary().endsWith(QStringLiteral("as fast as the computer can")));
}

void FieldCapturePresenterTest::refusesPlanInWords() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  devices::FieldPlan plan = twoOrientations();
  plan.settleS = -1.0;
  presenter.setPlan(plan);
  QCOMPARE(presenter.planProblem(), QStringLiteral("capture plan: the settling time is -1 s; give 0 to 86400 s"));
  QVERIFY(!presenter.canStart());
  presenter.start();
  QVERIFY(!open.bench.isCapturing());
}

void FieldCapturePresenterTest::runsToTheEnd() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  presenter.setPlan(smallCampaign());
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.start();
  QCOMPARE(presenter.phase(), Phase::Running);
  QVERIFY(presenter.canPause() && presenter.canStop() && !presenter.canStart());
  QVERIFY(presenter.nextStep().isEmpty());
  QVERIFY(ended.wait(captureWaitMs));
  QCOMPARE(presenter.phase(), Phase::Ready);
  QVERIFY(presenter.isComplete());
  QCOMPARE(presenter.nextStep(), QStringLiteral("Review"));
  QCOMPARE(presenter.progressFraction(), 1.0);
  for (const StageLine& line : presenter.stages()) {
    QVERIFY2(line.progress == StageProgress::Done, qPrintable(line.title + ": " + line.state));
    QVERIFY(line.duration.isEmpty());
  }
  QCOMPARE(presenter.rowsText().remove(QChar(0x202f)), QStringLiteral("%1 rows").arg(open.stored().size()));
}

void FieldCapturePresenterTest::waitsGuidesAndGoesOn() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast(true));
  presenter.setPlan(twoOrientations());
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.start();
  QVERIFY(reaches(presenter, Phase::Waiting));
  QCOMPARE(presenter.heading(), QStringLiteral("Stage 1 of 2: Orientation, +x"));
  QCOMPARE(presenter.instruction(), QStringLiteral("Place the probe with its +x axis along the field."));
  QVERIFY(presenter.actionText().isEmpty());
  QCOMPARE(presenter.progressFraction(), 0.0);
  presenter.pause();
  QVERIFY(reaches(presenter, Phase::Paused));
  QVERIFY(presenter.instruction().isEmpty());
  presenter.resume();
  QVERIFY(reaches(presenter, Phase::Waiting)); // asked again: who paused may have moved it
  presenter.confirm();
  QTRY_COMPARE(presenter.instruction(), QStringLiteral("Place the probe with its −x axis along the field."));
  QCOMPARE(presenter.progressFraction(), 0.5);
  QCOMPARE(presenter.stages()[0].state, QStringLiteral("done"));
  QCOMPARE(presenter.shownStage(), 1); // the plots follow
  presenter.confirm();
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QVERIFY(presenter.isComplete());
}

void FieldCapturePresenterTest::leavesOutWhileItWaits() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast(true));
  presenter.setPlan(twoOrientations());
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.start();
  QVERIFY(reaches(presenter, Phase::Waiting));
  presenter.leaveOut(0, true);
  QTRY_COMPARE(presenter.presentStage(), 1);
  QTRY_COMPARE(presenter.stages()[0].state, QStringLiteral("left out"));
  presenter.leaveOut(0, false); // it comes after all, as soon as nothing else is being measured
  const auto endsWhileConfirmed = [&] {
    presenter.confirm(); // of no effect where nothing is asked for
    return !ended.isEmpty();
  };
  QVERIFY(QTest::qWaitFor(endsWhileConfirmed, captureWaitMs));
  QVERIFY(presenter.isComplete());
  QCOMPARE(presenter.stages()[0].state, QStringLiteral("done"));
  QCOMPARE(presenter.stages()[1].state, QStringLiteral("done"));
}

void FieldCapturePresenterTest::repeatsTheStageThatIsMeasured() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  devices::SimulatedFieldSettings settings = fastField();
  settings.realTime = true; // a long sweep must not be over before it is asked for again
  settings.placingS = 0.0;
  QVERIFY(open.bench.connectSimulated(settings).has_value());
  devices::FieldPlan plan = smallCampaign({CampaignStep::Offset});
  plan.temperatureSettleS = 0.0;
  plan.stages[0].rowS = 0.01;
  plan.stages[0].rows = 100000;
  presenter.setPlan(plan);
  presenter.start();
  QTRY_VERIFY(presenter.actionText().startsWith(QStringLiteral("Sweeping the probe, now at ")));
  QTRY_VERIFY(!presenter.trace().mainPlot().series.isEmpty() && presenter.trace().rows() > 3);
  QVERIFY(presenter.canRepeat(0));
  presenter.repeat(0); // at once, not after its 100,000 rows
  QTRY_COMPARE(presenter.stages()[0].attempt, QStringLiteral("no. 2"));
  QTRY_VERIFY(open.bench.liveSamples().back().attempt == 1);
  presenter.leaveOut(0, true); // likewise; nothing else is to be measured
  QTRY_VERIFY(!open.bench.isCapturing());
  QVERIFY(!open.stored().empty());
}

void FieldCapturePresenterTest::continuesAfterStop() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  auto failing = std::make_shared<FailingFieldBench>(7);
  QVERIFY(open.bench.connectBench(failing->bench(), failing).has_value());
  presenter.setPlan(twoOrientations());
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.start();
  QVERIFY(reaches(presenter, Phase::Faulted));
  presenter.stop();
  QTRY_COMPARE(ended.count(), 1);
  QCOMPARE(presenter.phase(), Phase::Interrupted);
  QVERIFY(presenter.canContinueInterrupted());
  QVERIFY2(presenter.guidance().contains(QStringLiteral("of 6 plateaus and sweeps. Go on where it stopped")),
           qPrintable(presenter.guidance()));
  QCOMPARE(presenter.nextStep(), QStringLiteral("Review")); // a part may be looked at
  QVERIFY(!presenter.isComplete());
  failing->mend();
  presenter.continueInterrupted();
  QTRY_COMPARE(ended.count(), 2);
  QVERIFY(presenter.isComplete());
}

void FieldCapturePresenterTest::continuesAfterReopening() {
  QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("begun.sedge"));
  {
    OpenCampaign open;
    QVERIFY(open.document.saveAs(file).has_value());
    QVERIFY(open.connectFast(true));
    QVERIFY(open.bench.startCapture(twoOrientations(), SweepRole::Calibration, false).has_value());
    QVERIFY(open.waitsFor("place the probe with its +x axis along the field"));
    open.bench.confirm();
    QVERIFY(open.waitsFor("place the probe with its -x axis along the field"));
    open.bench.stopAndWait();
    QVERIFY(open.document.close().has_value());
  }
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.document.open(file).has_value());
  QCOMPARE(presenter.phase(), Phase::NoBench);
  QCOMPARE(presenter.stages().size(), std::size_t{2});
  QCOMPARE(presenter.stages()[0].state, QStringLiteral("done"));
  QCOMPARE(presenter.stages()[1].state, QStringLiteral("to do"));
  QVERIFY(open.connectFast());
  QCOMPARE(presenter.phase(), Phase::Interrupted);
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.continueInterrupted();
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QVERIFY(presenter.isComplete());
}

void FieldCapturePresenterTest::faultIsAPhaseOfItsOwn() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  auto failing = std::make_shared<FailingFieldBench>(4);
  QVERIFY(open.bench.connectBench(failing->bench(), failing).has_value());
  presenter.setPlan(twoOrientations());
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.start();
  QVERIFY(reaches(presenter, Phase::Faulted));
  QVERIFY(presenter.problem().contains(QStringLiteral("the teslameter was switched off; switch it on, then resume")));
  QVERIFY(presenter.guidance().contains(QStringLiteral("every row so far is stored")));
  QVERIFY(presenter.canResume() && !presenter.canPause());
  failing->mend();
  presenter.resume();
  QVERIFY(presenter.problem().isEmpty());
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QVERIFY(presenter.isComplete());
}

void FieldCapturePresenterTest::neverLockedIsAFault() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  devices::FieldPlan plan = twoOrientations();
  plan.stages[0].fieldsT = {0.01, 0.02}; // below what the NMR locks on
  presenter.setPlan(plan);
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.start();
  QVERIFY(reaches(presenter, Phase::Faulted));
  QVERIFY(presenter.problem().contains(QStringLiteral("the reference never locked in stage 'orientation, +x'")));
  presenter.leaveOut(0, true);
  presenter.resume();
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QVERIFY(presenter.isComplete());
  QVERIFY(presenter.isLeftOut(0));
  QVERIFY(presenter.stages()[0].cost.contains(QStringLiteral("the block “Axis matrix” is switched off")));
}

void FieldCapturePresenterTest::unpluggedIsWaitedFor() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  auto plugged = std::make_shared<PluggedBench>(4);
  QVERIFY(open.bench.connectBench(plugged->bench(), plugged).has_value());
  presenter.setPlan(twoOrientations());
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.start();
  QVERIFY(reaches(presenter, Phase::Unplugged));
  QVERIFY(presenter.guidance().contains(QStringLiteral("Plug it in again: the capture goes on by itself")));
  QVERIFY(!presenter.canResume());
  plugged->plugIn();
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QVERIFY(presenter.isComplete());
}

void FieldCapturePresenterTest::repeatsAfterTheEnd() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  QVERIFY(!presenter.canRepeat(0));
  QVERIFY(open.captureToTheEnd(twoOrientations()));
  QVERIFY(presenter.canRepeat(1));
  QVERIFY(!presenter.canRepeat(2));
  QVERIFY(!presenter.canRepeat(-1));
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.repeat(1);
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QCOMPARE(presenter.stages()[1].attempt, QStringLiteral("no. 2"));
  QCOMPARE(presenter.stages()[0].attempt, QString());
  QVERIFY(presenter.isComplete());
}

void FieldCapturePresenterTest::takesBackInAfterTheEnd() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  devices::FieldPlan plan = twoOrientations();
  plan.stages[1].skipped = true;
  QVERIFY(open.captureToTheEnd(plan));
  QVERIFY(presenter.isComplete());
  QCOMPARE(presenter.stages()[1].state, QStringLiteral("left out"));
  presenter.leaveOut(1, false);
  QCOMPARE(presenter.phase(), Phase::Interrupted);
  QVERIFY(!presenter.isComplete());
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  presenter.continueInterrupted();
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QCOMPARE(presenter.stages()[1].state, QStringLiteral("done"));
}

void FieldCapturePresenterTest::asksBeforeReplacing() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  QVERIFY(!presenter.startReplacesData());
  QVERIFY(open.captureToTheEnd(twoOrientations()));
  QVERIFY(presenter.startReplacesData());
  QVERIFY(presenter.replaceQuestion().contains(QStringLiteral("%1 rows").arg(open.stored().size())));
}

void FieldCapturePresenterTest::showsAChosenStage() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(twoOrientations()));
  presenter.showStage(0);
  QCOMPARE(presenter.trace().mainPlot().title, QStringLiteral("Orientation, +x"));
  QCOMPARE(presenter.trace().mainPlot().series[0].x.size(), 9); // three plateaus of three rows
  presenter.showStage(1);
  QCOMPARE(presenter.trace().mainPlot().title, QStringLiteral("Orientation, −x"));
  presenter.showStage(7);
  QCOMPARE(presenter.shownStage(), 1);
}

void FieldCapturePresenterTest::freshCampaignIsShownWhileItRuns() {
  OpenCampaign open;
  FieldCapturePresenter presenter(open.document, open.bench);
  FreshCapture fresh(open.document, open.bench);
  QCOMPARE(fresh.cannot(), QStringLiteral("There is no calibration to verify yet."));
  open.document.setPlan(smallCampaign());
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(open.document.plan()));
  QTRY_VERIFY(open.document.run() != nullptr);
  QVERIFY(fresh.cannot().isEmpty());
  QCOMPARE(fresh.plan().stages.size(), std::size_t{3});
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  fresh.start();
  QVERIFY(fresh.isRunning());
  QVERIFY(presenter.ofVerification());
  QCOMPARE(presenter.stages().size(), std::size_t{3});
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QVERIFY(!fresh.isRunning());
  QVERIFY(!presenter.ofVerification());
  QCOMPARE(presenter.nextStep(), QStringLiteral("Verify"));
  QCOMPARE(presenter.stages().size(), smallCampaign().stages.size()); // the calibration's again
  QTRY_VERIFY(open.document.verificationIsFresh());
  QVERIFY(open.document.verification()->met);
}

void FieldCapturePresenterTest::freshCampaignThatWasCutIsGoneOnWith() {
  OpenCampaign open;
  FreshCapture fresh(open.document, open.bench);
  open.document.setPlan(smallCampaign());
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(open.document.plan()));
  QTRY_VERIFY(open.document.run() != nullptr);
  QVERIFY(open.connectFast(true));
  QSignalSpy ended(&open.bench, &FieldBenchLink::captureEnded);
  fresh.start();
  QVERIFY(open.waitsFor("place the probe with its +x axis along the field"));
  open.bench.confirm();
  QVERIFY(open.waitsFor("place the probe with its +y axis along the field"));
  open.bench.stopAndWait();
  QVERIFY(fresh.isInterrupted());
  QVERIFY(open.connectFast());
  fresh.start();
  QTRY_COMPARE(ended.count(), 2);
  QVERIFY(!fresh.isInterrupted());
  QCOMPARE(open.document.verificationCampaign().rows.size(), open.stored(SweepRole::Verification).size());
}

void FieldCapturePresenterTest::stepBarFollows() {
  OpenCampaign open;
  const auto state = [&open](std::size_t step) { return fieldStepState(step, open.document, open.bench); };
  QCOMPARE(state(0).progress, StepProgress::Available);
  QCOMPARE(state(1).progress, StepProgress::Missing);
  QVERIFY(open.connectFast(true));
  QCOMPARE(state(0).progress, StepProgress::Done);
  QCOMPARE(state(0).note, QStringLiteral("Connected: Simulated bench."));
  QCOMPARE(state(1).progress, StepProgress::Available);
  QVERIFY(open.bench.startCapture(twoOrientations(), SweepRole::Calibration, false).has_value());
  QCOMPARE(state(1).note, QStringLiteral("Capturing."));
  QVERIFY(open.waitsFor("place the probe with its +x axis along the field"));
  open.bench.confirm();
  QVERIFY(open.waitsFor("place the probe with its -x axis along the field"));
  open.bench.stopAndWait();
  QCOMPARE(state(1).progress, StepProgress::Available);
  QVERIFY(state(1).note.endsWith(QStringLiteral("stages are still to be measured.")));
  QVERIFY(open.connectFast());
  QVERIFY(open.captureToTheEnd(twoOrientations(), SweepRole::Calibration, true));
  QCOMPARE(state(1).progress, StepProgress::Done);
}

std::unique_ptr<QObject> makeFieldCapturePresenterTest() { return std::make_unique<FieldCapturePresenterTest>(); }

} // namespace straightedge::gui

#include "field_capture_presenter_test.moc"
