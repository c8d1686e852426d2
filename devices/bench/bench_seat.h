// One instrument of an opened bench: found by its serial number, opened, and opened again after it was unplugged.
#pragma once

#include "devices/bench/device_listing.h"
#include "devices/bench/saved_bench.h"
#include "devices/instruments/field_instruments.h"
#include "devices/transport/dialogue.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>

namespace straightedge::devices {

using DeviceLister = std::function<Result<std::vector<ListedDevice>>()>;

/// One exchange with an instrument of a bench. The references are good during the call.
struct BenchExchange {
  const std::string& instrument; ///< the seat's name()
  const BenchInstrument& wanted;
  int connection = 1; ///< one more each time that the instrument came back; the entry's time begins anew with it
  const Transport& transport;
  const DialogueEntry& entry;
};

/// Called in the thread that uses the bench, after each exchange: also while it is opened, and again after a replug.
using BenchDialogueListener = std::function<void(const BenchExchange&)>;

/// The roles are asked through the seat, which stays when the instrument leaves and comes back: pointers to the seat's
/// roles stay good. Threads: readings, open() and say() take turns, so that a live display may hand over to a capture
/// without waiting for the reading in hand; which role it can fill is asked by the thread that opened it, before.
class BenchSeat {
public:
  /// Nothing is opened yet. Errors (Input): no instrument of this id; it cannot fill a role.
  /// `listener` may be empty.
  static Result<std::unique_ptr<BenchSeat>> make(BenchInstrument wanted, const ProfileSet& profiles, BenchClock& clock,
                                                 BenchDialogueListener listener = {});
  ~BenchSeat();
  BenchSeat(const BenchSeat&) = delete;
  BenchSeat& operator=(const BenchSeat&) = delete;

  /// Finds, opens and sets up. Errors (Instrument): not plugged in, two with this serial number, cannot be opened, does
  /// not answer, another instrument than before.
  Result<void> open(const DeviceLister& list);
  bool isThere() const;
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
  Thermometer* chamberThermometer();

  /// Sends bytes as they are, for a console, and returns what came back: nothing where no answer came. A message
  /// without a question mark (USBTMC) is not answered. Errors (Instrument): not there, the transport's.
  Result<std::string> say(std::string_view bytes);

  /// What streams by itself, of the instrument that is there now; null where it does not, or is gone. For BenchStream,
  /// which tells faults by the three members below: they remember the transport's fault and name the instrument.
  ReadingStream* angleReadings(InstrumentRole role);
  AngleStream* angleStream(); ///< where it fills both roles
  std::unexpected<Error> streamFault(Error error);
  std::unexpected<Error> silent(double seconds); ///< a time-out
  std::unexpected<Error> absent();

  /// Of the last reading, as BenchConnection::lastFault().
  std::optional<TransportFault> lastFault() const;
  void forgetFault();

private:
  struct Roles;
  BenchSeat(BenchInstrument wanted, BenchClock& clock);
  Result<ListedDevice> find(const DeviceLister& list) const;
  TransportResult<std::unique_ptr<Transport>> openTransport(const ListedDevice& device) const;
  std::unique_ptr<Transport> listenedTo(std::unique_ptr<Transport> transport);
  SerialSettings serialSettings() const;
  bool fills(InstrumentRole role) const;
  template <typename T>
  Result<T> told(Result<T> outcome);
  template <typename Role, typename Reading>
  Result<Reading> ask(Role* (Instrument::*role)(), Result<Reading> (Role::*read)());
  Error named(Error error) const;
  std::unexpected<Error> notThere() const;
  TransportResult<std::string> answer(std::string_view question);

  mutable std::mutex m_turn; ///< held while the instrument is talked to; guards what follows from m_transport on
  BenchInstrument m_wanted;
  BenchClock& m_clock;
  const KnownInstrument* m_known = nullptr; ///< null: it has a profile
  std::optional<Profile> m_profile;
  std::string m_name;
  std::unique_ptr<Transport> m_transport; // before the instrument, which uses it
  std::unique_ptr<Instrument> m_instrument;
  BenchDialogueListener m_listener;
  int m_opened = 0; ///< times that it was opened and set up
  InstrumentIdentity m_identity;
  bool m_knowsSign = false;
  bool m_measuresElectronics = false;
  std::optional<double> m_incrementDeg;
  bool m_gone = false;
  std::optional<TransportFault> m_lastFault;
  std::unique_ptr<Roles> m_roles;
};

} // namespace straightedge::devices
