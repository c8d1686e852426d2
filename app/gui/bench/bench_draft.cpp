#include "app/gui/bench/bench_draft.h"

#include "devices/bench/bench_check.h"
#include "devices/instruments/profile_instrument.h"

#include <algorithm>

namespace straightedge::gui {

namespace {

bool contains(const auto& list, const auto& item) { return std::ranges::find(list, item) != list.end(); }

} // namespace

BenchDraft::BenchDraft(std::vector<RoleSlot> roles, devices::ProfileSet profiles)
    : m_roles(std::move(roles)), m_profiles(std::move(profiles)) {}

bool BenchDraft::isSame(const devices::BenchInstrument& instrument, const devices::ListedDevice& device) {
  if (!instrument.serial.empty()) {
    return instrument.serial == device.serial;
  }
  return device.port && device.port->path == instrument.port;
}

bool BenchDraft::canFill(const std::string& id, devices::InstrumentRole wanted) const {
  // Which temperature it is, is the bench's to say.
  const devices::InstrumentRole role =
      wanted == devices::InstrumentRole::ChamberTemperature ? devices::InstrumentRole::Temperature : wanted;
  if (const devices::KnownInstrument* known = devices::knownInstrument(id)) {
    return contains(known->roles, role);
  }
  const devices::Profile* profile = devices::findProfile(m_profiles, id);
  return profile != nullptr && contains(devices::rolesOf(*profile), role);
}

std::vector<std::string> BenchDraft::idsOf(const devices::ListedDevice& device, devices::InstrumentRole role) const {
  std::vector<std::string> ids = device.candidates;
  if (!device.instrument.empty()) {
    ids = {device.instrument};
  }
  std::erase_if(ids, [&](const std::string& id) { return !canFill(id, role); });
  return ids;
}

bool BenchDraft::mayFill(devices::InstrumentRole role, const devices::ListedDevice& device) const {
  return !idsOf(device, role).empty();
}

Result<void> BenchDraft::assign(devices::InstrumentRole role, const devices::ListedDevice& device) {
  const std::vector<std::string> ids = idsOf(device, role);
  if (ids.empty()) {
    return fail(ErrorKind::Usage, device.label() + " cannot fill the role " + std::string(devices::roleWord(role)),
                "choose another device for it");
  }
  if (device.serial.empty() && !device.port) {
    return fail(ErrorKind::Usage, device.label() + " has no serial number, so that a bench could not find it again",
                "use a device with a serial number, or one with a serial port");
  }
  if (const devices::BenchInstrument* now = filling(role); now != nullptr && isSame(*now, device)) {
    return {};
  }
  clear(role);
  const auto taken = std::ranges::find_if(m_bench.instruments,
                                          [&](const devices::BenchInstrument& one) { return isSame(one, device); });
  if (taken == m_bench.instruments.end()) {
    devices::BenchInstrument one;
    one.instrument = ids.front();
    one.roles = {role};
    one.serial = device.serial;
    one.port = device.serial.empty() ? device.port->path : std::string();
    m_bench.instruments.push_back(std::move(one));
    return {};
  }
  if (!contains(ids, taken->instrument)) {
    const auto both = std::ranges::find_if(ids, [&](const std::string& id) {
      return std::ranges::all_of(taken->roles, [&](devices::InstrumentRole held) { return canFill(id, held); });
    });
    if (both == ids.end()) {
      return fail(ErrorKind::Usage,
                  device.label() + " is in use in another role and cannot fill " +
                      std::string(devices::roleWord(role)) + " as well",
                  "empty the other role first");
    }
    taken->instrument = *both;
    taken->settings.clear();
    taken->baud.reset();
  }
  taken->roles.push_back(role);
  return {};
}

void BenchDraft::clear(devices::InstrumentRole role) {
  for (devices::BenchInstrument& one : m_bench.instruments) {
    std::erase(one.roles, role);
  }
  std::erase_if(m_bench.instruments, [](const devices::BenchInstrument& one) { return one.roles.empty(); });
}

devices::BenchInstrument* BenchDraft::find(devices::InstrumentRole role) {
  const auto found = std::ranges::find_if(
      m_bench.instruments, [&](const devices::BenchInstrument& one) { return contains(one.roles, role); });
  return found == m_bench.instruments.end() ? nullptr : &*found;
}

std::vector<std::string> BenchDraft::choices(devices::InstrumentRole role,
                                             const std::vector<devices::ListedDevice>& devices) const {
  const devices::BenchInstrument* one = filling(role);
  if (one == nullptr) {
    return {};
  }
  std::vector<std::string> ids;
  const auto device =
      std::ranges::find_if(devices, [&](const devices::ListedDevice& each) { return isSame(*one, each); });
  if (device != devices.end()) {
    ids = idsOf(*device, role);
  }
  if (!contains(ids, one->instrument)) {
    ids.insert(ids.begin(), one->instrument);
  }
  return ids;
}

void BenchDraft::chooseInstrument(devices::InstrumentRole role, const std::string& id) {
  devices::BenchInstrument* one = find(role);
  if (one == nullptr || one->instrument == id || !canFill(id, role)) {
    return;
  }
  one->instrument = id;
  one->settings.clear();
  one->baud.reset();
  std::erase_if(one->roles, [&](devices::InstrumentRole held) { return !canFill(id, held); });
}

void BenchDraft::setInstrument(devices::InstrumentRole role, devices::BenchInstrument changed) {
  if (devices::BenchInstrument* one = find(role)) {
    changed.roles = one->roles;
    *one = std::move(changed);
  }
}

Result<void> BenchDraft::check() const {
  for (const RoleSlot& slot : m_roles) {
    if (slot.needed && filling(slot.role) == nullptr) {
      return fail(ErrorKind::Usage, "nothing fills the role '" + slot.title.toStdString() + "'",
                  "drag a device onto it, or choose one in its list");
    }
  }
  return devices::checkBench(m_bench, m_profiles);
}

} // namespace straightedge::gui
