// One instrument of an opened bench: found by its serial number, opened, and opened again after it was unplugged.
#pragma once

#include "devices/bench/device_listing.h"
#include "devices/bench/saved_bench.h"
#include "devices/instruments/field_instruments.h"

#include <functional>
#include <memory>
#include <optional>

namespace straightedge::devices {

using DeviceLister = std::function<Result<std::vector<ListedDevice>>()>;

/// The roles are asked through the seat, which stays when the instrument leaves and comes back: pointers to the seat's
/// roles stay good. Thread: one at a time, the capture thread while a capture runs.
class BenchSeat {
public:
  /// Nothing is opened yet. Errors (Input): no instrument of this id; it cannot fill a role.
  static Result<std::unique_ptr<BenchSeat>> make(BenchInstrument wanted, const ProfileSet& profiles, BenchClock& clock);
  ~BenchSeat();
  BenchSeat(const BenchSeat&) = delete;
  BenchSeat& operator=(const BenchSeat&) = delete;

  /// Finds, opens and sets up. Errors (Instrument): not plugged in, two with this serial number, cannot be opened, does
  /// not answer, another instrument than before.
  Result<void> open(const DeviceLister& list);
  bool isThere() const { return m_instrument != nullptr && !m_gone; }
  bool isPluggedIn(const DeviceLister& list) const; ///< whether open() has something to find

  const std::string& name() const { return m_name; } ///< "US Digital QSB encoder reader, serial FT-1"
  const BenchInstrument& wanted() const { return m_wanted; }

  /// Null where the instrument is not there for that role.
  AngleSensor* angleSensor();
  AngleReference* angleReference();
  FieldProbe* fieldProbe();
  FieldReference* fieldReference();
  ResistanceMeter* resistanceMeter();
  Thermometer* thermometer();

  /// What streams by itself, of the instrument that is there now; null where it does not, or is gone. For BenchStream,
  /// which tells faults by the three members below: they remember the transport's fault and name the instrument.
  ReadingStream* angleReadings(InstrumentRole role);
  AngleStream* angleStream(); ///< where it fills both roles
  std::unexpected<Error> streamFault(Error error);
  std::unexpected<Error> silent(double seconds); ///< a time-out
  std::unexpected<Error> absent();

  /// Of the last reading, as BenchConnection::lastFault().
  std::optional<TransportFault> lastFault() const { return m_lastFault; }
  void forgetFault() { m_lastFault.reset(); }

private:
  struct Roles;
  BenchSeat(BenchInstrument wanted, BenchClock& clock);
  Result<ListedDevice> find(const DeviceLister& list) const;
  TransportResult<std::unique_ptr<Transport>> openTransport(const ListedDevice& device) const;
  SerialSettings serialSettings() const;
  bool fills(InstrumentRole role) const;
  template <typename T>
  Result<T> told(Result<T> outcome);
  template <typename Role, typename Reading>
  Result<Reading> ask(Role* role, Result<Reading> (Role::*read)());
  Error named(Error error) const;
  std::unexpected<Error> notThere() const;

  BenchInstrument m_wanted;
  BenchClock& m_clock;
  const KnownInstrument* m_known = nullptr; ///< null: it has a profile
  std::optional<Profile> m_profile;
  std::string m_name;
  std::unique_ptr<Transport> m_transport; // before the instrument, which uses it
  std::unique_ptr<Instrument> m_instrument;
  InstrumentIdentity m_identity;
  bool m_knowsSign = false;
  bool m_gone = false;
  std::optional<TransportFault> m_lastFault;
  std::unique_ptr<Roles> m_roles;
};

} // namespace straightedge::devices
