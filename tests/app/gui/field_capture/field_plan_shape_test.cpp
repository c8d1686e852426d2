#include "app/gui/field_steps/capture_stages.h"
#include "app/gui/field_steps/field_live_trace.h"
#include "app/gui/field_steps/field_plan_form.h"
#include "app/gui/field_steps/field_plan_shape.h"
#include "tests/app/gui/field_capture/open_campaign.h"
#include "tests/app/gui/field_capture/test_classes.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>

namespace straightedge::gui {

using devices::FieldPlanShape;
using field::CampaignStep;

/// Plans as numbers and back, the form over them, how stages are listed and drawn: no bench.
class FieldPlanShapeTest : public QObject {
  Q_OBJECT
private slots:
  void shapesComeBack_data();
  void shapesComeBack();
  void foreignPlanIsSaidToBeOne();
  void leftOutStagesStayLeftOut();
  void formEditsOneThing();
  void formKeepsOneStepAndOneAxis();
  void stagesSayHowFarTheyAre();
  void stagesBySamples();
  void traceShowsTheLatestAttempt();
  void traceStaysLight();
};

void FieldPlanShapeTest::shapesComeBack_data() {
  QTest::addColumn<FieldPlanShape>("shape");
  QTest::newRow("usual") << FieldPlanShape{};
  FieldPlanShape shape;
  shape.steps = {CampaignStep::Nonlinearity, CampaignStep::Sensitivity, CampaignStep::Verification};
  shape.axes = {field::Axis::X, field::Axis::Z};
  QTest::newRow("some steps and axes") << shape;
  shape = {};
  shape.fieldsT = evenFieldsT(1.5, 0.25);
  shape.rows = 5;
  shape.sweepRows = 60;
  shape.lowC = 15.0;
  shape.highC = 30.0;
  shape.rowS = 2.0;
  shape.settleS = 1.0;
  shape.temperatureSettleS = 60.0;
  shape.lockTimeoutS = 12.0;
  QTest::newRow("every number") << shape;
  shape = {};
  shape.steps = {CampaignStep::Offset};
  shape.sweepRows = 30;
  QTest::newRow("one sweep") << shape;
}

void FieldPlanShapeTest::shapesComeBack() {
  QFETCH(FieldPlanShape, shape);
  const devices::FieldPlan plan = devices::makeFieldPlan(shape);
  const ShapedPlan found = shapeOf(plan);
  QVERIFY(found.exact);
  QCOMPARE(devices::makeFieldPlan(found.shape), plan);
  QCOMPARE(found.shape.steps, shape.steps);
  QCOMPARE(found.shape.axes, shape.axes);
  QCOMPARE(found.shape.fieldsT, shape.fieldsT);
  QCOMPARE(found.shape.sweepRows, shape.sweepRows);
  QCOMPARE(found.shape.settleS, shape.settleS);
}

void FieldPlanShapeTest::foreignPlanIsSaidToBeOne() {
  devices::FieldPlan plan = devices::makeFieldPlan();
  plan.stages[2].fieldsT = {0.1, 0.2};
  QVERIFY(!shapeOf(plan).exact);
  FieldPlanForm form;
  form.setPlan(plan);
  QCOMPARE(form.plan(), plan); // measured as it is
  const auto labels = form.findChildren<QLabel*>();
  QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
    return label->text().startsWith(QStringLiteral("This plan was made elsewhere")) && !label->isHidden();
  }));
}

void FieldPlanShapeTest::leftOutStagesStayLeftOut() {
  devices::FieldPlan before = devices::makeFieldPlan();
  before.stages[4].skipped = true;
  before.referenceTemperatureC = 23.0;
  FieldPlanShape shape;
  shape.steps = {CampaignStep::Offset, CampaignStep::Orientation};
  const devices::FieldPlan plan = planOfShape(shape, before);
  QCOMPARE(plan.stages.size(), std::size_t{7});
  QVERIFY(plan.stages[0].skipped); // the offset was number 4
  QVERIFY(!plan.stages[1].skipped);
  QCOMPARE(plan.referenceTemperatureC, 23.0);
}

