// capture field by the real program on an emulated THM1176, PT2025 and multimeter, with a person who does what it asks
// for.
#include "core/field/campaign_csv.h"
#include "devices/bench/saved_bench.h"
#include "devices/instruments/thm1176.h"
#include "devices/simulated/bench_clock.h"
#include "devices/transport/replay_transport.h"
#include "tests/app/cli/child_process.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/devices/bench/emulated_field_desk.h"
#include "tests/fakes/usb/emulated_usb.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <sstream>

namespace straightedge::fakes {
namespace {

using straightedge::testing::ChildResult;
using straightedge::testing::runCli;
using straightedge::testing::runCliAttended;
using ::testing::HasSubstr;
using ::testing::Not;

class FieldBenchCapture : public ::testing::Test {
protected:
  void plugAll() {
    m_bus.plug(m_desk.teslameter());
    m_bus.plug(m_desk.nmr());
    m_bus.plug(m_desk.multimeter());
  }
  std::vector<std::string> command(const std::string& options, const std::string& bench) const {
    std::vector<std::string> all = {"capture",   "field",
                                    "--bench",   m_folder.write("magnet.json", bench),
                                    "--session", m_folder.file("hall.sedge"),
                                    "--csv",     m_folder.file("hall.csv")};
    const bool begun = options.find("--resume") != std::string::npos; // with the plan that it has
    std::istringstream words(options + (begun ? "" : " --row-time 0.001 --settle 0 --temperature-settle 0"));
    all.insert(all.end(), std::istream_iterator<std::string>(words), {});
    return all;
  }
  /// With a person; `onWait` is called when the program says that it waits for an instrument.
  ChildResult attended(const std::string& options, const std::function<void()>& onWait = {},
                       const std::string& bench = EmulatedFieldDesk::benchJson()) {
    return runCliAttended(command(options, bench), [this, onWait](const std::string& line, pid_t) -> std::string {
      if (line.find("the capture waits for it") != std::string::npos && onWait) {
        onWait();
      }
      if (!line.starts_with("Please ")) {
        return {};
      }
      m_desk.obey(line);
      return "\n";
    });
  }
  ChildResult alone(const std::string& options, const std::string& typed = {},
                    const std::string& bench = EmulatedFieldDesk::benchJson()) const {
    return runCli(command(options, bench), typed);
  }
  /// As exported from the session.
  field::Campaign campaign() const {
    const auto exported =
        runCli({"export", m_folder.file("hall.sedge"), "--format", "csv", "--out", m_folder.file("exported.csv")});
    EXPECT_EQ(exported.code, 0) << exported.err;
    auto read = field::readCampaignCsv(m_folder.file("exported.csv"));
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return read ? *std::move(read) : field::Campaign{};
  }
  /// Each row is a reply of the teslameter with those of the others beside it; replies that were broken off are left
  /// out, and nothing else is.
  void expectRowsAreWhatWasSent(const std::vector<field::CampaignRow>& rows, std::size_t brokenOff) const {
    const EmulatedFieldDesk::Sent sent = m_desk.sent();
    EXPECT_EQ(rows.size() + brokenOff, sent.rawT.size());
    std::size_t reply = 0;
    std::size_t reference = 0;
    for (const field::CampaignRow& row : rows) {
      while (reply < sent.rawT.size() &&
             (row.rawT != sent.rawT[reply] || row.electronicsC != sent.electronicsC[reply])) {
        ++reply; // broken off
      }
      ASSERT_LT(reply, sent.rawT.size()) << "row " << row.line << " was never sent";
      ++reply;
      const auto isThis = [&row](const std::optional<double>& nmrT) {
        return row.locked ? nmrT == std::abs(row.referenceT) : !nmrT;
      };
      while (reference < sent.nmrT.size() && !isThis(sent.nmrT[reference])) {
        ++reference;
      }
      ASSERT_LT(reference, sent.nmrT.size()) << "row " << row.line;
      ++reference;
      EXPECT_EQ(std::isnan(row.referenceT), !row.locked);
      EXPECT_TRUE(std::isnan(row.chamberC));
    }
    std::vector<double> ohm;
    std::ranges::transform(rows, std::back_inserter(ohm), &field::CampaignRow::pt100Ohm);
    EXPECT_EQ(ohm, sent.ohm); // asked last: of a row that was broken off it is not asked
  }

