#include "devices/instruments/instrument_table.h"

#include "devices/instruments/ascii_board.h"
#include "devices/instruments/dtm151.h"
#include "devices/instruments/pt2025.h"
#include "devices/instruments/qsb.h"
#include "devices/instruments/scpi_multimeter.h"
#include "devices/instruments/thm1176.h"

#include <algorithm>

namespace straightedge::devices {

namespace {

using Role = InstrumentRole;

std::vector<KnownInstrument> makeTable() {
  return {
      {.id = "metrolab-thm1176",
       .name = "Metrolab THM1176 / TFM1186 three-axis teslameter",
       .connections = {Connection::Usbtmc},
       .usb = {{0x1bfa, 0x0498}},
       .identityParts = {"THM1176", "TFM1186"},
       .serial = {},
       .roles = {Role::FieldProbe},
       .unconfirmed = "what a field beyond the range looks like, automatic ranges, its temperature in °C",
       .settings = thm1176Settings,
       .make = Thm1176::make},
      {.id = "metrolab-pt2025",
       .name = "Metrolab PT2025 NMR teslameter",
       .connections = {Connection::Serial},
       .usb = {},
       .identityParts = {},
       .serial = pt2025Serial,
       .roles = {Role::FieldReference},
       .unconfirmed = "ranges of the probes",
       .settings = pt2025Settings,
       .make = Pt2025::make},
      {.id = "usdigital-qsb",
       .name = "US Digital QSB encoder reader",
       .connections = {Connection::Serial},
       .usb = {{0x0403, 0x6001}}, // FT232R
       .usbIdsAreAdapters = true,
       .identityParts = {},
       .serial = qsbSerial,
       .roles = {Role::AngleReference},
       .unconfirmed = "the bit of the direction, the unit of its stamps",
       .settings = qsbSettings,
       .make = Qsb::make},
      {.id = "ascii-board",
       .name = "Board that prints lines of text",
       .connections = {Connection::Serial},
       .usb = {},
       .identityParts = {},
       .serial = SerialSettings{},
       .roles = {Role::AngleSensor, Role::AngleReference, Role::Temperature},
       .unconfirmed = "",
       .settings = asciiBoardSettings,
       .make = AsciiBoard::make},
      {.id = "scpi-multimeter",
       .name = "SCPI multimeter of the 34401A family",
       .connections = {Connection::Usbtmc, Connection::Serial},
       .usb = {},
       .identityParts = {"34401A", "34410A", "34411A", "34460A", "34461A", "34465A", "34470A"},
       .serial = scpiMultimeterSerial,
       .roles = {Role::Resistance, Role::AngleSensor},
       .unconfirmed = "models other than the 34401A",
       .settings = scpiMultimeterSettings,
       .make = ScpiMultimeter::make},
      {.id = "group3-dtm151",
       .name = "Group3 DTM-151 teslameter",
       .connections = {Connection::Serial},
       .usb = {},
       .identityParts = {},
       .serial = dtm151Serial,
       .roles = {Role::FieldReference, Role::Temperature},
       .unconfirmed = "its line settings, which are set by switches",
       .settings = dtm151Settings,
       .make = Dtm151::make},
  };
}

} // namespace

std::span<const KnownInstrument> knownInstruments() {
  static const std::vector<KnownInstrument> table = makeTable();
  return table;
}

const KnownInstrument* knownInstrument(std::string_view id) {
  const auto all = knownInstruments();
  const auto found = std::ranges::find(all, id, &KnownInstrument::id);
  return found == all.end() ? nullptr : &*found;
}

std::vector<const KnownInstrument*> knownByUsb(UsbIds ids) {
  std::vector<const KnownInstrument*> found;
  for (const KnownInstrument& known : knownInstruments()) {
    if (std::ranges::find(known.usb, ids) != known.usb.end()) {
      found.push_back(&known);
    }
  }
  return found;
}

const KnownInstrument* knownByIdentity(std::string_view reply) {
  for (const KnownInstrument& known : knownInstruments()) {
    if (std::ranges::any_of(known.identityParts, [&](std::string_view part) { return reply.contains(part); })) {
      return &known;
    }
  }
  return nullptr;
}

} // namespace straightedge::devices