void FieldPlanShapeTest::formEditsOneThing() {
  FieldPlanForm form;
  QSignalSpy edited(&form, &FieldPlanForm::planEdited);
  form.setPlan(devices::makeFieldPlan());
  QCOMPARE(edited.count(), 0);
  form.findChild<QDoubleSpinBox*>(QStringLiteral("fieldStep"))->setValue(0.5);
  QCOMPARE(edited.count(), 1);
  QCOMPARE(form.plan().stages.front().fieldsT, (std::vector<double>{-2.0, -1.5, -1.0, -0.5, 0.5, 1.0, 1.5, 2.0}));
  form.findChild<QSpinBox*>(QStringLiteral("plateauRows"))->setValue(4);
  QCOMPARE(form.plan().stages.front().rows, 4);
  QCOMPARE(form.plan().stages.front().fieldsT.size(), std::size_t{8}); // as edited before
  form.findChild<QCheckBox*>(QStringLiteral("ownRange"))->setChecked(true);
  form.findChild<QDoubleSpinBox*>(QStringLiteral("highTemperature"))->setValue(29.0);
  for (const devices::FieldStage& stage : form.plan().stages) {
    QVERIFY(!devices::isSweep(stage) || (stage.lowC == 17.0 && stage.highC == 29.0));
  }
  form.findChild<QCheckBox*>(QStringLiteral("step7"))->setChecked(false);
  QCOMPARE(form.plan().stages.size(), std::size_t{18});
  form.findChild<QCheckBox*>(QStringLiteral("axis_y"))->setChecked(false);
  QCOMPARE(form.plan().stages.size(), std::size_t{13});
  QVERIFY(devices::checkPlan(form.plan()).has_value());
}

void FieldPlanShapeTest::formKeepsOneStepAndOneAxis() {
  FieldPlanForm form;
  for (int step = 0; step < 8; ++step) {
    form.findChild<QCheckBox*>(QStringLiteral("step%1").arg(step))->setChecked(step == 2);
  }
  QCOMPARE(form.plan().stages.size(), std::size_t{1});
  auto* last = form.findChild<QCheckBox*>(QStringLiteral("step2"));
  last->setChecked(false);
  QVERIFY(last->isChecked());
  QCOMPARE(form.plan().stages.size(), std::size_t{1});
}

void FieldPlanShapeTest::stagesSayHowFarTheyAre() {
  devices::FieldPlan plan = smallCampaign({CampaignStep::Nonlinearity, CampaignStep::Sensitivity});
  std::vector<devices::FieldStageProgress> stages = progressBySamples(plan, {}, false);
  stages[0].pointsDone = 2;
  stages[1].pointsDone = stages[1].pointsPlanned;
  stages[1].pointsGivenUp = 2;
  stages[2].pointsDone = stages[2].pointsPlanned;
  stages[2].attempt = 1;
  stages[3].skipped = true;
  const std::vector<StageLine> lines = stageLines(plan, stages, 0);
  QCOMPARE(lines[0].title, QStringLiteral("Nonlinearity, x"));
  QCOMPARE(lines[0].state, QStringLiteral("measuring, 2 of 10"));
  QVERIFY(lines[0].why.contains(QStringLiteral("everything else rests on it")));
  // Eight of ten plateaus of 5 s and 3 rows of 6 s
  QCOMPARE(lines[0].duration, QStringLiteral("3 min 4 s"));
  QCOMPARE(lines[1].state, QStringLiteral("done, 2 without lock"));
  QCOMPARE(lines[1].duration, QString());
  QCOMPARE(lines[2].state, QStringLiteral("done"));
  QCOMPARE(lines[2].attempt, QStringLiteral("no. 2"));
  QCOMPARE(lines[3].state, QStringLiteral("left out"));
  QVERIFY2(lines[3].cost.startsWith(QStringLiteral("Left out, the block “Sensitivity” of axis x is switched off: The "
                                                   "gain's drift")),
           qPrintable(lines[3].cost));
  QCOMPARE(lines[4].state, QStringLiteral("to do"));
}