  straightedge::testing::TemporaryFolder m_folder;
  EmulatedFieldDesk m_desk;
  EmulatedUsb m_bus;
};

constexpr const char* scalePlan =
    "--stages nonlinearity,orientation --fields -2,-1.6,-1.2,-0.8,-0.4,0.4,0.8,1.2,1.6,2 --rows 3";

TEST_F(FieldBenchCapture, ReadingsArriveAsTheyWereSentAndTheCampaignFits) {
  plugAll();
  const auto said = attended(scalePlan);
  ASSERT_EQ(said.code, 0) << said.err;
  const auto rows = campaign().rows;
  EXPECT_EQ(m_folder.read("hall.csv"), m_folder.read("exported.csv"));
  constexpr std::size_t plateaus = 3 * 10 + 6 * 3;
  EXPECT_EQ(rows.size(), plateaus * (3 + 1)); // the NMR searches once after each change of the field
  EXPECT_EQ(std::ranges::count(rows, false, &field::CampaignRow::locked), static_cast<long>(plateaus));
  expectRowsAreWhatWasSent(rows, 0);
  EXPECT_EQ(m_desk.sent().nmrT.size(), rows.size());
  for (const auto& row : rows) { // the plan's sign, turned over where the package's minus axis lies along the field
    EXPECT_TRUE(!row.locked || !row.axis || row.referenceT * row.rawT[static_cast<std::size_t>(*row.axis)] > 0.0);
    EXPECT_TRUE(!row.locked || !row.orientation ||
                (row.referenceT < 0.0) == (static_cast<int>(*row.orientation) % 2 == 1));
  }

  const auto fitted = runCli({"field", "fit", m_folder.file("hall.sedge"), "--out", m_folder.path()});
  ASSERT_EQ(fitted.code, 0) << fitted.err;
  const std::string calibration = m_folder.read("calibration.json");
  EXPECT_THAT(calibration, HasSubstr("THM1176-MF")); // the instrument says itself what is calibrated
  EXPECT_THAT(calibration, HasSubstr("Metrolab PT2025"));
  const auto raw = EmulatedFieldDesk::readingT(0.7, 0);
  std::ostringstream reading;
  reading.precision(17);
  reading << "pt100_ohm,electronics_C,raw_x_T,raw_y_T,raw_z_T\n109.35,23," << raw[0] << "," << raw[1] << "," << raw[2];
  const auto applied = runCli(
      {"field", "apply", m_folder.file("calibration.json"), m_folder.write("reading.csv", reading.str() + "\n")});
  ASSERT_EQ(applied.code, 0) << applied.err;
  const std::string row = applied.out.substr(applied.out.find('\n') + 1);
  std::vector<double> cells;
  std::istringstream list(row);
  for (std::string cell; std::getline(list, cell, ',');) {
    cells.push_back(std::stod(cell));
  }
  ASSERT_EQ(cells.size(), 8U) << applied.out;
  EXPECT_NEAR(cells[5], 0.7, 1e-5);
  EXPECT_NEAR(cells[6], 0.0, 1e-4); // the cross axes' cubic term is no part of the chain
  EXPECT_NEAR(cells[7], 0.0, 1e-4);
}

TEST_F(FieldBenchCapture, TheTeslameterUnpluggedInTheMiddleOfAReplyLosesNothing) {
  m_bus.plug(m_desk.nmr());
  m_bus.plug(m_desk.multimeter());
  const auto first = m_bus.plug(m_desk.teslameter(7));
  const auto said = attended("--stages nonlinearity --axes x --fields 0.5,1,1.5 --rows 4", [this] {
    m_bus.plug(m_desk.teslameter(), {.port = "7"}); // the same one, elsewhere
  });
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_FALSE(m_bus.isPlugged(first));
  EXPECT_THAT(said.err, HasSubstr("Metrolab THM1176 / TFM1186 three-axis teslameter, serial 0123456"));
  const auto rows = campaign().rows;
  EXPECT_EQ(std::ranges::count(rows, true, &field::CampaignRow::locked), 3 * 4);
  expectRowsAreWhatWasSent(rows, 1);
}

TEST_F(FieldBenchCapture, TheNmrUnpluggedInTheMiddleOfAReplyLosesNothing) {
  m_bus.plug(m_desk.teslameter());
  m_bus.plug(m_desk.multimeter());
  const auto first = m_bus.plug(m_desk.nmr(7), {.driver = "ftdi_sio"});
  const auto said = attended("--stages nonlinearity --axes y --fields 0.5,-1,1.5 --rows 4",
                             [this] { m_bus.plug(m_desk.nmr(), {.port = "7"}); });
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_FALSE(m_bus.isPlugged(first));
  EXPECT_THAT(said.err, HasSubstr("Metrolab PT2025 NMR teslameter, serial NMR-1"));
  const auto rows = campaign().rows;
  EXPECT_EQ(std::ranges::count(rows, true, &field::CampaignRow::locked), 3 * 4);
  expectRowsAreWhatWasSent(rows, 0); // of the row that was broken off the teslameter was not yet asked
  EXPECT_EQ(m_desk.sent().nmrT.size(), rows.size() + 1);
}

TEST_F(FieldBenchCapture, ATimeOutIsTriedAgainAsThePlanSaysAndThenTold) {
  m_bus.plug(m_desk.teslameter());
  m_bus.plug(m_desk.multimeter());
  m_bus.plug(m_desk.nmr(0, 3));
  const std::string plan = "--stages nonlinearity --axes x --fields 0.5 --rows 4";
  const auto told = alone(plan + " --retries 0 --yes");
  EXPECT_EQ(told.code, 4) << told.err;
  EXPECT_THAT(told.err, HasSubstr("Metrolab PT2025 NMR teslameter, serial NMR-1"));
  EXPECT_THAT(told.err, HasSubstr("or go on with --resume"));
  EXPECT_EQ(campaign().rows.size(), 2U);
  EXPECT_EQ(alone("--resume --yes").code, 0);
  expectRowsAreWhatWasSent(campaign().rows, 0);
  EXPECT_EQ(campaign().rows.size(), 4U);
}

TEST_F(FieldBenchCapture, ATimeOutThatIsTriedAgainLeavesNoGap) {
  m_bus.plug(m_desk.teslameter());
  m_bus.plug(m_desk.multimeter());
  m_bus.plug(m_desk.nmr(0, 3));
  const auto said = alone("--stages nonlinearity --axes x --fields 0.5 --rows 4 --retries 1 --yes");
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(said.err.find("set the field"), said.err.rfind("set the field")) << "nothing is asked for again";
  expectRowsAreWhatWasSent(campaign().rows, 0);
  EXPECT_EQ(campaign().rows.size(), 4U);
}

TEST_F(FieldBenchCapture, UnpluggedWhileItWaitsForAPersonItAsksAgainWhenTheInstrumentIsBack) {
  m_bus.plug(m_desk.nmr());
  m_bus.plug(m_desk.multimeter());
  auto plug = m_bus.plug(m_desk.teslameter());
  const auto said =
      runCliAttended(command("--stages nonlinearity --axes z --fields 0.5,1 --rows 2", EmulatedFieldDesk::benchJson()),
                     [&](const std::string& line, pid_t) -> std::string {
                       if (line.find("the capture waits for it") != std::string::npos) {
                         m_bus.plug(m_desk.teslameter());
                       }
                       if (line.starts_with("Please set the field to 1.000 T") && m_bus.isPlugged(plug)) {
                         m_bus.unplug(plug);
                       }
                       m_desk.obey(line);
                       return line.starts_with("Please ") ? "\n" : "";
                     });
  ASSERT_EQ(said.code, 0) << said.err;
  const std::string again = said.err.substr(said.err.find("the capture waits for it"));
  EXPECT_THAT(again, HasSubstr("Please place the probe with its +z axis along the field, then press Enter\n"
                               "Please set the field to 1.000 T, then press Enter\n"));
  const auto rows = campaign().rows;
  EXPECT_EQ(std::ranges::count(rows, true, &field::CampaignRow::locked), 2 * 2);
  expectRowsAreWhatWasSent(rows, 0);
}

TEST_F(FieldBenchCapture, WhereNobodyIsThereItSaysSoKeepsWhatItHasAndGoesOn) {
  plugAll();
  const std::string plan = "--stages nonlinearity --axes x --fields 0.5,1 --rows 3";
  const auto left = alone(plan, "\n\n"); // the probe placed, the first field set, and then nobody
  EXPECT_EQ(left.code, 2) << left.err;
  EXPECT_THAT(left.err, HasSubstr("Please place the probe with its +x axis along the field, then press Enter\n"));
  EXPECT_THAT(left.err, HasSubstr("nobody confirmed on standard input: set the field to 1.000 T"));
  EXPECT_THAT(left.err, HasSubstr("--yes"));
  EXPECT_THAT(left.err, HasSubstr("--resume"));
  EXPECT_EQ(campaign().rows.size(), 3U);
  const auto resumed = alone("--resume --yes");
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_THAT(resumed.err, HasSubstr("set the field to 1.000 T: taken as done"));
  EXPECT_THAT(resumed.err, Not(HasSubstr("0.5000 T"))); // that plateau is not measured again
  expectRowsAreWhatWasSent(campaign().rows, 0);
  EXPECT_EQ(campaign().rows.size(), 6U);
}

TEST_F(FieldBenchCapture, ItIsStoppedWhileItWaitsForAPerson) {
  plugAll();
  const auto said =
      runCliAttended(command("--stages nonlinearity --axes x --fields 0.5", EmulatedFieldDesk::benchJson()),
                     [](const std::string& line, pid_t child) -> std::string {
                       if (line.starts_with("Please ")) {
                         ::kill(child, SIGTERM);
                       }
                       return {};
                     });
  EXPECT_EQ(said.code, 130) << said.err;
  EXPECT_THAT(said.err, HasSubstr("go on with --resume"));
}

TEST_F(FieldBenchCapture, WhatTheBenchCannotMeasureIsRefusedWhereAskedForAndElseLeftOut) {
  plugAll();
  const auto asked =
      alone("--stages nonlinearity,offset,probe-temperature --yes", {}, EmulatedFieldDesk::benchJson(true, ""));
  EXPECT_EQ(asked.code, 4);
  EXPECT_THAT(asked.err, HasSubstr("magnet: this bench cannot measure probe-temperature without a PT100 meter "
                                   "(resistance) and a thermometer in the probe's chamber (chamber-temperature); "
                                   "offset without a PT100 meter (resistance); add what is missing"));
  EXPECT_EQ(m_folder.listing(), "magnet.json");
  const auto none = alone("--axes x --yes", {}, R"({"format": "straightedge-bench", "version": 1, "name": "bare",
    "instruments": [{"instrument": "metrolab-thm1176", "roles": ["field-probe"], "serial": "0123456"}]})");
  EXPECT_EQ(none.code, 4);
  EXPECT_THAT(none.err,
              HasSubstr("bare: this bench cannot measure nonlinearity, orientation and verification without a "
                        "reference field (field-reference); "));

