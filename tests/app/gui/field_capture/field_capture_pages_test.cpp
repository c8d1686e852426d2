// The pages themselves: what is shown and enabled when, and that mouse and keyboard reach the presenters.
#include "app/gui/field_steps/field_step_pages.h"
#include "app/gui/field_steps/simulated_field_form.h"
#include "app/gui/steps/notice_list.h"
#include "tests/app/gui/field_capture/open_campaign.h"
#include "tests/app/gui/field_capture/test_classes.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>

namespace straightedge::gui {

class FieldCapturePagesTest : public QObject {
  Q_OBJECT
private slots:
  void formHoldsEverySetting();
  void connectButtonConnects();
  void captureRunsFromItsButton();
  void guidedByTheKeyboard();
  void stagesByKeyboardAndButtons();
  void captureAsksBeforeReplacing();
  void faultIsShownWithItsRemedy();
  void planIsEditedInTheForm();
};

namespace {

struct ShownField {
  OpenCampaign open;
  std::unique_ptr<StepPage> page;

  explicit ShownField(StepPage* (*make)(FieldStepContext, QWidget*))
      : page(make({open.document, open.bench, open.jobs}, nullptr)) {
    page->resize(1100, 720);
    page->show();
    page->entered();
  }
  template <typename T>
  T& find(const char* name) {
    T* child = page->findChild<T*>(QString::fromLatin1(name));
    if (child == nullptr) {
      qFatal("no %s", name);
    }
    return *child;
  }
  void click(const char* name) { QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton); }
  QString textOf(const char* label) { return find<QLabel>(label).text(); }
};

QString stateIn(const QTreeWidget& stages, int row) { return stages.topLevelItem(row)->text(1); }

} // namespace

void FieldCapturePagesTest::formHoldsEverySetting() {
  SimulatedFieldForm form;
  devices::SimulatedFieldSettings settings;
  settings.probe.noiseT = 7.5e-6;
  settings.probeLagS = 20.0;
  settings.lockThresholdT = 0.2;
  settings.roomC = 22.5;
  settings.byHand = true;
  settings.realTime = true;
  settings.seed = 12;
  settings.probe.axes[2].planarHallPerT = 0.004; // of the command line: kept
  form.setSettings(settings);
  QCOMPARE(devices::simulatedFieldSettingsToJson(form.settings()), devices::simulatedFieldSettingsToJson(settings));
  form.findChild<QCheckBox*>(QStringLiteral("planarHall"))->setChecked(false);
  QCOMPARE(form.settings().probe.axes[2].planarHallPerT, 0.0);
  form.setSettings({});
  QVERIFY(!form.findChild<QCheckBox*>(QStringLiteral("planarHall"))->isChecked());
  form.findChild<QCheckBox*>(QStringLiteral("planarHall"))->setChecked(true);
  QCOMPARE(form.settings().probe.axes[0].planarHallPerT, 1e-3);
}

