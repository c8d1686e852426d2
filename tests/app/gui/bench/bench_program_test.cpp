// The real program as a child process on emulated instruments under the real libusb, driven by keyboard on a private X
// server: it connects a saved bench, reads it, captures on it, sees an instrument leave and come back, and quits. What
// came of it is seen from outside: in what the instruments were asked, and in the session file. Ends with 77 (skipped)
// where there is no Xvfb or no xdotool.
#include "core/session/session.h"
#include "devices/bench/saved_bench.h"
#include "devices/capture/angle_plan.h"
#include "tests/app/gui/bench/angle_desk.h"
#include "tests/app/gui/end_to_end/private_display.h"
#include "tests/app/gui/end_to_end/typed_window.h"
#include "tests/fakes/usb/thm1176.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

namespace straightedge {

namespace {

constexpr int skippedHere = 77;
constexpr int sweepPoints = 8;
constexpr int readings = 20; ///< more than an instrument is asked for while it is opened

devices::BenchInstrument plugged(const char* instrument, devices::InstrumentRole role, const char* serial,
                                 const devices::SettingValues& settings = {}) {
  devices::BenchInstrument made;
  made.instrument = instrument;
  made.roles = {role};
  made.serial = serial;
  made.settings = settings;
  return made;
}

/// Saves a bench as the one that was used last in calibrations of this kind.
void useBench(const QString& kind, std::vector<devices::BenchInstrument> instruments) {
  QVERIFY(devices::saveBench({.name = "desk", .instruments = std::move(instruments)}).has_value());
  QSettings(QSettings::NativeFormat, QSettings::UserScope, QStringLiteral("Straightedge"),
            QStringLiteral("straightedge"))
      .setValue(QStringLiteral("bench/") + kind, QStringLiteral("desk"));
}

struct Stored {
  std::int64_t samples = -1; ///< −1: cannot be told now
  bool finished = false;     ///< the capture was carried out to its end
};

/// What is on the disk now. The program alone has its file open: a copy of it and of SQLite's journal is looked at,
/// which is what a crash would leave.
Stored storedIn(const QString& file) {
  const QTemporaryDir folder;
  const std::filesystem::path copy = folder.filePath(QStringLiteral("copy.sedge")).toStdString();
  std::error_code ignored; // there may be no journal now; QFile would wait for the disk
  std::filesystem::copy_file(file.toStdString(), copy, ignored);
  std::filesystem::copy_file(file.toStdString() + "-wal", copy.string() + "-wal", ignored);
  const auto opened = session::Session::openReadOnly(copy);
  if (!opened) {
    return {}; // copied while the journal was taken into the file
  }
  const auto samples = (*opened)->angleSampleCount(session::SweepRole::Calibration);
  const auto record = (*opened)->document("capture");
  if (!samples || !record) {
    return {};
  }
  return {*samples, QJsonDocument::fromJson(QByteArray::fromStdString(*record)).object().value("finished").toBool()};
}

} // namespace

class BenchProgramTest : public QObject {
  Q_OBJECT
private slots:
  void init();
  void anAngleBenchIsConnectedReadAndCapturedOn();
  void aFieldBenchIsConnectedAndRead();

private:
  std::unique_ptr<QTemporaryDir> m_home; ///< settings, benches and unsaved sessions of one test
};

void BenchProgramTest::init() {
  m_home = std::make_unique<QTemporaryDir>();
  for (const char* variable : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR"}) {
    qputenv(variable, m_home->path().toUtf8());
  }
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_home->path());
}

