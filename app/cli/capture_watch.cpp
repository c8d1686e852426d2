#include "app/cli/capture_watch.h"

#include <cmath>
#include <ctime>
#include <iostream>
#include <string>
#include <unistd.h>

namespace straightedge::cli {

namespace {

/// Nobody presses keys faster, and a capture on the virtual clock is over in milliseconds.
constexpr long firstLookNs = 1'000'000;
constexpr long laterLookNs = 100'000'000;

bool isActive(const devices::CaptureProgress& progress) {
  return progress.state == devices::CaptureState::Running ||
         (progress.state == devices::CaptureState::Paused && !progress.error);
}

} // namespace

CaptureWatch::CaptureWatch() : m_onTerminal(::isatty(STDERR_FILENO) != 0) {
  sigemptyset(&m_signals);
  sigaddset(&m_signals, SIGINT);
  sigaddset(&m_signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &m_signals, &m_before);
}

CaptureWatch::~CaptureWatch() { pthread_sigmask(SIG_SETMASK, &m_before, nullptr); }

devices::CaptureProgress CaptureWatch::follow(devices::AngleCapture& capture) {
  long patienceNs = firstLookNs;
  for (;;) {
    const devices::CaptureProgress progress = capture.progress();
    if (!isActive(progress)) {
      wipe();
      if (progress.state == devices::CaptureState::Paused) {
        capture.stop();
      }
      capture.waitUntilDone();
      return progress;
    }
    show(progress);
    capture.takeNewSamples(); // nobody draws them here
    const timespec patience{0, patienceNs};
    if (sigtimedwait(&m_signals, nullptr, &patience) > 0) {
      capture.stop();
    }
    patienceNs = std::min(2 * patienceNs, laterLookNs);
  }
}

void CaptureWatch::show(const devices::CaptureProgress& progress) {
  if (!m_onTerminal) {
    return;
  }
  std::string line = "\r" + std::to_string(progress.pointsDone) + " of " + std::to_string(progress.pointsPlanned) +
                     " points, " + std::to_string(progress.samples) + " samples";
  if (progress.remainingS) {
    line += ", " + std::to_string(std::lround(std::ceil(*progress.remainingS))) + " s left";
  }
  std::cerr << line << "\x1b[K" << std::flush;
  m_shown = true;
}

void CaptureWatch::wipe() {
  if (m_shown) {
    std::cerr << "\r\x1b[K" << std::flush;
  }
}

} // namespace straightedge::cli
