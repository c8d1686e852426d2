// Times on the bench's clock for readings that carry the ticks of their instrument's own clock.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace straightedge::devices {

/// Readings are spaced by their ticks; where they lie on the bench's clock is told by the arrivals with the least
/// delay, for none arrives before it was taken. A later arrival says only that the line or the program was slow, unless
/// it is later than any delay: then the instrument has paused, and time is counted anew from there. Times never go
/// back. One thread.
class StampedTimes {
public:
  explicit StampedTimes(double tickS) : m_tickS(tickS) {}

  void restart() { *this = StampedTimes(m_tickS); }

  /// Of readings with these ticks, the last of which arrived at `arrivalS`; ticks go round at 2^32.
  std::vector<double> place(std::span<const std::uint32_t> ticks, double arrivalS);

private:
  double m_tickS;
  bool m_begun = false;
  std::uint32_t m_lastTick = 0;
  std::int64_t m_ticks = 0; ///< since the first, beyond 32 bits
  double m_originS = 0.0;   ///< bench time of the first tick
  double m_lastArrivalS = 0.0;
  double m_lastS = 0.0; ///< handed out last
};

} // namespace straightedge::devices
