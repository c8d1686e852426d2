// The panel itself: devices are dragged onto roles, chosen by menu and by keyboard; what is in the way is shown with
// the command that mends it.
#include "app/gui/bench/bench_console.h"
#include "app/gui/bench/bench_panel.h"
#include "app/gui/bench/device_list.h"
#include "app/gui/bench/device_words.h"
#include "app/gui/bench/role_row.h"
#include "app/gui/jobs/job_runner.h"
#include "devices/bench/bench_folder.h"
#include "tests/app/gui/bench/listed_devices.h"
#include "tests/app/gui/bench/test_classes.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

namespace straightedge::gui {

using Role = devices::InstrumentRole;

class BenchPanelTest : public QObject {
  Q_OBJECT
private slots:
  void init();
  void aDeviceIsDroppedOnARole();
  void aRoleIsFilledByMenuAndByKeyboard();
  void theCommandThatMendsIsCopied();
  void settingsAreCheckedWhileTheyAreTyped();
  void benchesAreSavedLoadedAndDeleted();
  void consoleIsReachedByKeyboard();
};

namespace {

struct ShownPanel {
  JobRunner jobs;
  PretendedDesk plugged;
  BenchPresenter presenter;
  BenchPanel panel;

  explicit ShownPanel(const std::vector<devices::ListedDevice>& devices,
                      const std::vector<RoleSlot>& roles = angleRoleSlots())
      : presenter(jobs, {.kind = QStringLiteral("test"), .roles = roles, .lister = lister(devices), .byEvents = false}),
        panel(presenter) {
    panel.resize(460, 800);
    panel.show();
    panel.activateWindow();
    QSignalSpy changed(&presenter.watch(), &DeviceWatch::changed);
    presenter.setShown(true);
    if (!changed.wait(60000)) {
      qFatal("nobody looked at the devices");
    }
  }
  template <typename T>
  T& find(const char* name) {
    T* child = panel.findChild<T*>(QString::fromLatin1(name));
    if (child == nullptr) {
      qFatal("no %s", name);
    }
    return *child;
  }
  void click(const char* name) { QTest::mouseClick(&find<QAbstractButton>(name), Qt::LeftButton); }
  void drop(int device, const char* role) {
    QMimeData dragged;
    dragged.setData(DeviceList::mimeType(), find<DeviceList>("devices").keyAt(device).toUtf8());
    auto& row = find<RoleRow>(role);
    QDragEnterEvent enter(row.rect().center(), Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(&row, &enter);
    if (enter.isAccepted()) {
      QDropEvent dropped(row.rect().center(), Qt::CopyAction, &dragged, Qt::LeftButton, {});
      QApplication::sendEvent(&row, &dropped);
    }
  }
  std::string serialIn(Role role) const {
    const devices::BenchInstrument* filling = presenter.draft().filling(role);
    return filling == nullptr ? std::string() : filling->serial;
  }

private:
  devices::DeviceLister lister(const std::vector<devices::ListedDevice>& devices) {
    plugged.put(devices);
    return plugged.lister();
  }
};

} // namespace

void BenchPanelTest::init() {
  QSettings().clear();
  for (const std::string& name : devices::savedBenchNames()) {
    QVERIFY(devices::deleteBench(name));
  }
}

void BenchPanelTest::aDeviceIsDroppedOnARole() {
  ShownPanel shown({listedEncoder(), listedBoard(), listedMouse()});
  auto& list = shown.find<DeviceList>("devices");
  QCOMPARE(list.count(), 3);
  QVERIFY(list.item(0)->flags().testFlag(Qt::ItemIsDragEnabled));
  QVERIFY(!list.item(2)->flags().testFlag(Qt::ItemIsDragEnabled));
  shown.drop(0, "role-angle-reference");
  shown.drop(1, "role-angle-sensor");
  QCOMPARE(shown.serialIn(Role::AngleReference), std::string("FT-1"));
  QCOMPARE(shown.serialIn(Role::AngleSensor), std::string("ACM-1"));
  QVERIFY(shown.find<QComboBox>("device-angle-reference").currentText().contains(QStringLiteral("FT-1")));
  QVERIFY(shown.find<QLabel>("caution-angle-reference").text().startsWith(QStringLiteral("Not yet tried on hardware")));
  shown.drop(2, "role-temperature");
  QVERIFY2(shown.find<QLabel>("benchProblem").text().contains(QStringLiteral("cannot fill the role temperature")),
           qPrintable(shown.find<QLabel>("benchProblem").text()));
  QMimeData other;
  other.setText(QStringLiteral("a file"));
  auto& row = shown.find<RoleRow>("role-temperature");
  QDragEnterEvent enter(row.rect().center(), Qt::CopyAction, &other, Qt::LeftButton, {});
  enter.ignore();
  QApplication::sendEvent(&row, &enter);
  QVERIFY(!enter.isAccepted());
}

void BenchPanelTest::aRoleIsFilledByMenuAndByKeyboard() {
  ShownPanel shown({listedEncoder(), listedBoard()});
  auto& list = shown.find<DeviceList>("devices");
  list.setFocus();
  QTest::keyClick(&list, Qt::Key_Down);
  QTest::keyClick(&list, Qt::Key_Return);
  auto* menu = shown.panel.findChild<QMenu*>(QStringLiteral("deviceMenu"));
  QVERIFY(menu != nullptr);
  QCOMPARE(menu->actions().first()->text(), QStringLiteral("Use as: Sensor under calibration"));
  menu->actions().first()->trigger();
  menu->close();
  QCOMPARE(shown.serialIn(Role::AngleSensor), std::string("ACM-1"));

  auto& combo = shown.find<QComboBox>("device-angle-reference");
  combo.setFocus();
  QTest::keyClick(&combo, Qt::Key_Down);
  QCOMPARE(shown.serialIn(Role::AngleReference), std::string("FT-1"));
  auto& behind = shown.find<QComboBox>("instrument-angle-reference");
  QVERIFY(behind.isVisible());
  QCOMPARE(behind.currentText(), QStringLiteral("Read as: US Digital QSB encoder reader"));
  behind.setFocus();
  QTest::keyClick(&behind, Qt::Key_Down);
  QCOMPARE(shown.presenter.draft().filling(Role::AngleReference)->instrument, std::string("ascii-board"));
  QTest::keyClick(&combo, Qt::Key_Home);
  QCOMPARE(shown.serialIn(Role::AngleReference), std::string());
}

void BenchPanelTest::theCommandThatMendsIsCopied() {
  ShownPanel shown({listedTeslameter()}, fieldRoleSlots());
  QCOMPARE(
      shown.find<QLabel>("deviceProblem").text(),
      QStringLiteral("Cannot be opened: access to the USB device is denied. To mend it, run: installer/run --udev, "
                     "then plug the device in again."));
  QVERIFY(shown.find<QPushButton>("copyCommand").isVisible());
  shown.click("copyCommand");
  QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("installer/run --udev"));
  QVERIFY(shown.find<QLabel>("deviceWhere").text().contains(QStringLiteral("Not yet tried on hardware")));
}

void BenchPanelTest::settingsAreCheckedWhileTheyAreTyped() {
  ShownPanel shown({listedEncoder(), listedBoard()});
  shown.drop(0, "role-angle-reference");
  shown.click("settings-angle-reference");
  auto* dialog = shown.panel.findChild<QDialog*>(QStringLiteral("instrumentSettings"));
  QVERIFY(dialog != nullptr);
  auto* counts = dialog->findChild<QLineEdit*>(QStringLiteral("setting-counts_per_turn"));
  auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  counts->selectAll();
  QTest::keyClicks(counts, QStringLiteral("many"));
  QVERIFY(!ok->isEnabled());
  QVERIFY(!dialog->findChild<QLabel*>(QStringLiteral("settingsProblem"))->text().isEmpty());
  counts->selectAll();
  QTest::keyClicks(counts, QStringLiteral("3600"));
  QVERIFY(ok->isEnabled());
  dialog->findChild<QComboBox*>(QStringLiteral("baud"))->setEditText(QStringLiteral("57600"));
  QTest::mouseClick(ok, Qt::LeftButton);
  const devices::BenchInstrument* set = shown.presenter.draft().filling(Role::AngleReference);
  QCOMPARE(set->settings, (devices::SettingValues{{"counts_per_turn", "3600"}}));
  QCOMPARE(set->baud, std::optional(57600));
}

void BenchPanelTest::benchesAreSavedLoadedAndDeleted() {
  ShownPanel shown({listedEncoder(), listedBoard()});
  QVERIFY(!shown.find<QPushButton>("saveBenchAs").isEnabled());
  shown.drop(1, "role-angle-sensor");
  shown.click("saveBenchAs");
  auto* ask = shown.panel.findChild<QInputDialog*>(QStringLiteral("benchNameDialog"));
  QVERIFY(ask != nullptr);
  ask->setTextValue(QStringLiteral("lab"));
  ask->accept();
  auto& saved = shown.find<QComboBox>("savedBenches");
  QCOMPARE(saved.currentText(), QStringLiteral("lab"));
  shown.drop(0, "role-angle-reference");
  QCOMPARE(saved.currentText(), QStringLiteral("lab (changed)"));
  saved.setFocus();
  QTest::keyClick(&saved, Qt::Key_Home); // New bench
  QVERIFY(shown.presenter.draft().bench().instruments.empty());
  QTest::keyClick(&saved, Qt::Key_Down);
  QCOMPARE(shown.serialIn(Role::AngleSensor), std::string("ACM-1"));
  QCOMPARE(shown.serialIn(Role::AngleReference), std::string()); // as it was saved
  shown.click("deleteBench");
  auto* question = shown.panel.findChild<QMessageBox*>(QStringLiteral("deleteBenchQuestion"));
  QVERIFY(question != nullptr);
  for (QAbstractButton* button : question->buttons()) {
    if (button->text() == QStringLiteral("Delete")) {
      QTest::mouseClick(button, Qt::LeftButton);
      break;
    }
  }
  QVERIFY(devices::savedBenchNames().empty());
  QCOMPARE(saved.currentText(), QStringLiteral("New bench"));
}

void BenchPanelTest::consoleIsReachedByKeyboard() {
  ShownPanel shown({listedBoard()});
  QVERIFY(shown.panel.console().isHidden());
  QTest::keyClick(&shown.panel, Qt::Key_K, Qt::ControlModifier);
  QVERIFY(!shown.panel.console().isHidden());
  QVERIFY(!shown.find<QPushButton>("consoleSend").isEnabled()); // not connected
  QCOMPARE(shown.find<QLineEdit>("consoleCommand").placeholderText(),
           QStringLiteral("Connect the bench to send a command"));
  QTest::keyClick(&shown.panel, Qt::Key_K, Qt::ControlModifier);
  QVERIFY(shown.panel.console().isHidden());
}

std::unique_ptr<QObject> makeBenchPanelTest() { return std::make_unique<BenchPanelTest>(); }

} // namespace straightedge::gui

#include "bench_panel_test.moc"
