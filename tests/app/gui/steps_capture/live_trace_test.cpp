#include "app/gui/steps/live_trace.h"
#include "tests/app/gui/steps_capture/test_classes.h"

#include <QTest>

#include <cmath>

namespace straightedge::gui {

class LiveTraceTest : public QObject {
  Q_OBJECT
private slots:
  void errorIsContinuousAcrossTheSeam();
  void decreasingSensorIsRecognised();
  void manyReadingsBecomeColumns();
  void columnsKeepTheExtremes();
  void directionsAreApart();
  void pointsLeadToThePlan();
};

namespace {

session::AngleSample sampleAt(int index, double encoderDeg, double sensorDeg, int direction = 1) {
  session::AngleSample sample;
  sample.sequence = index;
  sample.point = index;
  sample.direction = direction;
  sample.encoderDeg = encoderDeg;
  sample.sensorDeg = std::fmod(std::fmod(sensorDeg, 360.0) + 360.0, 360.0);
  return sample;
}

} // namespace

void LiveTraceTest::errorIsContinuousAcrossTheSeam() {
  std::vector<session::AngleSample> all;
  LiveTrace trace;
  for (int i = 0; i < 36; ++i) { // an error of 179° with a swing of 5° crosses 180°
    const double encoder = 10.0 * i;
    all.push_back(sampleAt(i, encoder, encoder + 179.0 + 5.0 * std::sin(encoder / 57.29577951308232)));
    trace.add(all, all.size() - 1);
  }
  const PlotSeries rising = trace.errorPlot().series[0];
  QCOMPARE(rising.y.size(), 36);
  for (qsizetype i = 1; i < rising.y.size(); ++i) {
    QVERIFY(std::abs(rising.y[i] - rising.y[i - 1]) < 2.0);
  }
}

void LiveTraceTest::decreasingSensorIsRecognised() {
  std::vector<session::AngleSample> all;
  LiveTrace trace;
  for (int i = 0; i < 36; ++i) {
    all.push_back(sampleAt(i, 10.0 * i, 300.0 - 10.0 * i));
    trace.add(all, all.size() - 1);
  }
  QVERIFY(trace.decreasing());
  const PlotSpec plot = trace.errorPlot();
  for (const double error : plot.series[0].y) { // 360 − sensor − encoder
    QVERIFY(std::abs(error - 60.0) < 1e-9);
  }
}

void LiveTraceTest::manyReadingsBecomeColumns() {
  std::vector<session::AngleSample> all;
  for (int i = 0; i < 100000; ++i) {
    all.push_back(sampleAt(i, 0.036 * i, 0.036 * i + 80.0));
  }
  LiveTrace trace;
  trace.add(all, 0);
  QVERIFY(trace.dense());
  QVERIFY(trace.errorPlot().series[0].x.size() <= 3 * LiveTrace::columns);
  QVERIFY(trace.sensorPlot().series[0].x.size() <= 3 * LiveTrace::columns);
  QVERIFY(!trace.planPoint(0, 0));
}

void LiveTraceTest::columnsKeepTheExtremes() {
  std::vector<session::AngleSample> all;
  LiveTrace trace;
  for (int i = 0; i < 20000; ++i) { // in steps, as frames bring them
    all.push_back(sampleAt(i, 0.018 * i, 0.018 * i + 80.0 + (i == 12345 ? 3.0 : 0.0)));
    if (i % 100 == 99) {
      trace.add(all, all.size() - 100);
    }
  }
  const QList<double> errors = trace.errorPlot().series[0].y;
  QVERIFY(std::abs(*std::max_element(errors.begin(), errors.end()) - 83.0) < 1e-9);
}

void LiveTraceTest::directionsAreApart() {
  const std::vector<session::AngleSample> all = {sampleAt(0, 0.0, 80.0), sampleAt(1, 10.0, 90.0),
                                                 sampleAt(2, 10.0, 90.2, -1), sampleAt(3, 0.0, 80.2, -1)};
  LiveTrace trace;
  trace.add(all, 0);
  QCOMPARE(trace.errorPlot().series[0].x.size(), 2);
  QCOMPARE(trace.errorPlot().series[1].x.size(), 2);
  QCOMPARE(trace.errorPlot().series[1].name, QStringLiteral("Falling"));
}

void LiveTraceTest::pointsLeadToThePlan() {
  const std::vector<session::AngleSample> all = {sampleAt(0, 0.0, 80.0), sampleAt(1, 10.0, 90.0),
                                                 sampleAt(2, 10.0, 90.2, -1)};
  LiveTrace trace;
  trace.add(all, 0);
  QCOMPARE(trace.planPoint(0, 1), std::optional(1));
  QCOMPARE(trace.planPoint(1, 0), std::optional(2));
  QVERIFY(!trace.planPoint(1, 1));
  QVERIFY(!trace.planPoint(2, 0));
}

std::unique_ptr<QObject> makeLiveTraceTest() { return std::make_unique<LiveTraceTest>(); }

} // namespace straightedge::gui

#include "live_trace_test.moc"
