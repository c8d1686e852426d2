#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/steps/result_table.h"
#include "tests/app/gui/field_steps/field_document_fixture.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTreeWidget>

#include <memory>

namespace straightedge::gui {

using testing::OpenFieldDocument;

class FieldPagesTest : public QObject {
  Q_OBJECT
private slots:
  void reviewSwitchesByKeyboard();
  void reviewFindsThePlateauOfAPoint();
  void fitSwitchesABlock();
  void fitKeepsItsFigure();
  void verifyShowsTheVerdict();
  void verifySaysHowToCaptureAFreshOne();
  void compareIsMadeWhileShown();

private:
  using Maker = StepPage* (*)(FieldStepContext, QWidget*);
  /// The page, shown as the window shows it.
  static std::unique_ptr<StepPage> shown(Maker maker, OpenFieldDocument& open) {
    std::unique_ptr<StepPage> page(maker({open.document, open.bench, open.jobs}, nullptr));
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

void FieldPagesTest::verifySaysHowToCaptureAFreshOne() {
  OpenFieldDocument open;
  QVERIFY(open.load());
  const auto page = shown(&makeFieldVerifyStep, open);
  auto& capture = named<QAbstractButton>(*page, "captureVerification");
  QVERIFY(!capture.isEnabled());
  QVERIFY(named<QLabel>(*page, "captureProblem").text().contains("step Connect"));
  devices::SimulatedFieldSettings settings;
  settings.realTime = false;
  settings.byHand = true;
  QVERIFY(open.bench.connectSimulated(settings).has_value());
  QVERIFY(capture.isEnabled());
  QVERIFY(!named<QLabel>(*page, "captureProblem").isVisible());
  QSignalSpy leads(page.get(), &StepPage::goToStep);
  capture.click();
  QVERIFY(open.bench.isCapturing());
  QCOMPARE(open.bench.captureRole(), session::SweepRole::Verification);
  QCOMPARE(leads.first().first().toString(), QStringLiteral("Capture"));
  open.bench.stopAndWait();
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
