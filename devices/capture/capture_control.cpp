#include "devices/capture/capture_control.h"

namespace straightedge::devices {

bool CaptureControl::running() const {
  const std::scoped_lock lock(mutex);
  return progress.state == CaptureState::Running || progress.state == CaptureState::Paused;
}

void CaptureControl::begin() {
  const std::scoped_lock lock(mutex);
  progress.state = CaptureState::Running;
  progress.error.reset();
  progress.waitsForInstrument = false;
  pauseRequested = false;
}

void CaptureControl::pause() {
  const std::scoped_lock lock(mutex);
  pauseRequested = true;
  changed.notify_all();
}

void CaptureControl::resume() {
  const std::scoped_lock lock(mutex);
  pauseRequested = false;
  if (progress.state == CaptureState::Paused) { // at once: whoever waits now waits for what follows
    progress.state = CaptureState::Running;
    progress.error.reset();
  }
  changed.notify_all();
}

void CaptureControl::requestRedo(int index) {
  const std::scoped_lock lock(mutex);
  redoRequests.push_back(index);
  changed.notify_all();
}

void CaptureControl::waitUntilDone(std::jthread& thread) {
  {
    std::unique_lock lock(mutex);
    const auto pausedByFault = [this, &thread] {
      return progress.state == CaptureState::Paused && progress.error && !thread.get_stop_token().stop_requested();
    };
    changed.wait(lock, [&] {
      return (progress.state != CaptureState::Running && progress.state != CaptureState::Paused) || pausedByFault();
    });
    if (pausedByFault()) {
      return;
    }
  }
  if (thread.joinable()) {
    thread.join();
  }
}

} // namespace straightedge::devices