void FieldCapturePagesTest::connectButtonConnects() {
  ShownField shown(makeFieldConnectStep);
  shown.find<QSpinBox>("seed").setValue(5);
  shown.click("connectBench");
  QVERIFY(shown.open.bench.isConnected());
  QCOMPARE(shown.open.bench.simulatedSettings().seed, std::uint64_t{5});
  QVERIFY(!shown.open.bench.inRealTime());
  QVERIFY(!shown.find<QSpinBox>("seed").isEnabled());
  QSignalSpy readings(&shown.open.bench, &FieldBenchLink::liveReading);
  QVERIFY(readings.wait(captureWaitMs));
  QVERIFY(shown.find<QPushButton>("placeProbe").isEnabled());
  shown.find<QComboBox>("placement").setCurrentIndex(4); // +z
  shown.click("placeProbe");
  shown.find<QDoubleSpinBox>("fieldTarget").setValue(1.0);
  shown.click("setField");
  const auto last = [&readings] { return readings.last().first().value<FieldLiveReading>(); };
  QTRY_VERIFY(last().locked && std::abs(*last().referenceT - 1.0) < 1e-3 && last().rawT[2] > 0.9);
  QSignalSpy leads(shown.page.get(), &StepPage::goToStep);
  shown.click("goToCapture");
  QCOMPARE(leads.first().first().toString(), QStringLiteral("Capture"));
  shown.click("takeOverInstruments");
  QVERIFY(shown.textOf("traceabilitySummary").contains(QStringLiteral("SIM-H")));
  QSignalSpy details(shown.page.get(), &StepPage::detailsRequested);
  shown.click("editDetails");
  QCOMPARE(details.count(), 1);
  shown.click("connectBench");
  QVERIFY(!shown.open.bench.isConnected());
  QVERIFY(!shown.find<QPushButton>("placeProbe").isEnabled());
  devices::SimulatedFieldSettings elsewhere = fastField(true); // as the start page connects it
  elsewhere.seed = 9;
  QVERIFY(shown.open.bench.connectSimulated(elsewhere).has_value());
  QCOMPARE(shown.find<QSpinBox>("seed").value(), 9);
  QCOMPARE(shown.find<QComboBox>("placing").currentData().toBool(), true);
}

void FieldCapturePagesTest::captureRunsFromItsButton() {
  ShownField shown(makeFieldCaptureStep);
  QVERIFY(shown.find<QPushButton>("goToConnect").isVisible());
  QVERIFY(!shown.page->missing().isEmpty());
  auto held = std::make_shared<FailingFieldBench>(1'000'000);
  QVERIFY(shown.open.bench.connectBench(held->bench(), held).has_value());
  QVERIFY(shown.page->missing().isEmpty());
  shown.open.document.setPlan(smallCampaign());
  auto& stages = shown.find<QTreeWidget>("captureStages");
  QCOMPARE(stages.topLevelItemCount(), static_cast<int>(smallCampaign().stages.size()));
  QCOMPARE(stateIn(stages, 0), QStringLiteral("to do"));
  QVERIFY(stages.topLevelItem(0)->text(4).startsWith(QStringLiteral("Plateaus over the whole range")));
  QSignalSpy ended(&shown.open.bench, &FieldBenchLink::captureEnded);
  held->hold(); // however slow this thread is, the campaign is not over before it is paused
  shown.click("startCapture");
  QVERIFY(shown.open.bench.isCapturing());
  QVERIFY(shown.find<QPushButton>("pauseCapture").isVisible());
  shown.click("pauseCapture");
  held->letGo();
  QTRY_COMPARE(shown.find<QPushButton>("pauseCapture").text(), QStringLiteral("&Resume"));
  shown.click("pauseCapture");
  QVERIFY(ended.wait(captureWaitMs));
  QCOMPARE(shown.find<QPushButton>("goOn").text(), QStringLiteral("Go on to Review"));
  QSignalSpy leads(shown.page.get(), &StepPage::goToStep);
  shown.click("goOn");
  QCOMPARE(leads.first().first().toString(), QStringLiteral("Review"));
  QVERIFY(!shown.find<QPushButton>("pauseCapture").isVisible());
  QCOMPARE(shown.find<QProgressBar>("captureProgress").value(), 1000);
  QCOMPARE(stages.currentItem()->text(0), shown.find<PlotView>("stagePlot").spec().title);
  for (int row = 0; row < stages.topLevelItemCount(); ++row) {
    QCOMPARE(stateIn(stages, row), QStringLiteral("done"));
  }
  stages.setCurrentItem(stages.topLevelItem(0));
  QCOMPARE(shown.find<PlotView>("stagePlot").spec().title, QStringLiteral("Nonlinearity, x"));
  QVERIFY(!shown.find<PlotView>("stagePlot").spec().series[0].x.isEmpty());
  QVERIFY(!shown.find<PlotView>("stageTimePlot").spec().series[0].x.isEmpty());
}

