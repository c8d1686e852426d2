#include "app/gui/steps/connect_presenter.h"
#include "tests/app/gui/steps_capture/open_calibration.h"
#include "tests/app/gui/steps_capture/test_classes.h"

namespace straightedge::gui {

class ConnectPresenterTest : public QObject {
  Q_OBJECT
private slots:
  void tellsWhatIsConnected();
  void showsReadings();
  void tellsNoiseOnlyAtStandstill();
  void takesInstrumentsOver();
  void locksTheBenchDuringCapture();
};

void ConnectPresenterTest::tellsWhatIsConnected() {
  OpenCalibration open;
  ConnectPresenter presenter(open.document, open.bench);
  QVERIFY(!presenter.connected());
  QVERIFY(presenter.statusText().startsWith(QStringLiteral("No bench is connected")));
  QVERIFY(presenter.instruments().isEmpty());
  presenter.connectSimulated(fastSettings());
  QVERIFY(presenter.connected());
  QVERIFY(presenter.problem().isEmpty());
  QVERIFY(presenter.instruments().size() >= 2);
  QVERIFY(!presenter.instruments()[0].model.isEmpty());
  QVERIFY(!presenter.instruments()[0].serial.isEmpty());
  presenter.disconnectBench();
  QVERIFY(!presenter.connected());
}

void ConnectPresenterTest::showsReadings() {
  OpenCalibration open;
  ConnectPresenter presenter(open.document, open.bench);
  QCOMPARE(presenter.encoderText(), QStringLiteral("–"));
  QVERIFY(open.connectFast());
  emit open.bench.liveReading(370.5, 91.25);
  QCOMPARE(presenter.encoderText(), QStringLiteral("10.5000°"));
  QCOMPARE(presenter.sensorText(), QStringLiteral("91.250°"));
  QCOMPARE(presenter.differenceText(), QStringLiteral("80.750°"));
  QCOMPARE(presenter.tracePlot().series.front().y.size(), 1);
  presenter.disconnectBench();
  QCOMPARE(presenter.encoderText(), QStringLiteral("–"));
}

void ConnectPresenterTest::tellsNoiseOnlyAtStandstill() {
  OpenCalibration open;
  ConnectPresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  for (int i = 0; i < 20; ++i) {
    emit open.bench.liveReading(10.0, i % 2 == 0 ? 89.9 : 90.1);
  }
  QCOMPARE(presenter.noiseText(), QStringLiteral("0.1026°")); // 0.1·√(20/19)
  emit open.bench.liveReading(12.0, 92.0);
  QCOMPARE(presenter.noiseText(), QStringLiteral("–"));
}

void ConnectPresenterTest::takesInstrumentsOver() {
  OpenCalibration open;
  ConnectPresenter presenter(open.document, open.bench);
  QVERIFY(!presenter.canTakeOverInstruments());
  QVERIFY(presenter.traceabilitySummary().contains(QStringLiteral("not stated")));
  QVERIFY(open.connectFast());
  QVERIFY(presenter.canTakeOverInstruments());
  presenter.takeOverInstruments();
  QCOMPARE(open.document.traceability().deviceSerial, open.bench.instruments()[0].identity.serial);
  QCOMPARE(open.document.traceability().reference.model, open.bench.instruments()[1].identity.model);
  QVERIFY(!presenter.canTakeOverInstruments());
  open.document.undoStack().undo();
  QVERIFY(presenter.canTakeOverInstruments());
}

void ConnectPresenterTest::locksTheBenchDuringCapture() {
  OpenCalibration open;
  ConnectPresenter presenter(open.document, open.bench);
  QVERIFY(open.connectFast());
  QSignalSpy ended(&open.bench, &BenchLink::captureEnded);
  QVERIFY(open.bench.startCapture(planOf(4000), session::SweepRole::Calibration, false).has_value());
  QVERIFY(!presenter.mayChange());
  presenter.connectSimulated(fastSettings());
  QVERIFY(presenter.problem().contains(QStringLiteral("stop the capture first")));
  open.bench.stopAndWait();
  QVERIFY(presenter.mayChange());
}

std::unique_ptr<QObject> makeConnectPresenterTest() { return std::make_unique<ConnectPresenterTest>(); }

} // namespace straightedge::gui

#include "connect_presenter_test.moc"