  const auto said =
      alone("--axes x --fields 0.5 --rows 1 --sweep-rows 10 --yes", {}, EmulatedFieldDesk::benchJson(false, ""));
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("bench magnet cannot measure nonlinearity, electronics-sensitivity, orientation and "
                                  "verification without a reference field (field-reference); "));
  EXPECT_THAT(said.out, HasSubstr("1 stages, "));
  const auto rows = campaign().rows;
  ASSERT_EQ(rows.size(), 10U);
  for (const auto& row : rows) {
    EXPECT_EQ(row.step, field::CampaignStep::Electronics);
    EXPECT_FALSE(std::isnan(row.electronicsC));
    EXPECT_TRUE(std::isnan(row.pt100Ohm) && std::isnan(row.referenceT) && std::isnan(row.chamberC));
  }
}

TEST_F(FieldBenchCapture, AThermometerInTheChamberAndAProfilesPt100FillTheirColumns) {
  plugAll();
  m_bus.plug(m_desk.chamberThermometer());
  const auto said = attended("--stages probe-temperature --sweep-rows 10", {},
                             EmulatedFieldDesk::benchJson(true, "scpi_multimeter_pt100", true));
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("Please begin to sweep the probe from 14.00 to 34.00 °C and back, 2 times"));
  const auto rows = campaign().rows;
  ASSERT_EQ(rows.size(), 10U);
  for (const auto& row : rows) {
    EXPECT_EQ(row.chamberC, 21.5);
    EXPECT_NEAR(row.pt100Ohm, 109.35, 1e-4);
  }
}

