#include "app/cli/capture_watch.h"

#include "app/cli/messages.h"

#include <algorithm>
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

CaptureWatch::CaptureWatch(double waitS) : m_onTerminal(::isatty(STDERR_FILENO) != 0), m_patience(waitS) {
  sigemptyset(&m_signals);
  sigaddset(&m_signals, SIGINT);
  sigaddset(&m_signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &m_signals, &m_before);
}

CaptureWatch::~CaptureWatch() { pthread_sigmask(SIG_SETMASK, &m_before, nullptr); }

template <typename Capture, typename Look>
auto CaptureWatch::followUntilDone(Capture& capture, const Look& look) {
  long patienceNs = firstLookNs;
  for (;;) {
    const auto progress = capture.progress();
    tell(progress.note);
    if (!waitsFor(progress) && !isActive(progress)) {
      wipe();
      if (progress.state == devices::CaptureState::Paused) {
        capture.stop();
      }
      capture.waitUntilDone();
      return progress;
    }
    if (look(progress)) {
      patienceNs = firstLookNs;
    }
    capture.takeNewSamples(); // nobody draws them here
    const timespec patience{0, patienceNs};
    if (sigtimedwait(&m_signals, nullptr, &patience) > 0) {
      capture.stop();
    }
    patienceNs = std::min(2 * patienceNs, laterLookNs);
  }
}

void CaptureWatch::tell(const std::string& note) {
  if (note != m_told && !note.empty()) {
    wipe();
    printNote(note);
  }
  m_told = note;
}

devices::CaptureProgress CaptureWatch::follow(devices::AngleCapture& capture) {
  return followUntilDone(capture, [this](const devices::CaptureProgress& progress) {
    std::string line = std::to_string(progress.pointsDone) + " of " + std::to_string(progress.pointsPlanned) +
                       " points, " + std::to_string(progress.samples) + " samples";
    if (progress.remainingS) {
      line += ", " + std::to_string(std::lround(std::ceil(*progress.remainingS))) + " s left";
    }
    show(line);
    return false;
  });
}

devices::FieldCaptureProgress CaptureWatch::follow(devices::FieldCapture& capture,
                                                   const std::vector<std::string>& titles, PersonPrompt prompt) {
  std::string unanswered;
  auto ended = followUntilDone(capture, [&](const devices::FieldCaptureProgress& progress) {
    if (!progress.waitingFor.empty() && unanswered.empty()) {
      wipe();
      const PersonPrompt::Answer answer = prompt.ask(progress.waitingFor);
      if (answer == PersonPrompt::Answer::Done) {
        capture.confirm();
      } else if (answer == PersonPrompt::Answer::NobodyThere) {
        unanswered = progress.waitingFor;
        capture.stop();
      }
      return answer != PersonPrompt::Answer::NotYet;
    }
    prompt.withdraw();
    std::string line = std::to_string(progress.pointsDone) + " of " + std::to_string(progress.pointsPlanned) +
                       " plateaus and sweeps, " + std::to_string(progress.samples) + " rows";
    if (progress.stage >= 0 && static_cast<std::size_t>(progress.stage) < titles.size()) {
      line = titles[static_cast<std::size_t>(progress.stage)] + ": " + line;
    }
    if (progress.remainingS) {
      line += ", about " + std::to_string(std::lround(std::ceil(*progress.remainingS / 60.0))) + " min left";
    }
    show(line);
    return false;
  });
  if (!unanswered.empty() && !ended.error) {
    ended.error = Error{
        ErrorKind::Usage,
        "nobody confirmed on standard input: " + unanswered + "; everything taken is stored",
        "go on with --resume: on a terminal, with a script that answers each line with Enter, or with --yes where "
        "all is in place already",
        {}};
  }
  return ended;
}

bool CaptureWatch::waitsFor(const devices::CaptureProgress& progress) {
  const auto now = std::chrono::steady_clock::now();
  if (!progress.waitsForInstrument || !progress.error) {
    if (m_waitsSince && progress.state == devices::CaptureState::Running) {
      m_waitsSince.reset();
    }
    return false;
  }
  if (!m_waitsSince) {
    m_waitsSince = now;
    wipe();
    printWarning(progress.error->message() + "; the capture waits for it and keeps what it has");
  }
  return now - *m_waitsSince < m_patience;
}

void CaptureWatch::show(const std::string& line) {
  if (!m_onTerminal) {
    return;
  }
  std::cerr << "\r" << line << "\x1b[K" << std::flush;
  m_shown = true;
}

void CaptureWatch::wipe() {
  if (m_shown) {
    std::cerr << "\r\x1b[K" << std::flush;
    m_shown = false;
  }
}

} // namespace straightedge::cli
