#include "devices/transport/transport.h"

namespace straightedge::devices {

TransportResult<std::uint8_t> Transport::statusByte(Milliseconds /*deadline*/) {
  return std::unexpected(
      TransportError{TransportFault::Unsupported, Error{.kind = ErrorKind::Instrument,
                                                        .what = "this connection has no status byte",
                                                        .remedy = "ask the instrument for its state with a command",
                                                        .where = name()}});
}

} // namespace straightedge::devices
