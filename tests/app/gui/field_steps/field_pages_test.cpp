#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/plots/scene_view.h"
#include "app/gui/steps/result_table.h"
#include "tests/app/gui/field_steps/field_document_fixture.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTreeWidget>

#include <memory>

namespace straightedge::gui {

using testing::OpenFieldDocument;

class FieldPagesTest : public QObject {
  Q_OBJECT
private slots:
  void placeholdersSayWhatToDo();
  void reviewSwitchesByKeyboard();
  void reviewFindsThePlateauOfAPoint();
  void fitSwitchesABlock();
  void fitKeepsItsFigure();
  void fitShowsFiguresInSpace();
  void everyBlockHasItsHelp();
  void verifyShowsSurfaces();
  void reviewShowsOrientations();
  void verifyShowsTheVerdict();
  void compareIsMadeWhileShown();

private:
  using Maker = StepPage* (*)(FieldStepContext, QWidget*);
  /// The page, shown as the window shows it.
  static std::unique_ptr<StepPage> shown(Maker maker, OpenFieldDocument& open) {
    std::unique_ptr<StepPage> page(maker({open.document, open.jobs}, nullptr));
    page->resize(1100, 720);
    page->show();
    page->entered();
    return page;
  }
  template <typename T>
  static T& named(const StepPage& page, const char* name) {
    T* child = page.findChild<T*>(QString::fromLatin1(name));
    if (child == nullptr) {
      qFatal("no %s", name);
    }
    return *child;
  }
};

void FieldPagesTest::placeholdersSayWhatToDo() {
  OpenFieldDocument open;
  for (const Maker maker : {&makeFieldConnectStep, &makeFieldCaptureStep}) {
    const auto page = shown(maker, open);
    QVERIFY(page->findChild<QLabel*>()->text().contains("straightedge-cli capture field --bench simulated"));
  }
}

void FieldPagesTest::reviewSwitchesByKeyboard() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldReviewStep, open);
  auto& stages = named<QTreeWidget>(*page, "stages");
  QTreeWidgetItem* plateau = stages.topLevelItem(0)->child(2);
  stages.setCurrentItem(plateau);
  QTest::keyClick(&stages, Qt::Key_Delete);
  QCOMPARE(plateau->checkState(0), Qt::Unchecked);
  QCOMPARE(stages.topLevelItem(0)->checkState(0), Qt::PartiallyChecked);
  QVERIFY(named<QAbstractButton>(*page, "switchAllOn").isEnabled());
  QTest::keyClick(&stages, Qt::Key_Space);
  QCOMPARE(plateau->checkState(0), Qt::Checked);
  stages.topLevelItem(1)->setCheckState(0, Qt::Unchecked); // a click on the tick
  QTRY_COMPARE(stages.topLevelItem(1)->child(0)->checkState(0), Qt::Unchecked);
  QVERIFY(open.document.undoStack().undoText().startsWith("Switch off Nonlinearity, "));
  open.document.undoStack().undo();
  QCOMPARE(stages.topLevelItem(1)->checkState(0), Qt::Checked);
  QCOMPARE(stages.currentItem(), plateau); // stays where it was
}

void FieldPagesTest::reviewFindsThePlateauOfAPoint() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldReviewStep, open);
  auto& stages = named<QTreeWidget>(*page, "stages");
  emit named<PlotView>(*page, "fieldReviewPlot").pointClicked(0, 0);
  QCOMPARE(stages.currentItem()->parent(), stages.topLevelItem(0));
}

void FieldPagesTest::fitSwitchesABlock() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldFitStep, open);
  auto& offset = named<QCheckBox>(*page, "block2");
  QCOMPARE(offset.text(), QStringLiteral("Offset"));
  QVERIFY(offset.isChecked());
  QVERIFY(offset.toolTip().contains("small fields"));
  const int rows = named<ResultTable>(*page, "fitBlocks").rowCount();
  offset.click();
  QVERIFY(open.document.choices().blocksOff.contains(field::Block::Offset));
  QVERIFY(open.settle());
  QCOMPARE(named<ResultTable>(*page, "fitBlocks").rowCount(), rows - 2); // three axes become one line
  open.document.undoStack().undo();
  QVERIFY(offset.isChecked());
}

void FieldPagesTest::fitKeepsItsFigure() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldFitStep, open);
  auto& box = named<QComboBox>(*page, "fitFigure");
  auto& plot = named<PlotView>(*page, "fitPlot");
  box.setCurrentIndex(box.findText(QStringLiteral("Offset")));
  const QString title = plot.spec().title;
  QVERIFY(!plot.spec().series.isEmpty());
  auto& order = named<QComboBox>(*page, "fieldOrder");
  order.setFocus();
  QTest::keyClick(&order, Qt::Key_3);
  QVERIFY(open.settle());
  QCOMPARE(open.document.choices().order, 3);
  QCOMPARE(box.currentText(), QStringLiteral("Offset"));
  QCOMPARE(plot.spec().title, title);
}

