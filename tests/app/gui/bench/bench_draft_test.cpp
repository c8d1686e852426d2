// Roles filled, given up and checked; the words about devices; the dialogue's file.
#include "app/gui/bench/bench_draft.h"
#include "app/gui/bench/device_words.h"
#include "app/gui/bench/dialogue_model.h"
#include "tests/app/gui/bench/listed_devices.h"
#include "tests/app/gui/bench/test_classes.h"

#include <QTemporaryDir>
#include <QTest>

namespace straightedge::gui {

using Role = devices::InstrumentRole;

class BenchDraftTest : public QObject {
  Q_OBJECT
private slots:
  void aRoleTakesADevice();
  void aDeviceKeepsBeingOneInstrument();
  void whatCannotFillIsRefused();
  void anotherInstrumentBeginsAnew();
  void checksWhatIsMissing();
  void commandsAreFoundInRemedies();
  void cautionStaysMarked();
  void readingsAsText();
  void dialogueIsKeptAndSaved();
};

namespace {

BenchDraft angleDraft() { return BenchDraft(angleRoleSlots(), devices::readProfiles({})); }

/// A transport that only has a name.
class NamedTransport : public devices::Transport {
public:
  std::string name() const override { return "/dev/ttyACM0"; }
  devices::TransportResult<void> write(std::string_view, devices::Milliseconds) override { return {}; }
  devices::TransportResult<std::string> read(devices::Milliseconds) override { return std::string(); }
  devices::TransportResult<std::string> readUntil(std::string_view, devices::Milliseconds) override {
    return std::string();
  }
  devices::TransportResult<void> clear() override { return {}; }
};

void exchange(DialogueLog& log, const std::string& name, int connection, devices::DialogueMark mark,
              const std::string& bytes) {
  const devices::BenchInstrument wanted;
  const NamedTransport transport;
  const devices::DialogueEntry entry{.timeS = 0.0, .mark = mark, .bytes = bytes, .fault = {}, .line = 0};
  log.add({.instrument = name, .wanted = wanted, .connection = connection, .transport = transport, .entry = entry});
}

} // namespace

void BenchDraftTest::aRoleTakesADevice() {
  BenchDraft draft = angleDraft();
  QVERIFY(draft.assign(Role::AngleReference, listedEncoder()));
  QVERIFY(draft.assign(Role::AngleSensor, listedBoard()));
  QCOMPARE(draft.bench().instruments.size(), std::size_t{2});
  QCOMPARE(draft.filling(Role::AngleReference)->instrument, std::string("usdigital-qsb"));
  QCOMPARE(draft.filling(Role::AngleReference)->serial, std::string("FT-1"));
  QCOMPARE(draft.filling(Role::AngleReference)->port, std::string());
  QVERIFY(draft.assign(Role::AngleReference, listedBoard())); // takes it from the encoder
  QCOMPARE(draft.filling(Role::AngleReference)->serial, std::string("ACM-1"));
  QCOMPARE(draft.bench().instruments.size(), std::size_t{1});
  draft.clear(Role::AngleReference);
  draft.clear(Role::AngleSensor);
  QVERIFY(draft.bench().instruments.empty());
}

void BenchDraftTest::aDeviceKeepsBeingOneInstrument() {
  BenchDraft draft = angleDraft();
  QVERIFY(draft.assign(Role::AngleReference, listedEncoder())); // taken for a QSB, which has no temperature
  QVERIFY(draft.assign(Role::Temperature, listedEncoder()));    // the board can do both
  QCOMPARE(draft.bench().instruments.size(), std::size_t{1});
  QCOMPARE(draft.bench().instruments[0].instrument, std::string("ascii-board"));
  QCOMPARE(draft.bench().instruments[0].roles, (std::vector{Role::AngleReference, Role::Temperature}));
}

void BenchDraftTest::whatCannotFillIsRefused() {
  BenchDraft draft = angleDraft();
  const auto mouse = draft.assign(Role::AngleSensor, listedMouse());
  QVERIFY(!mouse);
  QVERIFY(mouse.error().what.ends_with("cannot fill the role angle-sensor"));
  devices::ListedDevice nameless = listedBoard();
  nameless.serial.clear();
  const auto refused = draft.assign(Role::AngleSensor, nameless);
  QVERIFY(!refused);
  QVERIFY(refused.error().what.contains("has no serial number"));
  nameless.port = devices::SerialPortInfo{
      .path = "/dev/ttyS0", .description = {}, .vendorId = {}, .productId = {}, .usbSerial = {}, .usbProduct = {}};
  QVERIFY(draft.assign(Role::AngleSensor, nameless));
  QCOMPARE(draft.filling(Role::AngleSensor)->port, std::string("/dev/ttyS0"));
}

void BenchDraftTest::anotherInstrumentBeginsAnew() {
  BenchDraft draft = angleDraft();
  QVERIFY(draft.assign(Role::AngleReference, listedEncoder()));
  devices::BenchInstrument set = *draft.filling(Role::AngleReference);
  set.settings["counts_per_turn"] = "3600";
  set.latencyS = 0.25;
  draft.setInstrument(Role::AngleReference, set);
  QCOMPARE(draft.filling(Role::AngleReference)->settings.at("counts_per_turn"), std::string("3600"));
  QCOMPARE(draft.choices(Role::AngleReference, {listedEncoder()}),
           (std::vector<std::string>{"usdigital-qsb", "ascii-board"}));
  draft.chooseInstrument(Role::AngleReference, "ascii-board");
  QCOMPARE(draft.filling(Role::AngleReference)->instrument, std::string("ascii-board"));
  QVERIFY(draft.filling(Role::AngleReference)->settings.empty());
  draft.chooseInstrument(Role::AngleReference, "metrolab-thm1176"); // cannot
  QCOMPARE(draft.filling(Role::AngleReference)->instrument, std::string("ascii-board"));
}

void BenchDraftTest::checksWhatIsMissing() {
  BenchDraft draft = angleDraft();
  QCOMPARE(draft.check().error().what, std::string("nothing fills the role 'Sensor under calibration'"));
  QVERIFY(draft.assign(Role::AngleSensor, listedBoard()));
  QCOMPARE(draft.check().error().what, std::string("nothing fills the role 'Reference encoder'"));
  QVERIFY(draft.assign(Role::AngleReference, listedEncoder()));
  QVERIFY(!draft.check()); // a QSB does not know its counts per turn
  QVERIFY(draft.check().error().message().contains("counts_per_turn") ||
          draft.check().error().message().contains("Counts per turn"));
  devices::BenchInstrument set = *draft.filling(Role::AngleReference);
  set.settings["counts_per_turn"] = "3600";
  draft.setInstrument(Role::AngleReference, set);
  QVERIFY(draft.check());
}

void BenchDraftTest::commandsAreFoundInRemedies() {
  QCOMPARE(commandIn(QStringLiteral("run: installer/run --udev, then plug the device in again")).value(),
           QStringLiteral("installer/run --udev"));
  QCOMPARE(commandIn(QStringLiteral("run: sudo usermod -aG dialout $USER, then log in again")).value(),
           QStringLiteral("sudo usermod -aG dialout $USER"));
  QVERIFY(!commandIn(QStringLiteral("close the program that uses it, then try again")));
}

void BenchDraftTest::cautionStaysMarked() {
  const devices::ProfileSet profiles = devices::readProfiles({});
  QCOMPARE(
      instrumentCaution("usdigital-qsb", profiles),
      QStringLiteral("Not yet tried on hardware. Not confirmed: the bit of the direction, the unit of its stamps."));
  QVERIFY(instrumentCaution(profiles.profiles.front().id, profiles).startsWith("Not yet tried on hardware."));
  QCOMPARE(deviceUse(listedMouse(), angleRoleSlots()), QStringLiteral("Not an instrument that Straightedge knows"));
  QCOMPARE(deviceUse(listedTeslameter(), angleRoleSlots()), QStringLiteral("Of no use for this kind of calibration"));
  QCOMPARE(deviceUse(listedTeslameter(), fieldRoleSlots()), QStringLiteral("Is used as: Teslameter under calibration"));
  QCOMPARE(deviceWhere(listedBoard()), QStringLiteral("2341:0043, serial ACM-1"));
}

void BenchDraftTest::readingsAsText() {
  QCOMPARE(roleReadingText(Role::AngleSensor, {.values = {123.45678}, .note = {}}), QStringLiteral("123.4568°"));
  QCOMPARE(roleReadingText(Role::FieldProbe, {.values = {0.25, -0.5, 1.0}, .note = {}}),
           QStringLiteral("0.250000  −0.500000  1.000000 T"));
  QCOMPARE(roleReadingText(Role::FieldReference, {.values = {}, .note = "not locked"}), QStringLiteral("not locked"));
}

void BenchDraftTest::dialogueIsKeptAndSaved() {
  DialogueLog log;
  DialogueModel model(log);
  exchange(log, "encoder", 1, devices::DialogueMark::Sent, "R0E\r\n");
  exchange(log, "board", 1, devices::DialogueMark::Received, "12.5\n");
  model.takeNew();
  QCOMPARE(model.rowCount(), 2);
  QCOMPARE(model.index(0, DialogueModel::Instrument).data().toString(), QStringLiteral("encoder"));
  QCOMPARE(model.index(0, DialogueModel::Direction).data().toString(), QStringLiteral("→ sent"));
  QCOMPARE(model.index(0, DialogueModel::Bytes).data().toString(), QStringLiteral("R0E\\r\\n"));
  model.setPaused(true);
  exchange(log, "encoder", 2, devices::DialogueMark::Received, "r 0E\r\n");
  model.takeNew();
  QCOMPARE(model.rowCount(), 2);
  model.setPaused(false);
  model.takeNew();
  QCOMPARE(model.rowCount(), 3);
  model.setInstrument(0);
  QCOMPARE(model.rowCount(), 2);
  model.setText(QStringLiteral("0e\\R"));
  QCOMPARE(model.rowCount(), 2);
  model.setText(QStringLiteral("r 0"));
  QCOMPARE(model.rowCount(), 1);

  const QTemporaryDir folder;
  const std::string file = folder.filePath("dialogue.txt").toStdString();
  QVERIFY(log.save(file, 0));
  const auto read = devices::readDialogue(file);
  QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
  QCOMPARE(read->transportName, std::string("/dev/ttyACM0"));
  QCOMPARE(read->entries.size(), std::size_t{2});
  QCOMPARE(read->entries[1].bytes, std::string("r 0E\r\n"));
  QVERIFY(!log.save(file, 7));

  for (std::size_t i = 0; i < DialogueLog::mostEntries + 10; ++i) {
    exchange(log, "board", 1, devices::DialogueMark::Received, "1\n");
  }
  model.setText({});
  model.setInstrument(std::nullopt);
  QCOMPARE(model.rowCount(), static_cast<int>(DialogueLog::mostEntries));
}

std::unique_ptr<QObject> makeBenchDraftTest() { return std::make_unique<BenchDraftTest>(); }

} // namespace straightedge::gui

#include "bench_draft_test.moc"
