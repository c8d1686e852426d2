// The window's step Connect on emulated instruments under the real libusb: they appear when they are plugged in, fill
// roles, are read, capture a sweep, leave in the middle and come back.
#include "app/gui/bench/bench_console.h"
#include "app/gui/bench/device_list.h"
#include "app/gui/bench/role_row.h"
#include "app/gui/shell/field_workspace.h"
#include "app/gui/shell/program_start.h"
#include "app/gui/shell/theme.h"
#include "app/gui/steps/connect_column.h"
#include "app/gui/steps/value_label.h"
#include "devices/bench/bench_folder.h"
#include "devices/bench/saved_bench.h"
#include "tests/app/gui/bench/angle_desk.h"
#include "tests/app/gui/bench/test_classes.h"
#include "tests/app/gui/end_to_end/quiet_prompts.h"
#include "tests/app/gui/end_to_end/window_driver.h"
#include "tests/fakes/usb/thm1176.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace straightedge::gui {

class BenchWindowTest : public QObject {
  Q_OBJECT
private slots:
  void init();
  void withoutAnythingTheSimulatedBenchWorks();
  void instrumentsAppearAndLeaveWithAndWithoutEvents();
  void oneHeldByAnotherProgramSaysSo();
  void rolesAreFilledReadAndTalkedTo();
  void unpluggedWhileIdleTheRoleSaysSoAndGoesOn();
  void aSweepGoesOnAfterAReplug();
  void anotherBenchTakesItsPlace();
  void aFieldBenchIsReadInItsOwnPage();
};

namespace {

constexpr int waitMs = 60000;
constexpr int points = 8;

struct DeskWindow {
  fakes::EmulatedUsb bus;
  fakes::DeskShaft shaft;
  MainWindow window{std::make_unique<QuietPrompts>()};
  WindowDriver driver{window};

