#include "app/gui/steps/review_presenter.h"
#include "tests/app/gui/steps_capture/open_calibration.h"
#include "tests/app/gui/steps_capture/test_classes.h"

#include <cmath>

namespace straightedge::gui {

class ReviewTest : public QObject {
  Q_OBJECT
private slots:
  void neighboursForetellSmoothData();
  void outlierAmongNeighboursIsFoundAlone();
  void outlierAboutRegressionIsFound();
  void refusedSweepHasErrorsOnly();
  void pointsGoOffAndComeBack();
  void plotPointsLeadToRows();
  void refusalIsANotice();
  void tableCopiesEveryDigit();
  void hundredThousandRows();
};

namespace {

/// Side-shaft shape with `spoiled` lifted by 2°.
angle::Sweep smoothSweep(int points, std::optional<int> spoiled = std::nullopt, int repeats = 1) {
  angle::Sweep sweep;
  for (int pass = 0; pass < repeats; ++pass) {
    for (int i = 0; i < points; ++i) {
      const double encoder = 360.0 * i / points;
      const double radians = encoder * 0.017453292519943295;
      double sensor = encoder + 30.0 + 4.0 * std::sin(2.0 * radians) + 0.002 * std::sin(37.0 * i + pass);
      sensor += spoiled == i && pass == 0 ? 2.0 : 0.0;
      sweep.encoderDeg.push_back(encoder + 360.0 * pass);
      sweep.sensorDeg.push_back(std::fmod(sensor, 360.0));
      sweep.turn.push_back(pass);
      sweep.direction.push_back(1);
    }
  }
  return sweep;
}

Result<angle::CalibrationRun> calibrated(const angle::Sweep& sweep) { return angle::calibrate(sweep, {}, {}); }

} // namespace

void ReviewTest::neighboursForetellSmoothData() {
  const angle::Sweep sweep = smoothSweep(72);
  const auto run = calibrated(sweep);
  QVERIFY(run.has_value());
  const auto analysis = analyseForReview(sweep, &*run);
  QVERIFY(analysis.has_value());
  QVERIFY(analysis->fromNeighbours);
  QVERIFY(analysis->outliers.empty());
  QVERIFY(analysis->spreadDeg < 0.01);
}

void ReviewTest::outlierAmongNeighboursIsFoundAlone() {
  const angle::Sweep sweep = smoothSweep(72, 17);
  const auto run = calibrated(sweep);
  QVERIFY(run.has_value());
  const auto analysis = analyseForReview(sweep, &*run);
  QVERIFY(analysis.has_value());
  QCOMPARE(analysis->outliers, std::vector<std::size_t>{17});
  QVERIFY(std::abs(analysis->rows[17].residualDeg + 2.0) < 0.4); // 2° too small, read off at a reading 2° further on
}

void ReviewTest::outlierAboutRegressionIsFound() {
  const angle::Sweep sweep = smoothSweep(64, 9, 3);
  const auto run = calibrated(sweep);
  QVERIFY(run.has_value());
  QCOMPARE(run->curve.method, angle::CurveMethod::Regress);
  const auto analysis = analyseForReview(sweep, &*run);
  QVERIFY(analysis.has_value());
  QVERIFY(!analysis->fromNeighbours);
  QCOMPARE(analysis->outliers, std::vector<std::size_t>{9});
}

void ReviewTest::refusedSweepHasErrorsOnly() {
  const angle::Sweep sweep = smoothSweep(5);
  const auto analysis = analyseForReview(sweep, nullptr);
  QVERIFY(analysis.has_value());
  QCOMPARE(analysis->rows.size(), std::size_t{5});
  QVERIFY(std::abs(analysis->rows[0].errorDeg - 30.0) < 0.01);
  QVERIFY(std::isnan(analysis->rows[0].residualDeg));
  QVERIFY(analysis->outliers.empty());
}

void ReviewTest::pointsGoOffAndComeBack() {
  OpenCalibration open;
  ReviewPresenter presenter(open.document, open.jobs);
  QVERIFY(!presenter.missing().isEmpty());
  open.document.setSweep(smoothSweep(72, 17), QStringLiteral("import"));
  QTRY_COMPARE(presenter.outliers(), std::vector<std::size_t>{17});
  QVERIFY(presenter.missing().isEmpty());
  presenter.toggle(presenter.outliers());
  QVERIFY(!open.document.sweep().isEnabled(17));
  QCOMPARE(presenter.switchedOff(), std::size_t{1});
  QTRY_VERIFY(presenter.outliers().empty());
  QCOMPARE(presenter.facts().front().value, QStringLiteral("71 of 72"));
  open.document.undoStack().undo();
  QVERIFY(open.document.sweep().isEnabled(17));
  presenter.setEnabled({1, 2}, false);
  presenter.setEnabled({1, 2}, false); // nothing changes: no second step to undo
  QCOMPARE(open.document.undoStack().index(), 2);
  presenter.toggle({2, 3}); // one is on: both go off
  QCOMPARE(presenter.switchedOff(), std::size_t{3});
  presenter.switchAllOn();
  QCOMPARE(presenter.switchedOff(), std::size_t{0});
}

void ReviewTest::plotPointsLeadToRows() {
  OpenCalibration open;
  ReviewPresenter presenter(open.document, open.jobs);
  open.document.setSweep(smoothSweep(72, 17), QStringLiteral("import"));
  QTRY_VERIFY(!presenter.outliers().empty());
  presenter.setSelection({40});
  using View = ReviewPresenter::View;
  for (const View view : {View::Error, View::Unwrapped, View::Residual}) {
    const PlotSpec spec = presenter.plot(view);
    bool selectedFound = false;
    for (int series = 0; series < spec.series.size(); ++series) {
      if (spec.series[series].style == SeriesStyle::Line) {
        QVERIFY(!presenter.rowAt(view, series, 0));
        continue;
      }
      for (int i = 0; i < spec.series[series].x.size(); ++i) {
        const auto row = presenter.rowAt(view, series, i);
        QVERIFY(row.has_value());
        QVERIFY(std::abs(spec.series[series].x[i] - open.document.sweep().encoderDeg[*row]) < 1e-9);
        selectedFound = selectedFound || (spec.series[series].name == QStringLiteral("Selected") && *row == 40);
      }
    }
    QVERIFY(selectedFound);
    QVERIFY(!presenter.rowAt(view, 99, 0));
  }
  QVERIFY(!presenter.rowAt(View::Noise, 0, 0));
}

void ReviewTest::refusalIsANotice() {
  OpenCalibration open;
  ReviewPresenter presenter(open.document, open.jobs);
  QSignalSpy ran(&open.document, &AngleDocument::runChanged);
  open.document.setSweep(smoothSweep(5), QStringLiteral("import"));
  QTRY_VERIFY(open.document.runError().has_value());
  QTRY_VERIFY(!presenter.notices().isEmpty());
  QCOMPARE(presenter.notices().front().level, Notice::Level::Problem);
  QVERIFY(presenter.notices().front().text.contains(QString::fromStdString(open.document.runError()->message())));
}

void ReviewTest::tableCopiesEveryDigit() {
  angle::Sweep sweep = smoothSweep(8);
  sweep.sensorDeg[3] = 0.1 + 0.2;
  sweep.enabled.assign(8, true);
  sweep.enabled[3] = false;
  ReviewTableModel model;
  model.setSweep(sweep);
  QCOMPARE(model.asText({3}),
           QStringLiteral("Row\tTurn\tDirection\tEncoder (°)\tSensor (°)\tError (°)\tResidual (°)\tRemark\n"
                          "4\t1\trising\t135\t0.30000000000000004\t\t\tswitched off\n"));
  QSignalSpy asked(&model, &ReviewTableModel::enableRequested);
  QVERIFY(model.setData(model.index(3, ReviewTableModel::Row), Qt::Checked, Qt::CheckStateRole));
  QCOMPARE(asked.count(), 1);
  QCOMPARE(asked.first()[1].toBool(), true);
}

void ReviewTest::hundredThousandRows() {
  OpenCalibration open;
  ReviewPresenter presenter(open.document, open.jobs);
  open.document.setSweep(smoothSweep(10000, 1234, 10), QStringLiteral("import"));
  QTRY_COMPARE_WITH_TIMEOUT(presenter.outliers(), std::vector<std::size_t>{1234}, 120000);
  QCOMPARE(presenter.table().rowCount(), 100000);
}

std::unique_ptr<QObject> makeReviewTest() { return std::make_unique<ReviewTest>(); }

} // namespace straightedge::gui

#include "review_test.moc"