TEST_F(FieldBenchCapture, RecordedDialoguesReplayToTheSameReadings) {
  m_bus.plug(m_desk.nmr());
  m_bus.plug(m_desk.multimeter());
  m_bus.plug(m_desk.teslameter(3));
  const std::string dialogues = m_folder.file("dialogues");
  const auto said = attended("--stages nonlinearity --axes x --fields 0.5 --rows 4 --record-dialogue " + dialogues,
                             [this] { m_bus.plug(m_desk.teslameter()); });
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("dialogues with the instruments: 4 files in " + dialogues));
  EXPECT_EQ(m_folder.listing("dialogues"),
            "metrolab-pt2025-NMR-1.dialogue metrolab-thm1176-0123456-2.dialogue metrolab-thm1176-0123456.dialogue "
            "scpi-multimeter-DMM-1.dialogue");
  std::vector<std::array<double, 3>> captured;
  std::ranges::transform(campaign().rows, std::back_inserter(captured), &field::CampaignRow::rawT);
  ASSERT_GE(captured.size(), 4U);

  std::vector<std::array<double, 3>> replayed;
  for (const std::string name : {"metrolab-thm1176-0123456.dialogue", "metrolab-thm1176-0123456-2.dialogue"}) {
    const std::string file = dialogues + "/" + name;
    const auto dialogue = devices::readDialogue(file);
    ASSERT_TRUE(dialogue) << dialogue.error().message();
    devices::ReplayTransport transport(*dialogue, file);
    devices::RealTimeClock clock;
    const auto instrument = devices::Thm1176::make(transport, clock, {{"celsius_per_count", "0.001"}});
    ASSERT_TRUE(instrument);
    const auto prepared = (*instrument)->prepare();
    ASSERT_TRUE(prepared) << prepared.error().message();
    while (!transport.finished()) {
      const auto reading = (*instrument)->fieldProbe()->readT();
      if (!reading) {
        EXPECT_EQ((*instrument)->lastFault(), devices::TransportFault::Gone) << reading.error().message();
        break;
      }
      replayed.push_back(reading->rawT);
    }
    EXPECT_TRUE(transport.finished()) << file;
  }
  EXPECT_EQ(replayed, captured);
  const auto simulated = runCli({"capture", "field", "--bench", "simulated", "--session", m_folder.file("s.sedge"),
                                 "--record-dialogue", dialogues});
  EXPECT_EQ(simulated.code, 2);
}

TEST_F(FieldBenchCapture, ACampaignIsNotGoneOnWithOnAnotherBench) {
  plugAll();
  const std::string plan = "--stages nonlinearity --axes x --fields 0.5,1 --rows 1";
  ASSERT_EQ(alone(plan, "\n\n").code, 2);
  const auto simulated =
      runCli({"capture", "field", "--bench", "simulated", "--session", m_folder.file("hall.sedge"), "--resume"});
  EXPECT_EQ(simulated.code, 2);
  EXPECT_THAT(simulated.err, HasSubstr("begun on the bench 'magnet'"));
  const auto other = alone("--resume --yes", {}, EmulatedFieldDesk::benchJson(true, ""));
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("other instruments or other settings"));
  EXPECT_EQ(campaign().rows.size(), 1U);
  EXPECT_EQ(alone("--resume --yes").code, 0);
  EXPECT_EQ(campaign().rows.size(), 2U);
}

} // namespace
} // namespace straightedge::fakes
