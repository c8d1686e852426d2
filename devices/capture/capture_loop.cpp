#include "devices/capture/capture_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace straightedge::devices {

namespace {

/// Samples older than this are committed; the promise is 0.5 s.
constexpr auto commitAfter = std::chrono::milliseconds(250);
/// Between two looks for an instrument that was unplugged.
constexpr auto lookForInstrument = std::chrono::milliseconds(250);

} // namespace

CaptureLoop::Interruption CaptureLoop::instrumentFault(Error error, const char* who) {
  if (error.where.empty()) {
    error.where = who;
  }
  return {.fault = std::move(error)};
}

CaptureLoop::Step<void> CaptureLoop::fromSink(Result<void> outcome) {
  if (outcome) {
    return {};
  }
  return std::unexpected(Interruption{.fault = std::move(outcome.error()), .ofStorage = true});
}

void CaptureLoop::run(const std::stop_token& stop) {
  m_stop = stop;
  if (!m_startS) {
    m_startS = m_clock.nowS();
  }
  publishProgress();
  for (;;) {
    takeRequests();
    Step<void> outcome = checkInterruption();
    if (outcome && isDone()) {
      outcome = commit();
      if (outcome && finish()) {
        return;
      }
    } else if (outcome) {
      outcome = measureNext();
    }
    if (outcome || outcome.error().lookAgain) {
      continue;
    }
    Interruption why = std::move(outcome.error());
    if (tryAgain(why)) {
      continue;
    }
    if (!why.ofStorage) {
      forgetPositions();
      if (auto committed = commit(); !committed) {
        why = std::move(committed.error());
      }
    }
    if (why.ofStorage) {
      end(CaptureState::Failed, std::move(why.fault));
      return;
    }
    if (isUnplugged(why) ? !awaitInstrument(stop, *std::move(why.fault)) : !rest(stop, std::move(why.fault))) {
      end(CaptureState::Stopped);
      return;
    }
  }
}

bool CaptureLoop::requestsWait() const { return !m_control.redoRequests.empty(); }

bool CaptureLoop::tryAgain(const Interruption& why) {
  if (!why.fault || why.ofStorage || m_connection == nullptr || m_retriesLeft == 0 ||
      m_connection->lastFault() != TransportFault::TimedOut) {
    return false;
  }
  --m_retriesLeft;
  const std::scoped_lock lock(m_control.mutex);
  ++m_control.progress.retried;
  return true;
}

bool CaptureLoop::isUnplugged(const Interruption& why) const {
  return why.fault && !why.ofStorage && m_connection != nullptr && m_connection->lastFault() == TransportFault::Gone;
}

bool CaptureLoop::awaitInstrument(const std::stop_token& stop, Error fault) {
  publishProgress();
  std::unique_lock lock(m_control.mutex);
  for (;;) {
    if (stop.stop_requested()) {
      return false;
    }
    // Whoever asks to go on is told again: without the instrument nothing can.
    m_control.progress.state = CaptureState::Paused;
    m_control.progress.error = fault;
    m_control.progress.waitsForInstrument = true;
    m_control.changed.notify_all();
    m_control.changed.wait_for(lock, stop, lookForInstrument, [] { return false; });
    lock.unlock();
    auto back = m_connection->restore();
    lock.lock();
    if (back && *back) {
      break;
    }
    if (!back) {
      fault = std::move(back.error());
    }
  }
  m_control.progress.state = CaptureState::Running; // a pause that was asked for meanwhile comes next
  m_control.progress.error.reset();
  m_control.progress.waitsForInstrument = false;
  m_control.changed.notify_all();
  return true;
}

bool CaptureLoop::finish() {
  publishProgress();
  const std::scoped_lock lock(m_control.mutex);
  if (requestsWait()) {
    return false; // asked for while the last samples were committed
  }
  m_control.progress.state = CaptureState::Finished;
  m_control.changed.notify_all();
  return true;
}

bool CaptureLoop::rest(const std::stop_token& stop, std::optional<Error> fault) {
  if (stop.stop_requested()) {
    return false;
  }
  publishProgress();
  std::unique_lock lock(m_control.mutex);
  if (fault) {
    m_control.pauseRequested = true; // until somebody asks to go on
  }
  m_control.progress.state = CaptureState::Paused;
  m_control.progress.error = std::move(fault);
  m_control.changed.notify_all();
  if (!m_control.changed.wait(lock, stop, [this] { return !m_control.pauseRequested; })) {
    return false;
  }
  m_control.progress.state = CaptureState::Running;
  m_control.progress.error.reset();
  return true;
}

void CaptureLoop::end(CaptureState state, std::optional<Error> fault) {
  publishProgress();
  const std::scoped_lock lock(m_control.mutex);
  m_control.progress.state = state;
  m_control.progress.waitsForInstrument = false;
  m_control.progress.error = std::move(fault);
  m_control.changed.notify_all();
}

CaptureLoop::Step<void> CaptureLoop::wait(double seconds) {
  double left = seconds;
  do {
    if (auto free = checkInterruption(); !free) {
      return free;
    }
    if (abandonsPresent()) {
      return std::unexpected(Interruption{.fault = std::nullopt, .ofStorage = false, .lookAgain = true});
    }
    const double now = std::min(left, lookAroundS);
    m_clock.sleepS(now);
    left -= now;
    if (auto committed = commitIfDue(); !committed) {
      return committed;
    }
  } while (left > 0.0);
  return {};
}

CaptureLoop::Step<void> CaptureLoop::checkInterruption() const {
  if (m_stop.stop_requested() || m_control.pauseRequested) {
    return std::unexpected(Interruption{});
  }
  return {};
}

void CaptureLoop::samplesAppended() {
  m_retriesLeft = m_retries;
  if (!m_oldestUncommitted) {
    m_oldestUncommitted = std::chrono::steady_clock::now();
  }
}

CaptureLoop::Step<void> CaptureLoop::commitIfDue() {
  if (m_oldestUncommitted && std::chrono::steady_clock::now() - *m_oldestUncommitted >= commitAfter) {
    return commit();
  }
  return {};
}

CaptureLoop::Step<void> CaptureLoop::commit() {
  m_oldestUncommitted.reset();
  return fromSink(commitSink());
}

double CaptureLoop::sampleTimeS(double benchTimeS) const {
  // Clocks of benches are not better than this, and the digits beyond would fill files.
  constexpr double ticksPerS = 1e7;
  const double sinceStart = benchTimeS - m_startS.value_or(benchTimeS);
  return std::round((timeOffsetS() + sinceStart) * ticksPerS) / ticksPerS;
}

void CaptureLoop::publishProgress() {
  const double elapsed = m_clock.nowS() - m_startS.value_or(0.0);
  const std::scoped_lock lock(m_control.mutex);
  m_control.progress.elapsedS = elapsed;
  fillProgress(m_control.progress);
}

} // namespace straightedge::devices