void FieldPagesTest::fitShowsFiguresInSpace() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldFitStep, open);
  auto& box = named<QComboBox>(*page, "fitFigure");
  QVERIFY(page->findChild<SceneView*>("fitScene") == nullptr); // nothing in space was wanted yet
  box.setCurrentIndex(box.findText(QStringLiteral("Axis directions")));
  auto& scene = named<SceneView>(*page, "fitScene");
  QSignalSpy drawn(&scene, &SceneView::pictureShown);
  QVERIFY(drawn.wait(60000));
  QVERIFY2(scene.isStarted(), qPrintable(scene.problem()));
  QVERIFY(scene.isVisible() && !named<PlotView>(*page, "fitPlot").isVisible());
  QCOMPARE(std::get<DirectionsSpec>(scene.spec()).directions.size(), 3);
  QVERIFY(scene.accessibleDescription().contains("tilted by"));
  box.setCurrentIndex(box.findText(QStringLiteral("Orientations")));
  QCOMPARE(std::get<SphereSpec>(scene.spec()).marks.size(), 6);
  box.setCurrentIndex(box.findText(QStringLiteral("Offset")));
  QVERIFY(!scene.isVisible() && named<PlotView>(*page, "fitPlot").isVisible());
}

void FieldPagesTest::everyBlockHasItsHelp() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldFitStep, open);
  QSignalSpy wanted(page.get(), &StepPage::helpRequested);
  named<QAbstractButton>(*page, "blockHelp6").click();
  QCOMPARE(wanted.takeFirst().first().toString(), QStringLiteral("field-axis-matrix"));
  QCOMPARE(page->helpPage(), QStringLiteral("field-fit"));
  page->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(page.get()));
  named<QCheckBox>(*page, "block1").setFocus();
  QCOMPARE(page->helpPage(), QStringLiteral("field-probe-temperature")); // what F1 opens
}

void FieldPagesTest::verifyShowsSurfaces() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldVerifyStep, open);
  auto& box = named<QComboBox>(*page, "verifyFigure");
  box.setCurrentIndex(box.findText(QStringLiteral("Surface before, z")));
  auto& scene = named<SceneView>(*page, "verifyScene");
  const SurfaceSpec before = std::get<SurfaceSpec>(scene.spec());
  QTest::keyClick(&scene, Qt::Key_Right);
  const SceneCamera turned = scene.camera();
  box.setCurrentIndex(box.findText(QStringLiteral("Surface after, z")));
  const SurfaceSpec after = std::get<SurfaceSpec>(scene.spec());
  QVERIFY(after.title.contains("after correction, axis z"));
  QVERIFY(after.zRange && after.zRange == before.zRange);
  QVERIFY(scene.camera() == turned); // looked at from the same place
  QVERIFY(box.findText(QStringLiteral("Surface after enlarged, x")) >= 0);
}

void FieldPagesTest::reviewShowsOrientations() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldReviewStep, open);
  auto& scene = named<SceneView>(*page, "fieldReviewOrientations");
  QVERIFY(!scene.isVisible() && !scene.isStarted()); // costs nothing until it is looked at
  named<QTabWidget>(*page, "fieldReviewTabs").setCurrentIndex(1);
  QSignalSpy drawn(&scene, &SceneView::pictureShown);
  QVERIFY(drawn.wait(60000));
  QVERIFY2(scene.isStarted(), qPrintable(scene.problem()));
  QCOMPARE(std::get<SphereSpec>(scene.spec()).note, QStringLiteral("6 of 6 directions were measured"));
  const auto& rows = open.document.campaign().rows;
  std::vector<std::size_t> plusX;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].orientation == field::Orientation::PlusX) {
      plusX.push_back(i);
    }
  }
  open.document.setRowsEnabled(plusX, false, {});
  QCOMPARE(std::get<SphereSpec>(scene.spec()).note, QStringLiteral("5 of 6 directions were measured"));
}

void FieldPagesTest::verifyShowsTheVerdict() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldVerifyStep, open);
  QCOMPARE(named<QLabel>(*page, "verdictWord").text(), QStringLiteral("Passed"));
  named<QDoubleSpinBox>(*page, "fieldLimit").setValue(0.0001);
  QVERIFY(open.settle());
  QCOMPARE(named<QLabel>(*page, "verdictWord").text(), QStringLiteral("Failed"));
  QVERIFY(named<ResultTable>(*page, "verificationTable").rowCount() > 6);
  QVERIFY(!named<QAbstractButton>(*page, "forgetVerification").isVisible());
  open.document.setVerificationCampaign(testing::quickCampaign(7));
  QVERIFY(open.settle());
  QVERIFY(named<QAbstractButton>(*page, "forgetVerification").isVisible());
}

void FieldPagesTest::compareIsMadeWhileShown() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldCompareStep, open);
  QVERIFY(open.settle());
  QVERIFY(open.document.comparison());
  auto& table = named<ResultTable>(*page, "storageTable");
  QVERIFY(table.rowCount() > 7);
  auto& plot = named<PlotView>(*page, "storagePlot");
  emit plot.pointClicked(0, 1);
  QCOMPARE(open.document.choices().order, 2); // orders along the line
  page->left();
  QVERIFY(open.settle());
  QVERIFY(!open.document.comparisonIsCurrent());
}

} // namespace straightedge::gui

QTEST_MAIN(straightedge::gui::FieldPagesTest)
#include "field_pages_test.moc"