void FieldCapturePagesTest::guidedByTheKeyboard() {
  ShownField shown(makeFieldCaptureStep);
  QVERIFY(QTest::qWaitForWindowActive(shown.page.get()));
  QVERIFY(shown.open.connectFast(true));
  shown.open.document.setPlan(twoOrientations());
  QSignalSpy ended(&shown.open.bench, &FieldBenchLink::captureEnded);
  auto& confirm = shown.find<QPushButton>("confirmStage");
  QVERIFY(!confirm.isVisible());
  shown.click("startCapture");
  QTRY_VERIFY(confirm.isVisible());
  QCOMPARE(shown.textOf("stageInstruction"), QStringLiteral("Place the probe with its +x axis along the field."));
  QCOMPARE(shown.textOf("stageHeading"), QStringLiteral("Stage 1 of 2: Orientation, +x"));
  QTRY_VERIFY(confirm.hasFocus());
  QTest::keyClick(&confirm, Qt::Key_Space);
  QTRY_COMPARE(shown.textOf("stageInstruction"), QStringLiteral("Place the probe with its −x axis along the field."));
  QTRY_COMPARE(shown.textOf("stageHeading"), QStringLiteral("Stage 2 of 2: Orientation, −x"));
  auto& stages = shown.find<QTreeWidget>("captureStages");
  QTRY_COMPARE(stateIn(stages, 0), QStringLiteral("done"));
  QTRY_COMPARE(stages.currentItem(), stages.topLevelItem(1)); // the list follows
  stages.setCurrentItem(stages.topLevelItem(0));              // and lets another one be chosen meanwhile
  QSignalSpy frames(&shown.open.bench, &FieldBenchLink::progressChanged);
  QTRY_VERIFY(frames.count() > 20);
  QCOMPARE(stages.currentItem(), stages.topLevelItem(0));
  QVERIFY(shown.find<QPushButton>("repeatStage").isEnabled());
  QTest::keyClick(&confirm, Qt::Key_Space);
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QVERIFY(!confirm.isVisible());
}

void FieldCapturePagesTest::stagesByKeyboardAndButtons() {
  ShownField shown(makeFieldCaptureStep);
  QVERIFY(QTest::qWaitForWindowActive(shown.page.get())); // shortcuts are the active window's
  QVERIFY(shown.open.connectFast());
  shown.open.document.setPlan(smallCampaign({field::CampaignStep::Orientation}));
  auto& stages = shown.find<QTreeWidget>("captureStages");
  stages.setFocus();
  stages.setCurrentItem(stages.topLevelItem(4));
  QTest::keyClick(&stages, Qt::Key_Down, Qt::ShiftModifier); // both of z
  QTest::keyClick(&stages, Qt::Key_Delete);
  QCOMPARE(stateIn(stages, 4), QStringLiteral("left out"));
  QCOMPARE(stateIn(stages, 5), QStringLiteral("left out"));
  QCOMPARE(stateIn(stages, 3), QStringLiteral("to do"));
  QVERIFY(shown.textOf("stageDetail").contains(QStringLiteral("“Axis matrix” is switched off")));
  QCOMPARE(shown.find<QPushButton>("leaveOutStage").text(), QStringLiteral("Take back &in"));
  QTest::keyClick(&stages, Qt::Key_Insert);
  QCOMPARE(stateIn(stages, 4), QStringLiteral("to do"));
  shown.click("leaveOutStage");
  QCOMPARE(stateIn(stages, 5), QStringLiteral("left out"));
  QSignalSpy ended(&shown.open.bench, &FieldBenchLink::captureEnded);
  shown.click("startCapture");
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QCOMPARE(stateIn(stages, 3), QStringLiteral("done"));
  QCOMPARE(stateIn(stages, 5), QStringLiteral("left out"));
  stages.setCurrentItem(stages.topLevelItem(5));
  QVERIFY(!shown.find<QPushButton>("repeatStage").isEnabled()); // nothing to repeat
  stages.setCurrentItem(stages.topLevelItem(2));
  QVERIFY(shown.find<QPushButton>("repeatStage").isEnabled());
  ended.clear();
  stages.setFocus();
  QTest::keyClick(&stages, Qt::Key_F5);
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QCOMPARE(stages.topLevelItem(2)->text(3), QStringLiteral("no. 2"));
  QCOMPARE(shown.open.stored().back().stage, 2);
  QStringList menu;
  for (const QAction* action : stages.actions()) { // the context menu
    menu << action->text();
  }
  QCOMPARE(menu, QStringList({"&Repeat", "&Leave out", "Take back &in"}));
  QCOMPARE(stages.contextMenuPolicy(), Qt::ActionsContextMenu);
}

