// The four steps as widgets on the offscreen platform, driven by mouse and keyboard.
#include "app/gui/steps/step_page.h"
#include "tests/app/gui/steps_fit/document_fixture.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>

using namespace straightedge;
using namespace straightedge::gui;
using gui::testing::OpenDocument;
using gui::testing::patienceMs;

namespace {

template <typename W>
W& child(const QWidget& page, const char* name) {
  W* found = page.findChild<W*>(QString::fromLatin1(name));
  if (found == nullptr) {
    qFatal("no %s", name);
  }
  return *found;
}

/// Shows a step as the window would.
void show(StepPage& page) {
  page.resize(1200, 800);
  page.show();
  page.entered();
  QVERIFY(QTest::qWaitForWindowExposed(&page));
}

void click(QPushButton& button) { QTest::mouseClick(&button, Qt::LeftButton); }

} // namespace

class StepsTest : public QObject {
  Q_OBJECT

private slots:
  void fitAddsAModelByMouse();
  void fitShowsEveryView();
  void fitCopiesItsTable();
  void dragOfTheTargetLineChangesTheAnswer();
  void clickOnAPointChoosesTheModel();
  void useItTakesTheRecommendation();
  void verifyCapturesOnTheSimulatedBench();
  void exportWritesEveryFile();
  void emptyStepsSayWhatToDo();
};

void StepsTest::fitAddsAModelByMouse() {
  OpenDocument open;
  QVERIFY(open.load());
  const std::unique_ptr<StepPage> page(makeFitStep({open.document, open.bench, open.jobs}, nullptr));
  show(*page);
  auto& models = child<QTableWidget>(*page, "models");
  QCOMPARE(models.rowCount(), 3);
  child<QSpinBox>(*page, "modelSize").setValue(48);
  QCOMPARE(child<QLabel>(*page, "modelCost").text(), QStringLiteral("linear:48: 48 entries, 192 bytes"));
  click(child<QPushButton>(*page, "addModel"));
  QCOMPARE(models.rowCount(), 4);
  QVERIFY(!child<QPushButton>(*page, "addModel").isEnabled()); // it is in the list now
  QVERIFY(open.settle());
  QCOMPARE(child<PlotView>(*page, "upperPlot").spec().series.size(), 6);
  models.setCurrentCell(3, 0);
  click(child<QPushButton>(*page, "removeModel"));
  QCOMPARE(models.rowCount(), 3);
  models.item(0, 0)->setCheckState(Qt::Unchecked);
  QVERIFY(!child<PlotView>(*page, "upperPlot").spec().series[2].visible);
}

void StepsTest::fitShowsEveryView() {
  OpenDocument open;
  QVERIFY(open.load());
  const std::unique_ptr<StepPage> page(makeFitStep({open.document, open.bench, open.jobs}, nullptr));
  show(*page);
  auto& views = child<QComboBox>(*page, "fitView");
  QCOMPARE(views.count(), 10);
  QStringList titles;
  for (int i = 0; i < views.count(); ++i) {
    views.setCurrentIndex(i);
    titles << child<PlotView>(*page, "upperPlot").spec().title;
    QVERIFY(!child<PlotView>(*page, "upperPlot").grab().isNull());
  }
  QCOMPARE(titles.removeDuplicates(), 0);
}

void StepsTest::fitCopiesItsTable() {
  OpenDocument open;
  QVERIFY(open.load());
  const std::unique_ptr<StepPage> page(makeFitStep({open.document, open.bench, open.jobs}, nullptr));
  show(*page);
  click(child<QPushButton>(*page, "copyModels"));
  const QStringList lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
  QCOMPARE(lines.size(), 4);
  QVERIFY(lines[2].startsWith("linear:32\t32\t128\t"));
}

void StepsTest::dragOfTheTargetLineChangesTheAnswer() {
  OpenDocument open;
  QVERIFY(open.load());
  const std::unique_ptr<StepPage> page(makeCompareStep({open.document, open.bench, open.jobs}, nullptr));
  show(*page);
  auto& plot = child<PlotView>(*page, "comparisonPlot");
  const QString before = child<QLabel>(*page, "targetAnswer").text();
  QVERIFY(!before.isEmpty());
  const double entries = 500.0;
  const QPoint from = plot.toPixels(entries, open.document.choices().targetErrorDeg).toPoint();
  const QPoint to = plot.toPixels(entries, 0.05).toPoint();
  QTest::mouseMove(&plot, from);
  QTest::mousePress(&plot, Qt::LeftButton, {}, from);
  for (int step = 1; step <= 8; ++step) {
    QTest::mouseMove(&plot, from + (to - from) * step / 8);
  }
  QVERIFY(std::abs(open.document.choices().targetErrorDeg - 0.05) < 0.01); // already while dragging
  QTest::mouseRelease(&plot, Qt::LeftButton, {}, to);
  QVERIFY(child<QLabel>(*page, "targetAnswer").text() != before);
  QVERIFY(std::abs(child<QDoubleSpinBox>(*page, "targetError").value() - 0.05) < 0.01);
  open.document.undoStack().undo(); // the drag is one step
  QCOMPARE(open.document.choices().targetErrorDeg, 0.5);
}

