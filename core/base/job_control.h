// How a long computation reports progress and is cancelled. Passed by reference into verbs that may take over 50 ms.
#pragma once

#include <functional>
#include <stop_token>

namespace straightedge {

/// Default-constructed: never stops, reports to nobody.
struct JobControl {
  std::stop_token stop;
  std::function<void(double fraction)> progress; ///< called in the computing thread, fraction in [0, 1]

  bool stopRequested() const { return stop.stop_requested(); }
  void report(double fraction) const {
    if (progress) {
      progress(fraction);
    }
  }
};

} // namespace straightedge