void FieldCapturePagesTest::captureAsksBeforeReplacing() {
  ShownField shown(makeFieldCaptureStep);
  QVERIFY(shown.open.connectFast());
  QVERIFY(shown.open.captureToTheEnd(twoOrientations()));
  const std::size_t rows = shown.open.document.campaign().rows.size();
  shown.click("startCapture");
  auto* question = shown.page->findChild<QMessageBox*>(QStringLiteral("replaceCampaign"));
  QVERIFY(question != nullptr);
  QVERIFY(!shown.open.bench.isCapturing());
  QTest::mouseClick(question->button(QMessageBox::Cancel), Qt::LeftButton);
  QCOMPARE(shown.open.document.campaign().rows.size(), rows);
  QVERIFY(!shown.open.bench.isCapturing());
}

void FieldCapturePagesTest::faultIsShownWithItsRemedy() {
  ShownField shown(makeFieldCaptureStep);
  auto failing = std::make_shared<FailingFieldBench>(4);
  QVERIFY(shown.open.bench.connectBench(failing->bench(), failing).has_value());
  shown.open.document.setPlan(twoOrientations());
  QSignalSpy ended(&shown.open.bench, &FieldBenchLink::captureEnded);
  shown.click("startCapture");
  auto* notices = shown.page->findChild<NoticeList*>();
  QTRY_VERIFY(!notices->notices().isEmpty());
  QVERIFY(notices->notices().front().text.contains(QStringLiteral("switch it on, then resume")));
  QTRY_COMPARE(shown.find<QPushButton>("pauseCapture").text(), QStringLiteral("&Resume"));
  QVERIFY(shown.page->tellsBenchFaults());
  failing->mend();
  shown.click("pauseCapture");
  QVERIFY(ended.count() > 0 || ended.wait(captureWaitMs));
  QVERIFY(notices->notices().isEmpty());
}

void FieldCapturePagesTest::planIsEditedInTheForm() {
  ShownField shown(makeFieldCaptureStep);
  auto& rows = shown.find<QSpinBox>("plateauRows");
  rows.setFocus();
  rows.selectAll();
  QTest::keyClicks(&rows, QStringLiteral("4"));
  QTest::keyClick(&rows, Qt::Key_Return);
  QCOMPARE(shown.open.document.plan().stages.front().rows, 4);
  shown.find<QCheckBox>("step6").click(); // orientation
  QCOMPARE(shown.find<QTreeWidget>("captureStages").topLevelItemCount(), 15);
  QVERIFY(shown.textOf("planSummary").startsWith(QStringLiteral("15 stages, ")));
  auto& low = shown.find<QDoubleSpinBox>("lowTemperature");
  shown.find<QCheckBox>("ownRange").click();
  low.setValue(40.0); // above the highest
  QVERIFY(shown.textOf("planSummary").contains(QStringLiteral("the highest temperature of stage")));
  shown.open.document.undoStack().undo();
  QCOMPARE(shown.find<QSpinBox>("plateauRows").value(), 0); // the edits were one change
}

std::unique_ptr<QObject> makeFieldCapturePagesTest() { return std::make_unique<FieldCapturePagesTest>(); }

} // namespace straightedge::gui

#include "field_capture_pages_test.moc"