void FieldPlanShapeTest::stagesBySamples() {
  const devices::FieldPlan plan = twoOrientations();
  std::vector<session::FieldSample> samples(4);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].sequence = static_cast<std::int64_t>(i);
    samples[i].step = static_cast<int>(CampaignStep::Orientation);
    samples[i].orientation = 0;
    samples[i].locked = i > 0;
  }
  auto stages = progressBySamples(plan, samples, false);
  QCOMPARE(stages[0].pointsDone, 1); // three locked rows of its first plateau
  QCOMPARE(stages[0].pointsPlanned, 3);
  QCOMPARE(stages[1].pointsDone, 0);
  stages = progressBySamples(plan, samples, true);
  QCOMPARE(stages[0].pointsDone, 3);
  QCOMPARE(stages[0].pointsGivenUp, 2);
}

void FieldPlanShapeTest::traceShowsTheLatestAttempt() {
  const devices::FieldPlan plan = twoOrientations();
  FieldLiveTrace trace;
  QCOMPARE(trace.mainPlot().note, QStringLiteral("No stage is chosen"));
  trace.setStage(plan.stages[1], 1); // −x
  session::FieldSample row;
  row.stage = 1;
  row.locked = true;
  row.referenceT = -0.5;
  row.rawT = {-0.48, 0.01, 0.02};
  session::FieldSample other = row;
  other.stage = 0;
  session::FieldSample loose = row;
  loose.locked = false;
  loose.referenceT.reset();
  loose.timeS = 1.0;
  const std::vector<session::FieldSample> first = {row, other, loose};
  trace.add(first);
  QCOMPARE(trace.rows(), std::size_t{2});
  QCOMPARE(trace.unlocked(), std::size_t{1});
  const PlotSpec main = trace.mainPlot();
  QCOMPARE(main.series.size(), 3);
  QCOMPARE(main.series[0].x, QList<double>{-0.5});
  QVERIFY(main.x.minimum && std::abs(*main.x.minimum + 1.575) < 1e-9); // the whole stage: 0.5 to 1.5 T, minus forwards
  QVERIFY(main.x.maximum && std::abs(*main.x.maximum - 0.075) < 1e-9);
  QVERIFY(std::abs(main.series[0].y[0] - 20.0) < 1e-9); // −0.48 T is 20 mT above −0.5 T
  QVERIFY(std::abs(main.series[1].y[0] - 10.0) < 1e-9); // across the field: as it reads
  const PlotSpec time = trace.timePlot();
  QCOMPARE(time.series[1].x, QList<double>{1.0}); // not locked
  row.attempt = 1;
  trace.add(std::vector<session::FieldSample>{row});
  QCOMPARE(trace.rows(), std::size_t{1});
  trace.add(std::vector<session::FieldSample>{loose}); // of the attempt before
  QCOMPARE(trace.rows(), std::size_t{1});
}

void FieldPlanShapeTest::traceStaysLight() {
  devices::FieldPlan plan = smallCampaign({CampaignStep::ProbeTemperature});
  FieldLiveTrace trace;
  trace.setStage(plan.stages[0], 0);
  std::vector<session::FieldSample> rows(100000);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].timeS = static_cast<double>(i);
    rows[i].pt100Ohm = 109.0;
    rows[i].chamberC = 23.0;
  }
  trace.add(rows);
  QCOMPARE(trace.rows(), rows.size());
  QVERIFY(trace.mainPlot().series[0].x.size() <= static_cast<qsizetype>(FieldLiveTrace::mostRows));
  QVERIFY(trace.mainPlot().series[0].x.size() > static_cast<qsizetype>(FieldLiveTrace::mostRows / 3));
  const QList<double> times = trace.timePlot().series[0].x;
  QVERIFY(times.back() - times[times.size() - 2] == times[1] - times[0]); // evenly
}

std::unique_ptr<QObject> makeFieldPlanShapeTest() { return std::make_unique<FieldPlanShapeTest>(); }

} // namespace straightedge::gui

#include "field_plan_shape_test.moc"
