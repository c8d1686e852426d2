// The bench that a capture runs on, by its name on the command line: the simulated one, or a saved one with its
// instruments.
#pragma once

#include "core/base/error.h"
#include "core/session/session.h"
#include "devices/bench/opened_bench.h"

#include <memory>
#include <optional>
#include <string>

namespace straightedge::cli {

class BenchSource {
public:
  /// Opens nothing yet. Errors: Instrument (there is no such bench), Input (its file cannot be read).
  static Result<BenchSource> find(const std::string& name);

  bool isSimulated() const { return !m_saved; }
  devices::PairingRule pairing() const { return m_saved ? m_saved->pairing : devices::PairingRule{}; }

  /// Opens the instruments; nothing for the simulated bench. libusb starts a thread: signals are held back before.
  Result<void> open(const devices::BenchDialogueListener& listener);
  devices::OpenedBench* instruments() const { return m_opened.get(); } ///< null for the simulated bench

  /// The session begins to be captured on this bench: notes which instruments it has.
  Result<void> note(session::Session& session, session::SweepRole role) const;
  /// Errors (Usage): the session was begun on another bench, or with other instruments or settings.
  Result<void> checkSame(const session::Session& session, session::SweepRole role) const;

private:
  std::optional<devices::SavedBench> m_saved; ///< none: simulated
  std::unique_ptr<devices::OpenedBench> m_opened;
};

} // namespace straightedge::cli
