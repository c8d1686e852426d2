// The instruments that have a driver of their own: how they are recognised, what they are used for, how one is made.
// Instruments that are added by a file are in devices/instruments/profile.h.
#pragma once

#include "devices/instruments/instrument.h"
#include "devices/instruments/instrument_settings.h"
#include "devices/transport/serial_settings.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace straightedge::devices {

enum class Connection : std::uint8_t { Usbtmc, Serial };

struct UsbIds {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  friend bool operator==(const UsbIds&, const UsbIds&) = default;
};

struct KnownInstrument {
  std::string_view id;   ///< "metrolab-thm1176": in saved benches, never changed
  std::string_view name; ///< for people
  std::vector<Connection> connections;
  std::vector<UsbIds> usb;                     ///< of the instrument or of the adapter inside it; empty: none known
  bool usbIdsAreAdapters = false;              ///< the ids are a common adapter's: anything may be behind it
  std::vector<std::string_view> identityParts; ///< one of them is in its reply to *IDN?; empty: it cannot be asked
  std::optional<SerialSettings> serial;        ///< as it is delivered
  std::vector<InstrumentRole> roles;           ///< that it can fill with some setting
  bool notYetTried = true;                     ///< nobody has yet tried this driver on hardware: the window says so
  std::string_view unconfirmed;                ///< what in it no primary text confirms, in one clause; may be empty
  const std::vector<SettingDescription>& (*settings)() = nullptr;
  Result<std::unique_ptr<Instrument>> (*make)(Transport&, BenchClock&, const SettingValues&) = nullptr;
};

/// All of them. Any thread.
std::span<const KnownInstrument> knownInstruments();

/// By id; null if there is none.
const KnownInstrument* knownInstrument(std::string_view id);

/// Those whose USB ids these are. Several where the ids are an adapter's.
std::vector<const KnownInstrument*> knownByUsb(UsbIds ids);

/// By the reply to *IDN?; null if it is none of them.
const KnownInstrument* knownByIdentity(std::string_view reply);

} // namespace straightedge::devices
