// Errors of devices/usb as errors of a transport.
#pragma once

#include "devices/transport/transport.h"
#include "devices/usb/usb_error.h"

namespace straightedge::devices {

TransportFault transportFault(UsbFault fault);
TransportError transportError(UsbError error, std::string where);

} // namespace straightedge::devices
