#include "devices/bench/device_listing.h"

#include "devices/instruments/profile_instrument.h"
#include "devices/transport/usb_serial_transport.h"
#include "devices/transport/usbtmc_transport.h"

#include <algorithm>
#include <unistd.h>

namespace straightedge::devices {

namespace {

/// What the listing needs of an instrument, whether it has a driver or a profile.
struct KnownEntry {
  std::string id;
  std::string name;
  std::vector<Connection> connections;
  std::vector<UsbIds> usb;
  bool usbIdsAreAdapters = false;
  std::vector<std::string> identityParts;
  std::vector<InstrumentRole> roles;
};

std::vector<KnownEntry> knownEntries(const ProfileSet& profiles) {
  std::vector<KnownEntry> entries;
  for (const KnownInstrument& known : knownInstruments()) {
    entries.push_back({std::string(known.id),
                       std::string(known.name),
                       known.connections,
                       known.usb,
                       known.usbIdsAreAdapters,
                       {known.identityParts.begin(), known.identityParts.end()},
                       known.roles});
  }
  for (const Profile& profile : profiles.profiles) {
    entries.push_back(
        {profile.id, profile.name, profile.connections, profile.usb, false, profile.identityParts, rolesOf(profile)});
  }
  return entries;
}

bool contains(const auto& list, const auto& item) { return std::ranges::find(list, item) != list.end(); }

void addRoles(ListedDevice& device, const KnownEntry& entry) {
  for (const InstrumentRole role : entry.roles) {
    if (!contains(device.roles, role)) {
      device.roles.push_back(role);
    }
  }
}

/// The ids are the instrument's own, or it says its model in its USB strings.
bool isSurely(const KnownEntry& entry, const ListedDevice& device) {
  if (device.ids && !entry.usbIdsAreAdapters && contains(entry.usb, *device.ids)) {
    return true;
  }
  return device.usb && UsbTmcTransport::interfaceOf(*device.usb) != nullptr &&
         std::ranges::any_of(entry.identityParts,
                             [&](const std::string& part) { return device.usb->product.contains(part); });
}

bool mayBe(const KnownEntry& entry, const ListedDevice& device) {
  if (device.usb && UsbTmcTransport::interfaceOf(*device.usb) != nullptr) {
    return contains(entry.connections, Connection::Usbtmc) && entry.usb.empty();
  }
  const bool isLine = device.port || (device.usb && UsbSerialTransport::canOpen(*device.usb));
  return isLine && contains(entry.connections, Connection::Serial) &&
         (entry.usb.empty() || (device.ids && contains(entry.usb, *device.ids)));
}

void match(ListedDevice& device, const std::vector<KnownEntry>& entries) {
  // Own ids say more than a word in a name, and drivers come before profiles.
  const auto sure = std::ranges::find_if(entries, [&](const KnownEntry& entry) { return isSurely(entry, device); });
  if (sure != entries.end()) {
    device.instrument = sure->id;
    device.instrumentName = sure->name;
    device.roles = sure->roles;
    return;
  }
  for (const KnownEntry& entry : entries) {
    if (mayBe(entry, device)) {
      device.candidates.push_back(entry.id);
      addRoles(device, entry);
    }
  }
}

bool samePlug(const UsbDevice& usb, const SerialPortInfo& port) {
  return port.vendorId == usb.vendorId && port.productId == usb.productId && port.usbSerial == usb.serial;
}

std::string nameOf(const UsbDevice& usb) {
  std::string name = usb.manufacturer;
  if (!usb.product.empty()) {
    name += (name.empty() ? "" : " ") + usb.product;
  }
  return name.empty() ? "USB device " + hexId(usb.vendorId) + ":" + hexId(usb.productId) : name;
}

bool userMayOpen(const std::string& path) { return ::access(path.c_str(), R_OK | W_OK) == 0; }

} // namespace

std::string hexId(std::uint16_t id) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const unsigned shift : {12U, 8U, 4U, 0U}) {
    text += digits[(unsigned{id} >> shift) & 0xFU];
  }
  return text;
}

std::string ListedDevice::label() const {
  const std::string shownName = instrumentName.empty() ? name : instrumentName;
  if (usb) {
    return shownName + " (" + usb->label() + ")";
  }
  return shownName;
}

std::vector<ListedDevice> matchDevices(const std::vector<UsbDevice>& usb, const std::vector<SerialPortInfo>& ports,
                                       const ProfileSet& profiles, bool (*mayOpen)(const std::string& path)) {
  const auto entries = knownEntries(profiles);
  std::vector<ListedDevice> all;
  std::vector<bool> merged(ports.size(), false);
  for (const UsbDevice& device : usb) {
    ListedDevice listed;
    listed.ids = UsbIds{device.vendorId, device.productId};
    listed.serial = device.serial;
    listed.name = nameOf(device);
    listed.problem = device.problem;
    listed.remedy = device.remedy;
    listed.usb = device;
    for (std::size_t i = 0; i < ports.size() && !listed.port; ++i) {
      if (!merged[i] && samePlug(device, ports[i])) {
        merged[i] = true;
        listed.port = ports[i];
      }
    }
    if (listed.port && mayOpen(listed.port->path)) {
      // The kernel's tty is a way in of its own, with rights of its own.
      listed.problem.clear();
      listed.remedy.clear();
    }
    all.push_back(std::move(listed));
  }
  for (std::size_t i = 0; i < ports.size(); ++i) {
    if (merged[i]) {
      continue;
    }
    const SerialPortInfo& port = ports[i];
    ListedDevice listed;
    if (port.vendorId && port.productId) {
      listed.ids = UsbIds{*port.vendorId, *port.productId};
    }
    listed.serial = port.usbSerial;
    listed.name = port.description.empty() ? port.path : port.description;
    listed.port = port;
    if (!mayOpen(port.path)) {
      listed.problem = "no permission to open " + port.path;
      listed.remedy = "run: sudo usermod -aG dialout $USER, then log in again";
    }
    all.push_back(std::move(listed));
  }
  for (ListedDevice& listed : all) {
    match(listed, entries);
  }
  return all;
}

Result<std::vector<ListedDevice>> listDevices(const ProfileSet& profiles) {
  auto usb = listUsbDevices();
  if (!usb) {
    return std::unexpected(std::move(usb.error().error));
  }
  auto ports = listSerialPorts();
  if (!ports) {
    return std::unexpected(std::move(ports.error()));
  }
  return matchDevices(*usb, *ports, profiles, userMayOpen);
}

} // namespace straightedge::devices