void BenchProgramTest::anAngleBenchIsConnectedReadAndCapturedOn() {
  // Deadlines that a busy machine does not reach: a time-out would be a fault, and pause the capture.
  useBench(QStringLiteral("angle"),
           {plugged("usdigital-qsb", devices::InstrumentRole::AngleReference, "FT-1",
                    {{"counts_per_turn", std::to_string(fakes::deskCountsPerTurn)}}),
            plugged("ascii-board", devices::InstrumentRole::AngleSensor, "ACM-1", {{"deadline_s", "60"}})});
  const QString file = m_home->filePath(QStringLiteral("sweep.sedge"));
  devices::AnglePlan plan;
  plan.pointsPerTurn = sweepPoints;
  plan.settleS = 0.0;
  plan.retries = 100;
  {
    const auto made = session::Session::create(file.toStdString(), session::SessionKind::Angle);
    QVERIFY(made.has_value());
    QVERIFY((*made)->setDocument("plan", devices::planToJson(plan)).has_value());
    QVERIFY((*made)->close().has_value());
  }
  const std::vector<devices::PlannedPoint> planned = devices::plannedPoints(plan);

  fakes::EmulatedUsb bus;
  fakes::DeskShaft shaft;
  const auto encoder = fakes::deskEncoder(shaft);
  const auto board = fakes::deskBoard(shaft);
  auto encoderPlug = bus.plug(encoder, {.driver = "ftdi_sio"});
  const auto boardPlug = bus.plug(board, {.driver = "cdc_acm"});
  testing::TypedWindow program;
  QVERIFY2(program.start({file}), qPrintable(program.error()));
  QTRY_COMPARE(program.title(), QStringLiteral("sweep — Straightedge")); // the session is open

  program.press("ctrl+2");
  program.press("ctrl+1");
  QCOMPARE(shaft.asked.load(), 0); // looking what is plugged in asks nothing
  program.press("alt+c");
  QTRY_VERIFY(shaft.asked > readings && shaft.printed > readings);
  QCOMPARE(bus.driver(encoderPlug, 0), std::string("usbfs"));

  // Unplugged on the step Connect: what is left is read on, and what comes back, elsewhere, too.
  bus.unplug(encoderPlug);
  const int printed = shaft.printed;
  QTRY_VERIFY(shaft.printed > printed + readings);
  QVERIFY(program.isRunning());
  const auto again = fakes::deskEncoder(shaft);
  encoderPlug = bus.plug(again, {.port = "7", .driver = "ftdi_sio"});
  const int asked = shaft.asked;
  QTRY_VERIFY(shaft.asked > asked + readings);

  // Captured: a person turns the shaft to the next angle when a point is on the disk.
  program.press("ctrl+2");
  program.press("alt+a");
  for (std::size_t point = 0; point < sweepPoints; ++point) {
    shaft.angleDeg = planned[point].encoderDeg;
    QTRY_COMPARE(storedIn(file).samples, static_cast<std::int64_t>(point) + 1);
    if (point + 1 == sweepPoints / 2) { // unplugged inside an answer
      shaft.leavesAfter = 1;
      QTRY_VERIFY(!bus.isPlugged(encoderPlug));
      QVERIFY(program.isRunning());
      QCOMPARE(storedIn(file).samples, static_cast<std::int64_t>(point) + 1);
      shaft.leavesAfter = -1;
      encoderPlug = bus.plug(fakes::deskEncoder(shaft), {.driver = "ftdi_sio"});
      const int before = shaft.asked; // a shaft that was moved meanwhile would have to be turned back: first it goes on
      QTRY_VERIFY(shaft.asked > before + readings);
    }
  }
  QTRY_VERIFY(storedIn(file).finished);

  program.press("ctrl+q");
  QCOMPARE(program.exitCode(), 0);
  QVERIFY2(program.error().isEmpty(), qPrintable(program.error()));
  QCOMPARE(bus.driver(encoderPlug, 0), std::string("ftdi_sio")); // given back to the kernel's driver
  QCOMPARE(bus.driver(boardPlug, 0), std::string("cdc_acm"));
  for (const auto* device :
       {static_cast<fakes::EmulatedDevice*>(encoder.get()), static_cast<fakes::EmulatedDevice*>(board.get())}) {
    QVERIFY2(device->violations().empty(), device->violations().empty() ? "" : device->violations().front().c_str());
  }
  const auto opened = session::Session::open(file.toStdString());
  QVERIFY(opened.has_value());
  const auto samples = (*opened)->angleSamples(session::SweepRole::Calibration);
  QVERIFY(samples.has_value());
  QCOMPARE(samples->size(), planned.size());
  for (std::size_t i = 0; i < planned.size(); ++i) {
    QCOMPARE(samples->at(i).encoderDeg, planned[i].encoderDeg);
    QVERIFY(std::abs(samples->at(i).sensorDeg - fakes::deskSensorDeg(planned[i].encoderDeg)) <= 0.5e-4); // as printed
  }
}

void BenchProgramTest::aFieldBenchIsConnectedAndRead() {
  useBench(QStringLiteral("field"), {plugged("metrolab-thm1176", devices::InstrumentRole::FieldProbe, "0123456")});
  fakes::EmulatedUsb bus;
  std::atomic<int> fetched = 0;
  auto meter = std::make_shared<fakes::UsbTmcDevice>();
  meter->onMessage(fakes::thm1176Answers([&fetched] {
    ++fetched;
    return std::string(fakes::thm1176Reading);
  }));
  auto plug = bus.plug(meter, {.driver = "usbtmc"});
  testing::TypedWindow program;
  QVERIFY2(program.start({}), qPrintable(program.error()));
  QTRY_COMPARE(program.title(), QStringLiteral("Straightedge"));
  program.press("ctrl+alt+n"); // a new field calibration begins at Connect
  program.press("alt+c");
  QTRY_VERIFY(fetched > readings);
  QVERIFY(program.title() != QStringLiteral("Straightedge"));
  bus.unplug(plug);
  QVERIFY(program.isRunning());
  plug = bus.plug(meter, {.port = "5", .driver = "usbtmc"});
  const int before = fetched;
  QTRY_VERIFY(fetched > before + readings);
  program.press("ctrl+q");
  QCOMPARE(program.exitCode(), 0);
  QVERIFY2(program.error().isEmpty(), qPrintable(program.error()));
  QCOMPARE(bus.driver(plug, 0), std::string("usbtmc"));
  QVERIFY2(meter->violations().empty(), meter->violations().empty() ? "" : meter->violations().front().c_str());
}

} // namespace straightedge

int main(int argc, char** argv) {
  using namespace straightedge;
  for (const auto& [tool, found] :
       {std::pair{"Xvfb", testing::PrivateDisplay::program()}, std::pair{"xdotool", testing::TypedWindow::tool()}}) {
    if (found.isEmpty()) {
      std::printf("SKIPPED: %s is not installed\n", tool);
      return skippedHere;
    }
  }
  testing::PrivateDisplay display;
  if (!display.start()) {
    std::puts("Xvfb does not start");
    return 1;
  }
  qputenv("DISPLAY", display.name());
  qputenv("QT_QPA_PLATFORM", "xcb");
  const QCoreApplication application(argc, argv);
  BenchProgramTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "bench_program_test.moc"