void StepsTest::clickOnAPointChoosesTheModel() {
  OpenDocument open;
  QVERIFY(open.load());
  const std::unique_ptr<StepPage> page(makeCompareStep({open.document, open.bench, open.jobs}, nullptr));
  show(*page);
  auto& plot = child<PlotView>(*page, "comparisonPlot");
  const PlotSeries& harmonics = plot.spec().series[0];
  QCOMPARE(harmonics.name, QStringLiteral("Harmonics"));
  const int place = 5; // stands alone: at 5 entries a linear model leaves just as much
  const QPoint at = plot.toPixels(harmonics.x[place], harmonics.y[place]).toPoint();
  QTest::mouseMove(&plot, at);
  QTest::mouseClick(&plot, Qt::LeftButton, {}, at);
  QCOMPARE(open.document.choices().selected.text(), std::string("harmonic:5"));
  QVERIFY(child<QLabel>(*page, "chosenModel").text().startsWith("Chosen: harmonic:5,"));
}

void StepsTest::useItTakesTheRecommendation() {
  OpenDocument open;
  QVERIFY(open.load());
  const std::unique_ptr<StepPage> page(makeCompareStep({open.document, open.bench, open.jobs}, nullptr));
  show(*page);
  child<QDoubleSpinBox>(*page, "targetError").setValue(0.2);
  click(child<QPushButton>(*page, "targetUse"));
  const auto answer = angle::recommendForTarget(*open.document.comparison(), 0.2);
  QVERIFY(answer.choice);
  QCOMPARE(open.document.choices().selected.text(), answer.choice->name.text());
}

void StepsTest::verifyCapturesOnTheSimulatedBench() {
  OpenDocument open;
  QVERIFY(open.load());
  const std::unique_ptr<StepPage> page(makeVerifyStep({open.document, open.bench, open.jobs}, nullptr));
  show(*page);
  auto& capture = child<QPushButton>(*page, "captureVerification");
  QVERIFY(!capture.isEnabled());
  devices::SimulatedAngleSettings settings;
  settings.realTime = false;
  QVERIFY(open.bench.connectSimulated(settings).has_value());
  QVERIFY(capture.isEnabled());
  child<QSpinBox>(*page, "verifyPoints").setValue(16);
  click(capture);
  QVERIFY(QTest::qWaitFor([&] { return open.document.verification().has_value(); }, patienceMs));
  // the bench's magnet is not the one of the loaded sweep: the verdict must say so
  QCOMPARE(child<QLabel>(*page, "verdictWord").text(), QStringLiteral("Failed"));
  QCOMPARE(child<PlotView>(*page, "beforeAfterPlot").spec().series.size(), 2);
}

void StepsTest::exportWritesEveryFile() {
  const QTemporaryDir folder;
  OpenDocument open;
  QVERIFY(open.load());
  const std::unique_ptr<StepPage> page(makeExportStep({open.document, open.bench, open.jobs}, nullptr));
  show(*page);
  auto& target = child<QLineEdit>(*page, "exportFolder");
  target.selectAll();
  QTest::keyClicks(&target, folder.filePath("out"));
  QTest::keyClick(&target, Qt::Key_Return);
  for (const char* box : {"exportTablesJson", "exportSvg", "exportPdf", "exportReportHtml"}) {
    child<QCheckBox>(*page, box).setChecked(true);
  }
  const int planned = child<QListWidget>(*page, "fileList").count();
  QVERIFY(planned > 60);
  click(child<QPushButton>(*page, "startExport"));
  QVERIFY(QTest::qWaitFor([&] { return child<QPushButton>(*page, "openFolder").isVisibleTo(page.get()); }, patienceMs));
  QVERIFY(child<QLabel>(*page, "fileCount").text().startsWith(QString::number(planned)));
  for (int i = 0; i < planned; ++i) {
    const QString name = child<QListWidget>(*page, "fileList").item(i)->text();
    QVERIFY2(QFileInfo(folder.filePath("out/" + name)).size() > 0, qPrintable(name));
  }
}

void StepsTest::emptyStepsSayWhatToDo() {
  OpenDocument open;
  const StepContext context{open.document, open.bench, open.jobs};
  for (StepPage* made : {makeFitStep(context, nullptr), makeCompareStep(context, nullptr),
                         makeVerifyStep(context, nullptr), makeExportStep(context, nullptr)}) {
    const std::unique_ptr<StepPage> page(made);
    show(*page);
    QVERIFY2(!page->missing().isEmpty(), qPrintable(page->title()));
    QVERIFY(!page->helpPage().isEmpty());
  }
}

QTEST_MAIN(StepsTest)
#include "steps_fit_test.moc"
