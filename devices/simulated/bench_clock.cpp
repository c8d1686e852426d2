#include "devices/simulated/bench_clock.h"

#include <thread>

namespace straightedge::devices {

double RealTimeClock::nowS() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

void RealTimeClock::sleepS(double seconds) {
  if (seconds > 0.0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }
}

std::unique_ptr<BenchClock> makeBenchClock(bool realTime) {
  if (realTime) {
    return std::make_unique<RealTimeClock>();
  }
  return std::make_unique<VirtualClock>();
}

} // namespace straightedge::devices
