#include "devices/transport/usb_faults.h"

namespace straightedge::devices {

TransportFault transportFault(UsbFault fault) {
  switch (fault) {
  case UsbFault::AccessDenied:
    return TransportFault::AccessDenied;
  case UsbFault::Busy:
    return TransportFault::Busy;
  case UsbFault::Gone:
    return TransportFault::Gone;
  case UsbFault::TimedOut:
    return TransportFault::TimedOut;
  case UsbFault::Stalled:
    return TransportFault::Stalled;
  case UsbFault::Overflow:
    return TransportFault::Overflow;
  case UsbFault::Unsupported:
    return TransportFault::Unsupported;
  case UsbFault::Cancelled: // its error is of kind Cancelled
  case UsbFault::Failed:
    break;
  }
  return TransportFault::Failed;
}

TransportError transportError(UsbError error, std::string where) {
  error.error.where = std::move(where);
  return {transportFault(error.fault), std::move(error.error)};
}

} // namespace straightedge::devices
