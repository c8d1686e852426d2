// Dialogues with the instruments of a bench as files in a folder, for a bug report.
#pragma once

#include "core/base/error.h"
#include "devices/bench/bench_seat.h"
#include "devices/transport/recording_transport.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace straightedge::cli {

/// One file for each instrument, and a further one each time that it came back after it was unplugged: every file
/// begins with the set-up and can be replayed by itself. Files that are there already are kept. Thread: whichever uses
/// the bench; tell() when none does.
class DialogueFolder {
public:
  /// An empty path records nothing.
  explicit DialogueFolder(std::string path) : m_path(std::move(path)) {}
  Result<void> make() const; ///< the folder, where it is not there. Errors: Storage

  /// Empty where nothing is recorded. It refers to this object.
  devices::BenchDialogueListener listener();

  /// On standard error: where the files are, and what kept one from being complete.
  void tell() const;

private:
  using Key = std::pair<std::string, int>; ///< instrument, connection
  void hear(const devices::BenchExchange& heard);
  std::string freeName(const devices::BenchInstrument& instrument) const;

  std::string m_path;
  std::map<Key, Result<devices::DialogueFile>> m_files;
};

} // namespace straightedge::cli
