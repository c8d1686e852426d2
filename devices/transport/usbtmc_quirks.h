// Instruments that keep USBTMC in their own way, as a table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace straightedge::devices {

struct UsbTmcQuirks {
  bool resetAtOpen = false;     ///< hangs from an earlier program until it is reset
  bool noRemoteControl = false; ///< REN_CONTROL disturbs it
  bool noClear = false;         ///< INITIATE_CLEAR hangs it
  bool headerOnlyOnce = false; ///< a long reply goes on without further requests and headers; end of message always set
  bool noEndOfMessage = false; ///< one transfer is the whole reply, never marked as its end
  std::uint32_t largestRequest = 0; ///< bytes to ask for at a time; 0: no limit known
};

struct UsbTmcQuirkEntry {
  std::uint16_t vendorId = 0;
  std::uint16_t productId = 0; ///< 0: every product of the vendor without an entry of its own
  std::string_view model;
  std::string_view source;
  UsbTmcQuirks quirks;
};

std::span<const UsbTmcQuirkEntry> usbTmcQuirkTable();

/// None of them for a device that is not in the table.
UsbTmcQuirks usbTmcQuirks(std::uint16_t vendorId, std::uint16_t productId);

} // namespace straightedge::devices
