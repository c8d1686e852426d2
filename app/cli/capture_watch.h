// Follows a capture from the main thread: progress on a terminal, and a clean end on SIGINT or SIGTERM.
#pragma once

#include "app/cli/person_prompt.h"
#include "devices/capture/angle_capture.h"
#include "devices/capture/field_capture.h"

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::cli {

/// Holds SIGINT and SIGTERM back while it lives, so that they end the sweep instead of the program. Make it before
/// threads are started: they inherit the mask.
class CaptureWatch {
public:
  /// `waitS`: how long an instrument that was unplugged is waited for.
  explicit CaptureWatch(double waitS = 600.0);
  ~CaptureWatch();
  CaptureWatch(const CaptureWatch&) = delete;
  CaptureWatch& operator=(const CaptureWatch&) = delete;

  /// Blocks until the sweep has ended; a fault of an instrument ends it too, except that one that was unplugged is
  /// waited for. The error, if any, is in the result.
  devices::CaptureProgress follow(devices::AngleCapture& capture);
  /// Likewise. `titles` are the stages'. What a person is to do is asked for through `prompt`; where nobody is there
  /// the capture is stopped, and that is the error (Usage).
  devices::FieldCaptureProgress follow(devices::FieldCapture& capture, const std::vector<std::string>& titles,
                                       PersonPrompt prompt);

private:
  /// `look` is called with each progress; true: something was done, look again soon.
  template <typename Capture, typename Look>
  auto followUntilDone(Capture& capture, const Look& look);
  bool waitsFor(const devices::CaptureProgress& progress);
  void show(const std::string& line); ///< on a terminal only
  void tell(const std::string& note); ///< once, whenever it changes
  void wipe();

  sigset_t m_signals{};
  sigset_t m_before{};
  bool m_onTerminal;
  bool m_shown = false;
  std::string m_told;
  std::chrono::duration<double> m_patience;
  std::optional<std::chrono::steady_clock::time_point> m_waitsSince;
};

} // namespace straightedge::cli