  DeskWindow() {
    window.resize(1280, 800);
    window.show();
    window.newCalibration();
    driver.step(QStringLiteral("Connect"));
    driver.find<QTabWidget>(QStringLiteral("benches"))->setCurrentIndex(1);
  }
  template <typename T>
  T& find(const char* name) {
    return *driver.find<T>(QString::fromLatin1(name));
  }
  QString textOf(const char* name) {
    const auto* label = window.findChild<QLabel*>(QString::fromLatin1(name));
    return label == nullptr ? QString() : label->text();
  }
  int rowOf(const QString& serial) {
    auto* list = window.findChild<DeviceList*>(QStringLiteral("devices"));
    for (int i = 0; list != nullptr && i < list->count(); ++i) {
      if (list->keyAt(i).contains(serial)) {
        return i;
      }
    }
    return -1;
  }
  void drop(const QString& serial, const char* role) {
    QMimeData dragged;
    dragged.setData(DeviceList::mimeType(), find<DeviceList>("devices").keyAt(rowOf(serial)).toUtf8());
    auto* row = window.findChild<RoleRow*>(QString::fromLatin1(role));
    QDragEnterEvent enter(row->rect().center(), Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(row, &enter); // Qt delivers a drop only where the drag had entered
    QDropEvent dropped(row->rect().center(), Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(row, &dropped);
  }
  fakes::EmulatedUsb::Plug plugEncoder(const std::string& port = {}) {
    return bus.plug(fakes::deskEncoder(shaft), {.port = port, .driver = "ftdi_sio"});
  }
  fakes::EmulatedUsb::Plug plugBoard() { return bus.plug(fakes::deskBoard(shaft), {.driver = "cdc_acm"}); }
  void fillRoles() {
    QTRY_VERIFY(rowOf("FT-1") >= 0 && rowOf("ACM-1") >= 0);
    drop("FT-1", "role-angle-reference");
    drop("ACM-1", "role-angle-sensor");
    QVERIFY2(textOf("benchProblem").isEmpty(), qPrintable(textOf("benchProblem")));
    driver.click(QStringLiteral("settings-angle-reference"));
    driver.typeText(QStringLiteral("setting-counts_per_turn"), QString::number(fakes::deskCountsPerTurn));
    QTRY_VERIFY(!window.findChild<QDialog*>(QStringLiteral("instrumentSettings")));
  }
  void connectBench() {
    driver.click(QStringLiteral("openBench"));
    QTRY_COMPARE(find<QPushButton>("openBench").text(), QStringLiteral("&Disconnect"));
  }
};

} // namespace

void BenchWindowTest::init() {
  QSettings().clear();
  for (const std::string& name : devices::savedBenchNames()) {
    QVERIFY(devices::deleteBench(name));
  }
}

void BenchWindowTest::withoutAnythingTheSimulatedBenchWorks() {
  DeskWindow desk;
  QTRY_VERIFY(!desk.textOf("devicesNote").startsWith(QStringLiteral("Looking")));
  if (desk.window.findChild<DeviceList*>(QStringLiteral("devices"))->count() == 0) { // this machine has no serial port
    QVERIFY(desk.textOf("devicesNote").startsWith(QStringLiteral("Nothing is plugged in")));
  }
  desk.find<QTabWidget>("benches").setCurrentIndex(0);
  QSignalSpy readings(&desk.window.bench(), &BenchLink::liveReading);
  desk.driver.click(QStringLiteral("connectBench"));
  QVERIFY(readings.wait(waitMs));
}

void BenchWindowTest::instrumentsAppearAndLeaveWithAndWithoutEvents() {
  DeskWindow desk;
  const auto encoder = desk.plugEncoder();
  QTRY_VERIFY(desk.rowOf("FT-1") >= 0);
  const auto board = desk.bus.plug(fakes::deskBoard(desk.shaft), {.events = false});
  QTRY_VERIFY(desk.rowOf("ACM-1") >= 0);
  desk.bus.unplug(board); // nobody tells
  QTRY_VERIFY(desk.rowOf("ACM-1") < 0);
  desk.bus.unplug(encoder);
  QTRY_VERIFY(desk.rowOf("FT-1") < 0);
}

void BenchWindowTest::oneHeldByAnotherProgramSaysSo() {
  DeskWindow desk;
  desk.bus.plug(fakes::deskEncoder(desk.shaft), {.heldByAnotherProgram = true});
  desk.plugBoard();
  QTRY_VERIFY(desk.rowOf("FT-1") >= 0 && desk.rowOf("ACM-1") >= 0);
  desk.find<DeviceList>("devices").setCurrentRow(desk.rowOf("FT-1"));
  QVERIFY2(desk.textOf("deviceProblem").contains(QStringLiteral("another program")),
           qPrintable(desk.textOf("deviceProblem")));
  QVERIFY(desk.textOf("deviceProblem").contains(QStringLiteral("close the program")));
  desk.fillRoles();
  desk.driver.click(QStringLiteral("openBench"));
  QTRY_VERIFY(desk.textOf("benchProblem").contains(QStringLiteral("another program")));
  QVERIFY(!desk.window.bench().isConnected());
}

void BenchWindowTest::rolesAreFilledReadAndTalkedTo() {
  DeskWindow desk;
  desk.plugEncoder();
  desk.plugBoard();
  desk.shaft.angleDeg = 45.0;
  desk.fillRoles();
  desk.connectBench();
  QCOMPARE(desk.window.bench().instruments()[1].identity.serial, std::string("12345"));
  QTRY_COMPARE(desk.textOf("value-angle-reference"), QStringLiteral("45.0000°"));
  QTRY_COMPARE(desk.textOf("value-angle-sensor"), QString::number(fakes::deskSensorDeg(45.0), 'f', 4) + QChar(0xb0));
  QVERIFY(desk.textOf("caution-angle-reference").contains(QStringLiteral("Not yet tried on hardware")));
  desk.shaft.angleDeg = 90.0;
  QTRY_COMPARE(desk.textOf("value-angle-reference"), QStringLiteral("90.0000°"));
  QVERIFY(!desk.find<QComboBox>("device-angle-sensor").isEnabled());

  desk.driver.click(QStringLiteral("showConsole"));
  auto& table = desk.find<QTableView>("dialogue");
  QTRY_VERIFY(table.model()->rowCount() > 0);
  desk.find<QComboBox>("consoleInstrument")
      .setCurrentIndex(desk.find<QComboBox>("consoleInstrument").findText("FT-1", Qt::MatchContains));
  desk.find<QComboBox>("consoleEnd").setCurrentIndex(1);
  desk.find<QLineEdit>("consoleFilter").setText(QStringLiteral("R14"));
  const int before = table.model()->rowCount(); // asked when it was set up
  QCOMPARE(before, 1);
  desk.driver.typeText(QStringLiteral("consoleCommand"), QStringLiteral("R14"));
  QTRY_COMPARE(table.model()->rowCount(), 2);
  desk.find<QLineEdit>("consoleFilter").setText(QStringLiteral("r 14 12345009"));
  QTRY_VERIFY(table.model()->rowCount() == 2); // what it answered, both times
  const QTemporaryDir folder;
  QVERIFY(desk.find<BenchConsole>("benchConsole").saveTo(folder.filePath("qsb.txt")));
  const auto dialogue = devices::readDialogue(folder.filePath("qsb.txt").toStdString());
  QVERIFY(dialogue.has_value());
  QCOMPARE(std::ranges::count(dialogue->entries, "R14\r\n", &devices::DialogueEntry::bytes), 2);
  // The readings go on after what a person typed in between.
  desk.shaft.angleDeg = 135.0;
  QTRY_COMPARE(desk.textOf("value-angle-reference"), QStringLiteral("135.0000°"));
}

void BenchWindowTest::unpluggedWhileIdleTheRoleSaysSoAndGoesOn() {
  DeskWindow desk;
  const auto plug = desk.plugEncoder();
  desk.plugBoard();
  desk.fillRoles();
  desk.connectBench();
  QTRY_COMPARE(desk.textOf("value-angle-reference"), QStringLiteral("0.0000°"));
  desk.bus.unplug(plug);
  QTRY_VERIFY(desk.textOf("fault-angle-reference").contains(QStringLiteral("not plugged in")));
  QVERIFY(desk.textOf("value-angle-reference").isEmpty());
  QVERIFY(!desk.textOf("value-angle-sensor").isEmpty());
  desk.plugEncoder("7");
  QTRY_COMPARE(desk.textOf("value-angle-reference"), QStringLiteral("0.0000°"));
  QVERIFY(desk.textOf("fault-angle-reference").isEmpty());
  desk.driver.click(QStringLiteral("openBench")); // Disconnect
  QVERIFY(!desk.window.bench().isConnected());
  QTRY_COMPARE(desk.find<QPushButton>("openBench").text(), QStringLiteral("&Connect"));
  desk.connectBench(); // given back, and taken again
  QTRY_COMPARE(desk.textOf("value-angle-reference"), QStringLiteral("0.0000°"));
}

void BenchWindowTest::aSweepGoesOnAfterAReplug() {
  DeskWindow desk;
  const auto plug = desk.plugEncoder();
  desk.plugBoard();
  desk.fillRoles();
  desk.find<QComboBox>("pairingRule").setCurrentIndex(1);
  emit desk.find<QComboBox>("pairingRule").activated(1);
  desk.connectBench();
  QCOMPARE(desk.window.document().plan().pairing.kind, devices::PairingKind::Interpolate);
  devices::AnglePlan plan = desk.window.document().plan();
  plan.pointsPerTurn = points;
  plan.settleS = 0.0;
  plan.pairing.maxAgeS = 10.0;
  desk.window.document().setPlan(plan);
  const std::vector<devices::PlannedPoint> planned = devices::plannedPoints(plan);

  BenchLink& link = desk.window.bench();
  // A person at the shaft, who follows what the step says.
  connect(&link, &BenchLink::progressChanged, this, [&] {
    const auto done = static_cast<std::size_t>(link.progress().pointsDone);
    desk.shaft.angleDeg = done < planned.size() ? planned[done].encoderDeg : 0.0;
    if (link.progress().pointsDone == points / 2 && desk.bus.isPlugged(plug) && desk.shaft.leavesAfter < 0) {
      desk.shaft.leavesAfter = 1;
    }
  });
  desk.driver.step(QStringLiteral("Capture"));
  QSignalSpy ended(&link, &BenchLink::captureEnded);
  desk.driver.click(QStringLiteral("startCapture"));
  QVERIFY(desk.textOf("captureGuidance").startsWith(QStringLiteral("Turn the shaft to 0.00°")));
  QTRY_VERIFY(link.progress().waitsForInstrument);
  QTRY_VERIFY2(desk.textOf("captureGuidance").contains(QStringLiteral("waits for the instrument that was unplugged")),
               qPrintable(desk.textOf("captureGuidance")));
  QVERIFY(!desk.driver.isShown(QStringLiteral("pauseCapture")));
  QCOMPARE(link.progress().pointsDone, points / 2);
  QVERIFY(QString::fromStdString(link.progress().error->message()).contains(QStringLiteral("FT-1")));
  desk.shaft.leavesAfter = -2;
  desk.plugEncoder("7"); // the same one, elsewhere
  QVERIFY(ended.wait(waitMs));
  QCOMPARE(desk.window.document().sweep().size(), std::size_t{points});
  for (std::size_t i = 0; i < points; ++i) {
    QCOMPARE(desk.window.document().sweep().encoderDeg[i], planned[i].encoderDeg);
  }
  QVERIFY(desk.driver.isShown(QStringLiteral("goOn")));
  disconnect(&link, nullptr, this, nullptr);
}

void BenchWindowTest::anotherBenchTakesItsPlace() {
  DeskWindow desk;
  desk.plugEncoder();
  desk.plugBoard();
  desk.fillRoles();
  desk.connectBench();
  desk.find<QTabWidget>("benches").setCurrentIndex(0);
  desk.driver.click(QStringLiteral("connectBench"));
  QVERIFY(desk.window.bench().isSimulated());
  desk.find<QTabWidget>("benches").setCurrentIndex(1);
  QCOMPARE(desk.find<QPushButton>("openBench").text(), QStringLiteral("&Connect"));
  desk.connectBench();
  QVERIFY(!desk.window.bench().isSimulated());
  QVERIFY(desk.window.bench().isConnected());
}

void BenchWindowTest::aFieldBenchIsReadInItsOwnPage() {
  DeskWindow desk;
  desk.window.newFieldCalibration(); // begins at Connect
  desk.find<QTabWidget>("benches").setCurrentIndex(1);
  auto meter = std::make_shared<fakes::UsbTmcDevice>();
  meter->onMessage(fakes::thm1176Answers());
  const auto plug = desk.bus.plug(meter);
  auto& choice = desk.find<QComboBox>("device-field-probe");
  QTRY_VERIFY(choice.findText(QStringLiteral("0123456"), Qt::MatchContains) > 0);
  desk.driver.choose(QStringLiteral("device-field-probe"),
                     choice.itemText(choice.findText(QStringLiteral("0123456"), Qt::MatchContains)));
  desk.connectBench();
  QVERIFY(desk.window.field().bench().isConnected());
  QVERIFY(!desk.window.field().bench().isSimulated());
  QTRY_COMPARE(desk.find<QLabel>("value-field-probe").text(), QStringLiteral("0.250000  −0.500000  1.000000 T"));
  QTRY_VERIFY(desk.find<ValueLabel>("raw_y").text().startsWith(QStringLiteral("−0.5")));
  desk.bus.unplug(plug);
  QTRY_COMPARE(desk.find<ValueLabel>("raw_y").text(), QStringLiteral("–"));
  QTRY_VERIFY(desk.find<QLabel>("fault-field-probe").text().contains(QStringLiteral("not plugged in")));
}

std::unique_ptr<QObject> makeBenchWindowTest() { return std::make_unique<BenchWindowTest>(); }

int takeBenchPictures(QApplication& application, const QString& folder) {
  prepareApplication(application);
  DeskWindow desk;
  int count = 0;
  const auto take = [&](const QString& name) {
    QTest::qWait(300); // pictures only; nothing is checked
    for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark}) {
      applyTheme(application, theme);
      QTest::qWait(300);
      const QString file = QStringLiteral("%1/%2-%3-%4.png").arg(folder).arg(count, 2, 10, QLatin1Char('0'));
      desk.window.grab().save(file.arg(name, themeName(theme)));
    }
    ++count;
    applyTheme(application, ThemeChoice::Light);
  };
  QDir().mkpath(folder);
  take(QStringLiteral("nothing"));
  const auto held = desk.bus.plug(fakes::deskEncoder(desk.shaft), {.heldByAnotherProgram = true});
  desk.plugBoard();
  desk.bus.plug(std::make_shared<fakes::UsbTmcDevice>());
  const auto waitFor = [](const auto& condition) {
    if (!QTest::qWaitFor(condition, waitMs)) {
      qFatal("it did not come to that");
    }
  };
  waitFor([&] { return desk.rowOf("FT-1") >= 0 && desk.rowOf("ACM-1") >= 0 && desk.rowOf("0123456") >= 0; });
  desk.find<DeviceList>("devices").setCurrentRow(desk.rowOf("FT-1"));
  take(QStringLiteral("listed"));
  desk.bus.unplug(held);
  auto plug = desk.plugEncoder();
  desk.fillRoles();
  desk.driver.click(QStringLiteral("settings-angle-sensor"));
  QTest::qWait(200);
  desk.window.findChild<QDialog*>(QStringLiteral("instrumentSettings"))->grab().save(folder + "/settings.png");
  desk.window.findChild<QDialog*>(QStringLiteral("instrumentSettings"))->reject();
  desk.driver.click(QStringLiteral("showConsole"));
  take(QStringLiteral("roles"));
  desk.shaft.angleDeg = 123.4;
  desk.connectBench();
  QTest::qWait(3000);
  take(QStringLiteral("connected"));
  auto* scroll = desk.window.findChild<ConnectColumn*>();
  scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
  desk.bus.unplug(plug);
  waitFor([&] { return !desk.textOf("fault-angle-reference").isEmpty(); });
  take(QStringLiteral("unplugged"));
  plug = desk.plugEncoder();
  waitFor([&] { return desk.textOf("fault-angle-reference").isEmpty(); });
  desk.driver.step(QStringLiteral("Capture"));
  take(QStringLiteral("capture-ready"));
  desk.driver.click(QStringLiteral("startCapture"));
  take(QStringLiteral("capture-by-hand"));
  desk.bus.unplug(plug);
  waitFor([&] { return desk.window.bench().progress().waitsForInstrument; });
  take(QStringLiteral("capture-waits"));
  desk.window.bench().stopAndWait();
  return 0;
}

} // namespace straightedge::gui

#include "bench_window_test.moc"
