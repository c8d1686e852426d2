// What the window says about a device that is plugged in, and about the instruments that may be behind it.
#pragma once

#include "app/gui/bench/bench_roles.h"
#include "devices/bench/device_listing.h"

#include <optional>
#include <string>

namespace straightedge::gui {

QString deviceTitle(const devices::ListedDevice& device); ///< "US Digital QSB encoder reader", or its own name
QString deviceWhere(const devices::ListedDevice& device); ///< "1bfa:0498, serial 0123, /dev/ttyACM0"
/// "Can be: Reference encoder, Temperature" of the roles in `slots`; that it is of no use here otherwise.
QString deviceUse(const devices::ListedDevice& device, const std::vector<RoleSlot>& roles);

/// Tells one device that is plugged in from another, while it is.
QString deviceKey(const devices::ListedDevice& device);

QString instrumentTitle(const std::string& id, const devices::ProfileSet& profiles);
/// "Not yet tried on hardware. Not confirmed: …"; empty where there is nothing to warn of.
QString instrumentCaution(const std::string& id, const devices::ProfileSet& profiles);

/// The command in a remedy such as "run: installer/run --udev, then plug the device in again".
std::optional<QString> commandIn(const QString& remedy);

/// A sentence of the message and its remedy, without the place.
QString plainMessage(const Error& error);

} // namespace straightedge::gui
