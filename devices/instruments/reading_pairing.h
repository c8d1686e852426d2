// Readings of two instruments with time stamps of their own, paired: the sensor's angle at the time of the reference's.
#pragma once

#include "devices/instruments/angle_instruments.h"
#include "devices/instruments/pairing_rule.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace straightedge::devices {

/// A reference reading is paired with the two sensor readings around it, on the straight line between them the shorter
/// way round the turn, where both are at most `maxAgeS` away from it; a sensor reading of exactly its time serves
/// alone. Otherwise it is rejected and counted: nothing is extrapolated, nothing held over. Exact for a shaft of
/// constant speed that turns less than half a turn between two sensor readings. Times must already be corrected for
/// latency. Both series come in order of time; a reading that goes back in time is rejected. Of either series at most
/// `mostWaiting` readings are kept: where the other one has fallen silent the oldest are given up. One thread.
class ReadingPairing {
public:
  explicit ReadingPairing(const PairingRule& rule) : m_rule(rule) {}

  void addReference(const TimedReading& reading);
  void addSensor(const TimedReading& reading);

  /// Pairs that are complete, in order of time; those still waiting for a later sensor reading stay.
  std::vector<StreamedAngle> takePairs();

  static constexpr std::size_t mostWaiting = 65536; ///< 6.5 s at 10,000 a second

  std::int64_t rejected() const { return m_rejected; } ///< reference readings without a partner
  std::size_t waiting() const { return m_references.size(); }

private:
  PairingRule m_rule;
  std::deque<TimedReading> m_references;
  std::deque<TimedReading> m_sensors; ///< from the last one before the first waiting reference on
  std::int64_t m_rejected = 0;
};

} // namespace straightedge::devices
