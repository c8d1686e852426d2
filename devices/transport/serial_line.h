// A tty's line settings, by the kernel's own interface: any rate, not only those with a name.
#pragma once

#include "devices/transport/serial_settings.h"

#include <optional>
#include <string>

namespace straightedge::devices {

/// Raw mode with these settings; the first one that is refused, in words, or nothing. Pseudo terminals and some
/// adapters have no control lines: there dtr, rts and RtsCts are without effect.
std::optional<std::string> setUpLine(int descriptor, const SerialSettings& settings);

/// Throws away what waits in either direction.
bool emptyLine(int descriptor);

} // namespace straightedge::devices
