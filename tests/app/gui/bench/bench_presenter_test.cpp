// What the window says about a desk that is only pretended: listing, roles, saved benches, a bench that does not open.
#include "app/gui/bench/bench_presenter.h"
#include "app/gui/jobs/job_runner.h"
#include "devices/bench/bench_folder.h"
#include "tests/app/gui/bench/listed_devices.h"
#include "tests/app/gui/bench/test_classes.h"

#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

namespace straightedge::gui {

using Role = devices::InstrumentRole;

class BenchPresenterTest : public QObject {
  Q_OBJECT
private slots:
  void init();
  void nothingIsSaid();
  void listsLiveAndOnlyChanges();
  void tellsWhyOneCannotBeOpened();
  void aSystemThatCannotBeAskedIsSaid();
  void remembersRolesPerBench();
  void savingIsChecked();
  void aBrokenBenchFileIsExplained();
  void aBenchThatDoesNotOpenSaysWhy();
};

namespace {

struct Desk {
  JobRunner jobs;
  PretendedDesk plugged;
  BenchPresenter presenter;

  explicit Desk(const std::vector<devices::ListedDevice>& devices = {},
                const std::vector<RoleSlot>& roles = angleRoleSlots())
      : presenter(jobs,
                  {.kind = QStringLiteral("test"), .roles = roles, .lister = lister(devices), .byEvents = false}) {
    presenter.setShown(true);
  }
  void plug(const std::vector<devices::ListedDevice>& devices) {
    QSignalSpy changed(&presenter.watch(), &DeviceWatch::changed);
    plugged.put(devices);
    presenter.watch().lookNow();
    QVERIFY(changed.wait(60000));
  }
  bool waitForFirstLook() {
    QSignalSpy changed(&presenter.watch(), &DeviceWatch::changed);
    return presenter.watch().hasLooked() || changed.wait(60000);
  }

private:
  devices::DeviceLister lister(const std::vector<devices::ListedDevice>& devices) {
    plugged.put(devices);
    return plugged.lister();
  }
};

int choiceNamed(const BenchPresenter::RoleView& view, const QString& text) {
  for (std::size_t i = 0; i < view.choices.size(); ++i) {
    if (view.choices[i].text.contains(text)) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

} // namespace

void BenchPresenterTest::init() {
  QSettings().clear();
  for (const std::string& name : devices::savedBenchNames()) {
    QVERIFY(devices::deleteBench(name));
  }
}

void BenchPresenterTest::nothingIsSaid() {
  Desk desk;
  QCOMPARE(desk.presenter.devicesNote(), QStringLiteral("Looking at what is plugged in…"));
  QVERIFY(desk.waitForFirstLook());
  QVERIFY(desk.presenter.devicesNote().startsWith(QStringLiteral("Nothing is plugged in")));
  QVERIFY(desk.presenter.devicesNote().contains(QStringLiteral("simulated bench works without any")));
  QVERIFY(desk.presenter.deviceRows().empty());
}

void BenchPresenterTest::listsLiveAndOnlyChanges() {
  Desk desk({listedEncoder()});
  QVERIFY(desk.waitForFirstLook());
  QCOMPARE(desk.presenter.deviceRows().size(), std::size_t{1});
  QSignalSpy changed(&desk.presenter, &BenchPresenter::devicesChanged);
  const int before = desk.plugged.looks();
  desk.presenter.watch().lookNow();
  QTRY_VERIFY(desk.plugged.looks() > before + 1);
  QCOMPARE(changed.count(), 0);
  desk.plug({listedEncoder(), listedBoard()});
  QCOMPARE(desk.presenter.deviceRows()[1].title, QStringLiteral("Arduino Uno"));
  QCOMPARE(desk.presenter.deviceRows()[1].use,
           QStringLiteral("May be: Sensor under calibration, Reference encoder, Temperature"));
  desk.presenter.assign(Role::AngleSensor, 1);
  QCOMPARE(desk.presenter.deviceRows()[1].use, QStringLiteral("Used as: Sensor under calibration"));
  desk.plug({listedEncoder()}); // without any event: it is simply not there any more
  const BenchPresenter::RoleView view = desk.presenter.roleViews()[0];
  QVERIFY(view.filled);
  QVERIFY(view.choices[static_cast<std::size_t>(view.chosen)].text.contains(QStringLiteral("not plugged in")));
}

void BenchPresenterTest::tellsWhyOneCannotBeOpened() {
  Desk desk({listedTeslameter(), listedMouse()}, fieldRoleSlots());
  QVERIFY(desk.waitForFirstLook());
  const BenchPresenter::DeviceRow meter = desk.presenter.deviceRows()[0];
  QCOMPARE(meter.problem, QStringLiteral("access to the USB device is denied"));
  QCOMPARE(meter.remedy, QStringLiteral("run: installer/run --udev, then plug the device in again"));
  QVERIFY(meter.caution.startsWith(QStringLiteral("Not yet tried on hardware.")));
  QVERIFY(meter.useful);
  QVERIFY(!desk.presenter.deviceRows()[1].useful);
  QCOMPARE(desk.presenter.rolesFor(0), std::vector{Role::FieldProbe});
  QVERIFY(desk.presenter.rolesFor(1).empty());
}

void BenchPresenterTest::aSystemThatCannotBeAskedIsSaid() {
  Desk desk;
  QVERIFY(desk.waitForFirstLook());
  QSignalSpy changed(&desk.presenter.watch(), &DeviceWatch::changed);
  desk.plugged.breakDown({ErrorKind::Instrument, "libusb cannot start", "install libusb 1.0", "USB"});
  desk.presenter.watch().lookNow();
  QVERIFY(changed.wait(60000));
  QCOMPARE(desk.presenter.devicesNote(), QStringLiteral("USB: Libusb cannot start; install libusb 1.0"));
}

void BenchPresenterTest::remembersRolesPerBench() {
  {
    Desk desk({listedEncoder(), listedBoard()});
    QVERIFY(desk.waitForFirstLook());
    desk.presenter.assign(Role::AngleReference, 0);
    desk.presenter.assign(Role::AngleSensor, 1);
    devices::BenchInstrument encoder = *desk.presenter.draft().filling(Role::AngleReference);
    encoder.settings["counts_per_turn"] = "3600";
    desk.presenter.setInstrument(Role::AngleReference, encoder);
    desk.presenter.setPairing({devices::PairingKind::Interpolate, 0.5});
    QVERIFY(desk.presenter.isChanged());
    QVERIFY(desk.presenter.save(QStringLiteral("desk")));
    QVERIFY(!desk.presenter.isChanged());
    desk.presenter.clear(Role::AngleReference);
    QVERIFY(desk.presenter.save(QStringLiteral("half")));
    QCOMPARE(desk.presenter.savedNames(), QStringList({"desk", "half"}));
    desk.presenter.load(QStringLiteral("desk"));
  }
  Desk later({listedEncoder()}); // another day, the board not plugged in yet
  QVERIFY(later.waitForFirstLook());
  QCOMPARE(later.presenter.benchName(), QStringLiteral("desk"));
  QCOMPARE(later.presenter.draft().filling(Role::AngleReference)->settings.at("counts_per_turn"), std::string("3600"));
  QCOMPARE(later.presenter.draft().bench().pairing.maxAgeS, 0.5);
  const auto views = later.presenter.roleViews();
  QVERIFY(choiceNamed(views[1], QStringLiteral("FT-1")) == views[1].chosen);
  QVERIFY(views[0].choices[static_cast<std::size_t>(views[0].chosen)].text.contains(QStringLiteral("not plugged in")));
  later.presenter.deleteSaved(QStringLiteral("desk"));
  QCOMPARE(later.presenter.savedNames(), QStringList({"half"}));
  QVERIFY(later.presenter.draft().filling(Role::AngleReference) != nullptr); // stays, unsaved
  QVERIFY(later.presenter.benchName().isEmpty());
}

void BenchPresenterTest::savingIsChecked() {
  Desk desk({listedBoard()});
  QVERIFY(desk.waitForFirstLook());
  QVERIFY(!desk.presenter.save(QStringLiteral("desk")));
  QVERIFY(desk.presenter.problem().contains(QStringLiteral("no instruments yet")));
  desk.presenter.assign(Role::AngleSensor, 0);
  QVERIFY(desk.presenter.problem().isEmpty());
  QVERIFY(!desk.presenter.save(QStringLiteral("a/b")));
  QCOMPARE(desk.presenter.problem(), QStringLiteral("'a/b' cannot be the name of a bench; choose a word without '/'"));
}

void BenchPresenterTest::aBrokenBenchFileIsExplained() {
  Desk desk({listedBoard()});
  QVERIFY(desk.waitForFirstLook());
  desk.presenter.assign(Role::AngleSensor, 0);
  QVERIFY(desk.presenter.save(QStringLiteral("good")));
  QFile file(QString::fromStdString(devices::benchFile("broken")));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("{ \"format\": \n");
  file.close();
  QVERIFY(desk.presenter.save(QStringLiteral("good"))); // reads the folder again
  QCOMPARE(desk.presenter.savedNames(), QStringList({"broken", "good"}));
  desk.presenter.load(QStringLiteral("broken"));
  QVERIFY2(desk.presenter.problem().contains(QStringLiteral("broken.json:")), qPrintable(desk.presenter.problem()));
  QCOMPARE(desk.presenter.benchName(), QStringLiteral("good"));
}

void BenchPresenterTest::aBenchThatDoesNotOpenSaysWhy() {
  Desk desk({listedEncoder(), listedBoard()});
  QVERIFY(desk.waitForFirstLook());
  desk.presenter.open();
  QCOMPARE(desk.presenter.problem(),
           QStringLiteral("Nothing fills the role 'Sensor under calibration'; drag a device onto it, or choose one in "
                          "its list"));
  desk.presenter.assign(Role::AngleReference, 0);
  desk.presenter.assign(Role::AngleSensor, 1);
  devices::BenchInstrument encoder = *desk.presenter.draft().filling(Role::AngleReference);
  encoder.settings["counts_per_turn"] = "3600";
  desk.presenter.setInstrument(Role::AngleReference, encoder);
  desk.plug({});
  QSignalSpy state(&desk.presenter, &BenchPresenter::stateChanged);
  desk.presenter.open();
  QCOMPARE(desk.presenter.opener().state(), BenchOpener::State::Opening);
  QVERIFY(!desk.presenter.mayEdit());
  QTRY_COMPARE(desk.presenter.opener().state(), BenchOpener::State::Closed);
  QVERIFY2(desk.presenter.problem().contains(QStringLiteral("the instrument is not plugged in")),
           qPrintable(desk.presenter.problem()));
  QVERIFY(desk.presenter.mayEdit());
}

std::unique_ptr<QObject> makeBenchPresenterTest() { return std::make_unique<BenchPresenterTest>(); }

} // namespace straightedge::gui

#include "bench_presenter_test.moc"
