// Field figures, report, export and --render on the example campaign. Expected figures were
// computed independently (tests/data/field) or are taken from the run that the plot shows.
#include "app/gui/figures/export_files.h"
#include "app/gui/figures/field_axis_figures.h"
#include "app/gui/figures/field_campaign_figures.h"
#include "app/gui/figures/field_cost_figures.h"
#include "app/gui/figures/field_nonlinearity_figures.h"
#include "app/gui/figures/field_render.h"
#include "app/gui/figures/field_report_tables.h"
#include "app/gui/figures/field_scene_figures.h"
#include "app/gui/figures/field_sensitivity_figures.h"
#include "app/gui/figures/field_surface_figures.h"
#include "app/gui/figures/field_temperature_figures.h"
#include "app/gui/figures/field_verification_figures.h"
#include "app/gui/figures/picture_files.h"
#include "app/gui/figures/render_command.h"
#include "app/gui/figures/report_html.h"
#include "app/gui/figures/report_pdf.h"
#include "app/gui/figures/scene_pictures.h"
#include "core/export/field_calibration_json.h"
#include "tests/app/gui/figures/field_example.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>

using namespace straightedge;
using namespace straightedge::gui;
using gui::testing::fieldExample;

namespace {

QByteArray bytesIn(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

bool writeBytes(const QString& file, const std::string& text) {
  QFile out(file);
  return out.open(QIODevice::WriteOnly) && out.write(QByteArray::fromStdString(text)) >= 0;
}

QStringList namesBelow(const QString& folder) {
  QStringList names;
  QDirIterator each(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
  while (each.hasNext()) {
    names << QDir(folder).relativeFilePath(each.next());
  }
  names.sort();
  return names;
}

QStringList stemsOf(const FieldResults& results) {
  QStringList stems;
  for (const NamedFigure& figure : fieldFigures(std::make_shared<FieldResults>(results))) {
    stems << figure.stem;
  }
  return stems;
}

/// "Table 3" or "Figure 3" as they occur in a report, in order.
QStringList numbered(const ReportContent& content, const QString& word) {
  QStringList numbers;
  for (const ReportBlock& block : content.blocks) {
    QString caption;
    if (const auto* table = std::get_if<ReportTable>(&block)) {
      caption = table->caption;
    } else if (const auto* figure = std::get_if<ReportFigure>(&block)) {
      caption = figure->caption;
    }
    if (caption.startsWith(word + QLatin1Char(' '))) {
      numbers << caption.section(QLatin1Char('.'), 0, 0);
    }
  }
  return numbers;
}

double largestOf(const QList<double>& values) {
  double largest = 0.0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

} // namespace

class FieldFiguresTest : public QObject {
  Q_OBJECT

private slots:
  void everyFigureIsWhole();
  void withoutTheRunOnlyWhatTheFileHolds();
  void residualsAreThoseOfTheOrders();
  void plateauFitRunsThroughThePlateaus();
  void probeLoopKeepsEveryRow();
  void slopesLieOnTheirPolynomial();
  void sweepErrorsLieOnTheirLines();
  void blocksTakeTheErrorAway();
  void verificationHasTheStatedPeaks();
  void surfaceHoldsTheMeans();
  void surfacesCanBeCompared();
  void probeFiguresTakeTheLagAway();
  void axisDirectionsStateTheirAngles();
  void orientationsAreThoseThatCount();
  void reportShowsPicturesInSpace();
  void tiltsAreThoseOfTheMatrix();
  void storagePointsStandForChoices();
  void campaignPointsStandForRows();
  void blocksOffAreSaid();
  void reportIsNumberedAndWhole();
  void exportWritesFilesThatRead();
  void renderDrawsWithTheCampaign();
  void renderDrawsWhatTheFileHolds();
  void renderRefusesAnotherCampaign();
  void renderTakesACalibrationWithBlocksOff();
};

void FieldFiguresTest::everyFigureIsWhole() {
  const QList<NamedFigure> figures = fieldFigures(fieldExample());
  QCOMPARE(figures.size(), 39 + 2 + 3 * 3); // in space: directions, orientations, three surfaces of each axis
  QStringList stems;
  for (const NamedFigure& figure : figures) {
    const QByteArray context = figure.stem.toUtf8();
    QVERIFY2(!stems.contains(figure.stem), context.constData());
    stems << figure.stem;
    if (figure.isScene()) {
      const SceneSpec scene = figure.scene();
      QVERIFY2(!isEmptyScene(scene) && !sceneTitle(scene).isEmpty() && !figure.caption.isEmpty(), context.constData());
      continue;
    }
    const PlotSpec spec = figure.make();
    QVERIFY2(!spec.title.isEmpty() && !spec.note.isEmpty() && !figure.caption.isEmpty(), context.constData());
    QVERIFY2(!spec.x.title.isEmpty() && !spec.y.title.isEmpty(), context.constData());
    QVERIFY2(!spec.series.isEmpty(), context.constData());
    QVERIFY2(!spec.note.contains(QRegularExpression("(^|[ (])-[0-9]")), context.constData()); // a hyphen is no minus
    for (const PlotSeries& series : spec.series) {
      QVERIFY2(series.x.size() == series.y.size() && !series.x.isEmpty(), context.constData());
      QVERIFY2(!series.rightAxis || spec.right.has_value(), context.constData());
      QVERIFY2(std::ranges::all_of(series.x, [](double x) { return std::isfinite(x); }), context.constData());
    }
  }
}

void FieldFiguresTest::withoutTheRunOnlyWhatTheFileHolds() {
  FieldResults results;
  results.calibration = fieldExample()->calibration;
  QCOMPARE(stemsOf(results),
           QStringList({"nonlinearity-orders", "axis-tilts", "axis-directions", "verification-blocks", "uncertainty"}));
}

void FieldFiguresTest::residualsAreThoseOfTheOrders() {
  const auto& report = *fieldExample()->run->reports.nonlinearity[1];
  const PlotSpec spec = orderResidualsFigure(report);
  QCOMPARE(spec.series.size(), 7);
  for (qsizetype i = 0; i < 7; ++i) {
    QCOMPARE(largestOf(spec.series[i].y), report.orders[static_cast<std::size_t>(i)].maxErrorPercent);
    QVERIFY(std::ranges::is_sorted(spec.series[i].x));
  }
  QVERIFY(!spec.series[0].visible); // 2 % beside 0.01 %
  QVERIFY(spec.series[4].visible && spec.series[4].name.contains("chosen"));
  const PlotSpec largest = largestErrorsFigure(fieldExample()->calibration.orders, 5);
  QCOMPARE(largest.series.size(), 6);
  QVERIFY(largest.y.logarithmic);
  QCOMPARE(largest.series[2].y[4], report.orders[4].maxErrorPercent); // y, order 5
}

void FieldFiguresTest::plateauFitRunsThroughThePlateaus() {
  const auto& report = *fieldExample()->run->reports.nonlinearity[0];
  const PlotSpec spec = plateauFitFigure(report);
  QCOMPARE(spec.series[0].x.size(), static_cast<qsizetype>(report.plateaus.plateaus.size()));
  QVERIFY(std::abs(largestOf(spec.series[2].y) - report.block.residuals.largest * 1e6) < 1e-6);
}

void FieldFiguresTest::probeLoopKeepsEveryRow() {
  const auto& report = *fieldExample()->run->reports.probeTemperature;
  const PlotSpec spec = probeLoopFigure(report, 24.0);
  qsizetype points = 0;
  for (qsizetype branch = 0; branch < 2; ++branch) {
    points += std::ranges::count_if(spec.series[branch].y, [](double y) { return std::isfinite(y); });
    QVERIFY(spec.series[branch].y.size() > 300); // two cycles: about as much of each
  }
  QCOMPARE(points, report.ohm.size());
}

void FieldFiguresTest::slopesLieOnTheirPolynomial() {
  const field::FieldRun& run = *fieldExample()->run;
  const PlotSpec spec = sweepSlopesFigure(run, SweptTemperature::Probe);
  QCOMPARE(spec.series.size(), 9); // line, points and straight line of each axis
  QCOMPARE(spec.series[1].y[0], run.reports.sensitivity[0]->sweeps[0].slope * 1e6);
  QCOMPARE(spec.series[1].x.size(), 6);
  QVERIFY(spec.series[2].dashed);
  QCOMPARE(sweepInterceptsFigure(run).series.size(), 6);
  QCOMPARE(sweepSlopesFigure(run, SweptTemperature::Electronics).series[1].x.size(), 4);
}

void FieldFiguresTest::sweepErrorsLieOnTheirLines() {
  const field::FieldRun& run = *fieldExample()->run;
  const PlotSpec spec = sweepErrorsFigure(run, field::Axis::Y, SweptTemperature::Probe);
  QCOMPARE(spec.series.size(), 12);
  QCOMPARE(spec.series[0].x.size(), 240);
  // Least squares: the points scatter evenly about the line drawn with them.
  const PlotSeries& points = spec.series[0];
  const PlotSeries& line = spec.series[6];
  const double slope = (line.y[1] - line.y[0]) / (line.x[1] - line.x[0]);
  double sum = 0.0;
  double largest = 0.0;
  for (qsizetype i = 0; i < points.x.size(); ++i) {
    const double residual = points.y[i] - (line.y[0] + slope * (points.x[i] - line.x[0]));
    sum += residual;
    largest = std::max(largest, std::abs(residual));
  }
  QVERIFY(largest > 0.0);
  QVERIFY(std::abs(sum / 240.0) < 1e-6 * largest);
}

void FieldFiguresTest::blocksTakeTheErrorAway() {
  const PlotSpec spec = blockAfterBlockFigure(*fieldExample()->run, field::Axis::Y);
  QVERIFY(spec.title.contains("0.30 T"));
  QCOMPARE(spec.series.size(), 4);
  QVERIFY(spec.series[0].rightAxis);
  const auto spread = [](const PlotSeries& series) {
    const auto [low, high] = std::ranges::minmax(series.y);
    return high - low;
  };
  QVERIFY(largestOf(spec.series[1].y) < 0.1 * largestOf(spec.series[0].y)); // Figure 20
  QVERIFY(spread(spec.series[3]) < 0.5 * spread(spec.series[2]));           // Figure 21
}

void FieldFiguresTest::verificationHasTheStatedPeaks() {
  const FieldResults& results = *fieldExample();
  const PlotSpec spec = fieldBeforeAfterFigure(results.run->verification.errors[1], 2.0, 0.05);
  const auto calibrated = std::ranges::find_if(results.calibration.verification, [](const field::VerificationRow& row) {
    return row.axis == field::Axis::Y && row.state == field::VerifiedState::Calibrated;
  });
  QVERIFY(std::abs(largestOf(spec.series[1].y) - calibrated->ofFullScale.peak) < 1e-9);
  QCOMPARE(spec.guides.size(), 2);
  QVERIFY(spec.series[0].rightAxis);
  const PlotSpec peaks = blockPeaksFigure(results.calibration.verification);
  QCOMPARE(peaks.series.size(), 3);
  QVERIFY(peaks.series[1].y.front() > 10.0 * peaks.series[1].y.back());
}

void FieldFiguresTest::surfaceHoldsTheMeans() {
  const field::AxisErrors& errors = fieldExample()->run->verification.errors[2];
  const SurfaceSpec before = residualSurface(errors, 2.0, 24.0, CorrectionState::Before);
  const SurfaceSpec after = residualSurface(errors, 2.0, 24.0, CorrectionState::After);
  QVERIFY(!before.isEmpty() && !after.isEmpty());
  QCOMPARE(before.x.size(), 20); // fields of the verification
  QCOMPARE(before.y.size(), 5);  // temperatures that were held
  QVERIFY(std::ranges::all_of(after.z, [](double z) { return std::isfinite(z); }));
  QVERIFY(std::ranges::is_sorted(before.x) && std::ranges::is_sorted(before.y));
  QVERIFY(before.y.front() > 17.0 && before.y.back() < 32.0);
  QVERIFY(largestOf(before.z) <= 50.0 * errors.beforeT.cwiseAbs().maxCoeff()); // a mean is no larger than the largest
  QVERIFY(largestOf(after.z) < 0.1 * largestOf(before.z));
  field::AxisErrors swept = errors;
  swept.probeC = Eigen::VectorXd::LinSpaced(errors.probeC.size(), -6.0, 6.0);
  QCOMPARE(residualSurface(swept, 2.0, 24.0, CorrectionState::After).y.size(), 8);
  field::AxisErrors one = errors;
  one.referenceT.setConstant(0.5);
  QVERIFY(residualSurface(one, 2.0, 24.0, CorrectionState::After).isEmpty());
}

void FieldFiguresTest::surfacesCanBeCompared() {
  const field::AxisErrors& errors = fieldExample()->run->verification.errors[0];
  const SurfaceSpec before = residualSurface(errors, 2.0, 24.0, CorrectionState::Before);
  const SurfaceSpec after = residualSurface(errors, 2.0, 24.0, CorrectionState::After);
  const SurfaceSpec enlarged = residualSurface(errors, 2.0, 24.0, CorrectionState::After, SurfaceScale::Own);
  QCOMPARE(before.colors, SurfaceColors::DivergingFromZero);
  QVERIFY(before.zRange && after.zRange == before.zRange);
  QCOMPARE(before.zRange->first, -before.zRange->second); // blue and red weigh the same
  QCOMPARE(before.zRange->second, std::max(largestOf(before.z), largestOf(after.z)));
  QCOMPARE(enlarged.zRange->second, largestOf(after.z));
  QCOMPARE(enlarged.z, after.z);
  QCOMPARE(before.zTitle, QString("Error (% of full scale)"));
}

void FieldFiguresTest::probeFiguresTakeTheLagAway() {
  // No times: the loop is all there is, about the line, within the range of the stated uncertainty.
  const field::ProbeTemperatureReport& untimed = *fieldExample()->run->reports.probeTemperature;
  QCOMPARE(probeLoopFigure(untimed, 24.0).series.size(), 3);
  const PlotSpec loop = probeResidualFigure(untimed, 24.0);
  QVERIFY(loop.title.contains("Hysteresis") && loop.y.title.startsWith("Chamber − line"));
  QVERIFY(loop.note.contains("2.7 °C wide") && loop.note.contains("1.3 °C"));
  // With times the line belongs to what the probe felt, and that is what is drawn about it.
  const auto campaign = field::readCampaignCsv(STRAIGHTEDGE_TEST_DATA "/../../resources/examples/"
                                                                      "hall_probe_campaign.csv");
  QVERIFY(campaign);
  const auto results = gui::testing::makeFieldResults(*campaign);
  const field::ProbeTemperatureReport& timed = *results->run->reports.probeTemperature;
  QVERIFY(timed.lagS);
  const PlotSpec swept = probeLoopFigure(timed, 24.0);
  QCOMPARE(swept.series.size(), 4);
  QVERIFY(swept.series[2].name.contains("felt"));
  const PlotSeries& line = swept.series[3];
  const double slope = (line.y[1] - line.y[0]) / (line.x[1] - line.x[0]);
  double offLine = 0.0;
  for (qsizetype i = 0; i < swept.series[2].x.size(); ++i) {
    const double x = swept.series[2].x[i];
    offLine = std::max(offLine, std::abs(swept.series[2].y[i] - line.y[0] - slope * (x - line.x[0])));
  }
  QVERIFY2(offLine < 4.0 * timed.standardUncertaintyC, qPrintable(QString::number(offLine)));
  const PlotSpec left = probeResidualFigure(timed, 24.0);
  QVERIFY(left.title.contains("lag taken away") && left.y.title.startsWith("Chamber behind the lag − line"));
  double widest = 0.0;
  for (const PlotSeries& branch : {left.series[0], left.series[1]}) {
    for (const double y : branch.y) {
      widest = std::isfinite(y) ? std::max(widest, std::abs(y)) : widest;
    }
  }
  QVERIFY(std::abs(widest - offLine) < 1e-9);
  QVERIFY(widest < 0.2 * *timed.hysteresisC); // the recorded loop is another matter
  QVERIFY(left.note.contains("lag") && left.note.contains("taken away"));
}

void FieldFiguresTest::axisDirectionsStateTheirAngles() {
  Eigen::Matrix3d matrix;
  matrix << 0.99998, 0.012, -0.009, -0.015, 0.99998, 0.011, 0.008, -0.013, 0.99998;
  const DirectionsSpec spec = axisDirections(matrix);
  // atan(√(0.012² + 0.009²)/0.99998) = 0.85944°, atan(√(0.015² + 0.011²)/0.99998) = 1.06569°, 0.87454°
  QCOMPARE(spec.directions[0].label, QString("x, tilted by 0.86°"));
  QCOMPARE(spec.directions[1].label, QString("y, tilted by 1.07°"));
  QCOMPARE(spec.directions[2].label, QString("z, tilted by 0.87°"));
  QCOMPARE(spec.exaggeration, 20.0); // 21°: 25°/1.07° is 23, and 20 is the next below of 1, 2, 5
  // acos of the rows' products: x·y = −0.003099, x·z = −0.001156, y·z = −0.002120
  QVERIFY2(spec.note.contains("20 times as large") && spec.note.contains("x and y 90.18°") &&
               spec.note.contains("x and z 90.07°") && spec.note.contains("y and z 90.12°"),
           qPrintable(spec.note));
  QCOMPARE(spec.directions[1].measured[0], -0.015);
  QVERIFY(axisDirections(Eigen::Matrix3d::Identity()).note.startsWith("Tilts are drawn as they are"));
  const DirectionsSpec ofExample = axisDirections(*fieldExample()->calibration.chain.axisMatrix);
  QCOMPARE(ofExample.directions[1].label, spec.directions[1].label); // the reference gives this matrix
}

void FieldFiguresTest::orientationsAreThoseThatCount() {
  field::Campaign campaign = *fieldExample()->campaign;
  std::vector<bool> enabled(campaign.rows.size(), true);
  std::size_t off = 0;
  for (std::size_t i = 0; i < campaign.rows.size(); ++i) {
    field::CampaignRow& row = campaign.rows[i];
    if (row.step != field::CampaignStep::Orientation) {
      continue;
    }
    if (row.orientation == field::Orientation::PlusY && off < 3) {
      enabled[i] = false;
      ++off;
    } else if (row.orientation == field::Orientation::MinusZ) {
      row.locked = false;
    }
  }
  const auto covered = orientationsCovered(campaign, enabled);
  QCOMPARE(covered[0].rows, std::size_t(90));
  QCOMPARE(covered[2].rows, std::size_t(87));
  QCOMPARE(covered[5].rows, std::size_t(0));
  const SphereSpec spec = orientationSphere(covered);
  QCOMPARE(spec.note, QString("5 of 6 directions were measured"));
  QCOMPARE(spec.marks[1].name, QString("−x"));
  QCOMPARE(spec.marks[1].direction[0], -1.0);
  QCOMPARE(spec.marks[1].detail, QString("90 rows, 0.5 to 1.5 T"));
  QVERIFY(!spec.marks[5].covered && spec.marks[5].detail == "not measured");
  QVERIFY(orientationSphere(orientationsCovered({})).isEmpty());
}

void FieldFiguresTest::reportShowsPicturesInSpace() {
  auto results = std::make_shared<FieldResults>();
  results->calibration = fieldExample()->calibration; // one figure in space: the directions
  ScenePictures pictures;
  const ReportContent content = fieldReport(results, &pictures);
  QVERIFY2(pictures.problem().isEmpty(), qPrintable(pictures.problem()));
  QImage drawn;
  for (const ReportBlock& block : content.blocks) {
    const auto* figure = std::get_if<ReportFigure>(&block);
    if (figure != nullptr && !figure->png.isEmpty()) {
      drawn = QImage::fromData(figure->png, "PNG");
      QVERIFY(figure->caption.contains("arrows"));
    }
  }
  QCOMPARE(drawn.size(), QSize(1920, 1080)); // twice as many pixels as the size in the report
  QVERIFY(reportAsHtml(content).contains("data:image/png;base64,"));
  QVERIFY(reportAsPdf(content).startsWith("%PDF"));
  QVERIFY(!reportAsHtml(fieldReport(results)).contains("image/png")); // not asked for, not mentioned
  QVERIFY(!reportAsHtml(fieldReport(results)).contains("three-dimensional"));
}

void FieldFiguresTest::tiltsAreThoseOfTheMatrix() {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(1, 2) = std::tan(0.01); // y leans towards z
  QVERIFY(std::abs(axisTiltsDeg(matrix)[1] - 0.01 * 180.0 / M_PI) < 1e-12);
  QVERIFY(std::abs(anglesBetweenAxesDeg(matrix)[2] - (90.0 - 0.01 * 180.0 / M_PI)) < 1e-12);
  const auto& report = *fieldExample()->run->reports.axisMatrix;
  const Eigen::Vector3d between = anglesBetweenAxesDeg(report.matrix);
  for (Eigen::Index i = 0; i < 3; ++i) {
    QVERIFY(std::abs(between[i] - report.angleBetweenDeg.at(static_cast<std::size_t>(i))) < 1e-9);
    QVERIFY(std::abs(axisTiltsDeg(report.matrix)[i] - report.tiltDeg.at(static_cast<std::size_t>(i))) < 1e-6);
  }
  QCOMPARE(axisTiltsFigure(matrix).series[1].x[1], 0.01 * 180.0 / M_PI);
}

void FieldFiguresTest::storagePointsStandForChoices() {
  const field::StorageComparison& comparison = *fieldExample()->comparison;
  const StorageFigure figure = storageFigure(comparison, ChainCost::Multiplications, 5, 3);
  std::size_t shown = 0;
  int emphasised = 0;
  for (std::size_t s = 0; s < figure.choices.size(); ++s) {
    const PlotSeries& series = figure.spec.series[static_cast<qsizetype>(s)];
    for (std::size_t i = 0; i < figure.choices[s].size(); ++i) {
      const field::StorageChoice& choice = comparison.choices[figure.choices[s][i]];
      QCOMPARE(series.x[static_cast<qsizetype>(i)], static_cast<double>(choice.size.multiplications));
      QCOMPARE(series.y[static_cast<qsizetype>(i)], choice.largestPeakPercent);
      ++shown;
    }
    emphasised += static_cast<int>(series.emphasised.count(true));
  }
  QCOMPARE(shown, comparison.choices.size());
  QCOMPARE(emphasised, 1);
}

void FieldFiguresTest::campaignPointsStandForRows() {
  const field::Campaign& campaign = *fieldExample()->campaign;
  std::vector<bool> enabled(campaign.rows.size(), true);
  enabled[1] = false;
  const RowFigure figure = campaignStepFigure(campaign, field::CampaignStep::Nonlinearity, enabled);
  QCOMPARE(figure.rows.size(), std::size_t(3));
  QCOMPARE(figure.spec.series[0].emphasised.count(true), 1);
  for (std::size_t s = 0; s < 3; ++s) {
    for (std::size_t i = 0; i < figure.rows[s].size(); ++i) {
      const field::CampaignRow& row = campaign.rows[figure.rows[s][i]];
      QVERIFY(row.locked);
      QCOMPARE(figure.spec.series[static_cast<qsizetype>(s)].y[static_cast<qsizetype>(i)], row.rawT.at(s));
    }
  }
}

void FieldFiguresTest::blocksOffAreSaid() {
  field::Campaign campaign = gui::testing::exampleCampaign();
  std::erase_if(campaign.rows, [](const field::CampaignRow& row) {
    return row.step == field::CampaignStep::Sensitivity || row.step == field::CampaignStep::Orientation ||
           row.step == field::CampaignStep::Verification;
  });
  const auto results = gui::testing::makeFieldResults(campaign);
  const QStringList stems = stemsOf(*results);
  QVERIFY(stems.contains("offset") && stems.contains("electronics-slopes"));
  QVERIFY(!stems.contains("sensitivity-slopes") && !stems.contains("axis-tilts") && !stems.contains("verification-x"));
  const QByteArray html = reportAsHtml(fieldReport(results));
  QVERIFY(html.contains("is off"));
  QVERIFY(html.contains("grows with the field")); // what it costs
  QVERIFY(html.contains("was not measured"));
  QVERIFY(sweepErrorsFigure(*results->run, field::Axis::X, SweptTemperature::Probe).note.contains("off"));
  QVERIFY(blockAfterBlockFigure(*results->run, field::Axis::X).note.contains("off"));
}

void FieldFiguresTest::reportIsNumberedAndWhole() {
  const ReportContent content = fieldReport(fieldExample());
  QCOMPARE(content.subtitle, QString("MFC <3> · 0007"));
  const QStringList figures = numbered(content, "Figure");
  const QList<NamedFigure> all = fieldFigures(fieldExample());
  QCOMPARE(figures.size(), std::ranges::count_if(all, [](const NamedFigure& each) { return !each.isScene(); }));
  QCOMPARE(figures.last(), QString("Figure %1").arg(figures.size()));
  QVERIFY(numbered(content, "Table").size() >= 9);
  for (const ReportBlock& block : content.blocks) {
    if (const auto* table = std::get_if<ReportTable>(&block)) {
      for (const QStringList& row : table->rows) {
        QVERIFY2(table->header.isEmpty() ? row.size() == 2 : row.size() == table->header.size(),
                 qPrintable(table->caption));
      }
    }
  }
  const QByteArray html = reportAsHtml(content);
  QVERIFY(html.contains("MFC &lt;3&gt;") && html.contains("Passed:"));
  QVERIFY(html.contains("campaign.csv"));
  const QByteArray pdf = reportAsPdf(content);
  QVERIFY(pdf.startsWith("%PDF") && pdf.count("/Type /Page\n") >= 15);
  QCOMPARE(ordersTable(fieldExample()->calibration).rows.size(), 7);
}

void FieldFiguresTest::exportWritesFilesThatRead() {
  const QTemporaryDir folder;
  const ExportChoices choices{.plotsSvg = true, .plotsPdf = true, .reportPdf = false, .reportHtml = true};
  auto results = std::make_shared<FieldResults>(*fieldExample());
  results->run = nullptr; // few figures: this is about the files
  results->verification.reset();
  results->comparison.reset();
  results->campaign = std::make_shared<const field::Campaign>(field::Campaign{
      "few.csv", "", {fieldExample()->campaign->rows.begin(), fieldExample()->campaign->rows.begin() + 40}});
  const auto written = writeFiles(filesToWrite(results, choices), folder.path(), {});
  QVERIFY(written);
  QCOMPARE(written->size(), namesBelow(folder.path()).size());
  QVERIFY(exporting::readFieldCalibration(folder.filePath("calibration.json").toStdString()));
  QCOMPARE(field::readCampaignCsv(folder.filePath("campaign.csv").toStdString())->rows.size(), std::size_t(40));
  QVERIFY(bytesIn(folder.filePath("coefficients.csv")).startsWith("block,axis,name,power,value,unit"));
  QVERIFY(written->contains("sensitivity.csv") && written->contains("plots/campaign-nonlinearity.pdf"));
  for (const QString& name : *written) {
    const QString path = folder.filePath(name);
    if (name.endsWith(".png")) {
      QVERIFY2(!QImage(path).isNull(), qPrintable(name));
    } else if (name.endsWith(".svg")) {
      QXmlStreamReader xml(bytesIn(path));
      while (!xml.atEnd()) {
        xml.readNext();
      }
      QVERIFY2(!xml.hasError(), qPrintable(name + ": " + xml.errorString()));
    }
  }
}

void FieldFiguresTest::renderDrawsWithTheCampaign() {
  const QTemporaryDir folder;
  const QString file = folder.filePath("calibration.json");
  QVERIFY(writeBytes(file, exporting::fieldCalibrationToJson(fieldExample()->calibration)));
  const auto results =
      fieldResultsOf(exporting::readFieldCalibration(file.toStdString()).value(), gui::testing::fieldExampleFile());
  QVERIFY(results);
  QVERIFY((*results)->run && (*results)->comparison && (*results)->campaign);
  QCOMPARE(fieldFigures(*results).size(), fieldFigures(fieldExample()).size());
  QCOMPARE(renderCalibration({file, "--out", folder.filePath("out"), "--report", "--campaign",
                              QString::fromStdString(gui::testing::fieldExampleFile())}),
           0);
  QCOMPARE(namesBelow(folder.filePath("out")), QStringList({"report.html", "report.pdf"}));
  QCOMPARE(renderCalibration({file, "--out", folder.filePath("no"), "--comparison", "comparison.csv"}), 2);
}

void FieldFiguresTest::renderDrawsWhatTheFileHolds() {
  const QTemporaryDir folder;
  const QString file = folder.filePath("calibration.json");
  QVERIFY(writeBytes(file, exporting::fieldCalibrationToJson(fieldExample()->calibration)));
  QCOMPARE(renderCalibration({file, "--out", folder.filePath("out")}), 0);
  QStringList expected{"report.html", "report.pdf"};
  expected << "plots/axis-directions.png";
  for (const char* stem : {"axis-tilts", "nonlinearity-orders", "uncertainty", "verification-blocks"}) {
    for (const char* suffix : {"png", "svg", "pdf"}) {
      expected << QString("plots/%1.%2").arg(stem, suffix);
    }
  }
  expected.sort();
  QCOMPARE(namesBelow(folder.filePath("out")), expected);
}

void FieldFiguresTest::renderRefusesAnotherCampaign() {
  const QTemporaryDir folder;
  const QString file = folder.filePath("calibration.json");
  QVERIFY(writeBytes(file, exporting::fieldCalibrationToJson(fieldExample()->calibration)));
  field::Campaign other = *fieldExample()->campaign;
  for (field::CampaignRow& row : other.rows) {
    row.rawT[1] *= 1.001;
  }
  QVERIFY(writeBytes(folder.filePath("other.csv"), field::campaignCsv(other)));
  QCOMPARE(renderCalibration({file, "--out", folder.filePath("out"), "--campaign", folder.filePath("other.csv")}), 3);
  QVERIFY(!QDir(folder.filePath("out")).exists());
}

void FieldFiguresTest::renderTakesACalibrationWithBlocksOff() {
  field::Campaign without = *fieldExample()->campaign;
  std::erase_if(without.rows, [](const field::CampaignRow& row) { return row.step == field::CampaignStep::Offset; });
  const auto off = gui::testing::makeFieldResults(without);
  // the whole campaign, but a calibration whose offset was switched off
  const auto results = fieldResultsOf(off->calibration, gui::testing::fieldExampleFile());
  QVERIFY2(results, results ? "" : results.error().message().c_str());
  QVERIFY(!stemsOf(**results).contains("offset"));
}

QTEST_MAIN(FieldFiguresTest)
#include "field_figures_test.moc"
