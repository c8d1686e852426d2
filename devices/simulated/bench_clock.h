// Clocks of the simulated bench: the wall's, or one that jumps.
#pragma once

#include "devices/instruments/angle_instruments.h"

#include <chrono>
#include <memory>

namespace straightedge::devices {

/// Seconds since it was made, on the machine's steady clock.
class RealTimeClock : public BenchClock {
public:
  double nowS() const override;
  void sleepS(double seconds) override;

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// Stands still except when somebody sleeps: a sweep of minutes takes milliseconds, and the same seed gives the same
/// run.
class VirtualClock : public BenchClock {
public:
  double nowS() const override { return m_nowS; }
  void sleepS(double seconds) override { m_nowS += seconds > 0.0 ? seconds : 0.0; }

private:
  double m_nowS = 0.0;
};

std::unique_ptr<BenchClock> makeBenchClock(bool realTime);

} // namespace straightedge::devices
