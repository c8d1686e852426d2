// The roles that a kind of calibration asks to be filled, and what an instrument in one reads, as text.
#pragma once

#include "devices/bench/opened_bench.h"

#include <QString>

#include <vector>

namespace straightedge::gui {

struct RoleSlot {
  devices::InstrumentRole role = devices::InstrumentRole::AngleSensor;
  QString title;       ///< "Reference encoder"
  bool needed = false; ///< no capture without it
};

std::vector<RoleSlot> angleRoleSlots();
std::vector<RoleSlot> fieldRoleSlots();

/// "123.4567°", "0.104230 0.000012 −0.000381 T"; the reading's note where it has no value.
QString roleReadingText(devices::InstrumentRole role, const devices::RoleReading& reading);

} // namespace straightedge::gui
