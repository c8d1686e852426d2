// A bench being put together: which of the devices that are plugged in fills which role, as which instrument, and how
// it is set. Without widgets.
#pragma once

#include "app/gui/bench/bench_roles.h"
#include "devices/bench/device_listing.h"

#include <string>
#include <vector>

namespace straightedge::gui {

/// One thread. What is in it can always be written as a SavedBench; whether it can be opened says check().
class BenchDraft {
public:
  BenchDraft(std::vector<RoleSlot> roles, devices::ProfileSet profiles);

  const std::vector<RoleSlot>& roles() const { return m_roles; }
  const devices::ProfileSet& profiles() const { return m_profiles; }
  const devices::SavedBench& bench() const { return m_bench; }
  void setBench(devices::SavedBench bench) { m_bench = std::move(bench); }
  void setName(std::string name) { m_bench.name = std::move(name); }
  void setPairing(const devices::PairingRule& rule) { m_bench.pairing = rule; }

  bool mayFill(devices::InstrumentRole role, const devices::ListedDevice& device) const;
  /// The role goes to this device; whoever had it loses it. A device that has another role already keeps being the same
  /// instrument where that can fill both. Errors (Usage): it cannot fill the role; nothing tells it from others.
  Result<void> assign(devices::InstrumentRole role, const devices::ListedDevice& device);
  void clear(devices::InstrumentRole role);
  const devices::BenchInstrument* filling(devices::InstrumentRole role) const { return m_bench.filling(role); }

  /// Ids of what the role's device may be taken for: more than one where it cannot be told from outside.
  std::vector<std::string> choices(devices::InstrumentRole role,
                                   const std::vector<devices::ListedDevice>& devices) const;
  /// Its settings begin anew: they are another instrument's. Roles that it cannot fill are given up.
  void chooseInstrument(devices::InstrumentRole role, const std::string& id);
  /// Settings, baud rate and latency of the instrument in the role.
  void setInstrument(devices::InstrumentRole role, devices::BenchInstrument changed);

  /// Errors (Usage, Input): a role that is needed is empty; a setting is wrong.
  Result<void> check() const;

  /// Whether the device is the one that the bench means: by serial number, or by port where it has none.
  static bool isSame(const devices::BenchInstrument& instrument, const devices::ListedDevice& device);

private:
  devices::BenchInstrument* find(devices::InstrumentRole role);
  bool canFill(const std::string& id, devices::InstrumentRole wanted) const;
  std::vector<std::string> idsOf(const devices::ListedDevice& device, devices::InstrumentRole role) const;

  std::vector<RoleSlot> m_roles;
  devices::ProfileSet m_profiles;
  devices::SavedBench m_bench;
};

} // namespace straightedge::gui
