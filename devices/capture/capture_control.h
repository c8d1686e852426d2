// What the controlling thread and a capture's own thread share, whatever is captured.
#pragma once

#include "core/base/error.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace straightedge::devices {

enum class CaptureState : std::uint8_t { Idle, Running, Paused, Finished, Stopped, Failed };

/// A snapshot for progress displays; cheap to copy.
struct CaptureProgress {
  CaptureState state = CaptureState::Idle;
  int pointsDone = 0;
  int pointsPlanned = 0;
  std::int64_t samples = 0;
  std::int64_t samplesLost = 0; ///< dropped from the live display only; the sink has them all
  double elapsedS = 0.0;
  std::optional<double> remainingS; ///< known after the first points
  std::optional<Error> error;       ///< state Failed or Paused by a fault
  bool waitsForInstrument = false;  ///< Paused because one was unplugged: goes on by itself when it is back
  std::string note;                 ///< what a person should know or do meanwhile; mostly empty
  int retried = 0;                  ///< readings that were asked for again after a time-out
};

/// `mutex` guards `progress` and `redoRequests`; `changed` tells of both directions.
struct CaptureControl {
  mutable std::mutex mutex;
  std::condition_variable_any changed;
  CaptureProgress progress;
  std::vector<int> redoRequests;
  std::atomic<bool> pauseRequested = false;

  // For the controlling thread:
  bool running() const; ///< also while paused
  void begin();         ///< before the thread is started
  void pause();
  void resume();
  void requestRedo(int index);
  /// Blocks until the capture has ended or a fault paused it; joins `thread` in the first case.
  void waitUntilDone(std::jthread& thread);
};

} // namespace straightedge::devices
