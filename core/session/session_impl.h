// Inside of Session, shared by the files that implement it and by its sinks.
#pragma once

#include "core/session/database.h"
#include "core/session/session.h"

#include <array>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace straightedge::session {

/// The one connection of an open session. `mutex` guards everything in it; it is held for the milliseconds of a
/// transaction, never across a wait for samples.
struct Connection {
  Connection(std::unique_ptr<Database> opened, bool writable) : database(std::move(opened)), leavesLog(writable) {}
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Deletes the samples of cleared sweeps; inside a transaction. clearingDone() after its commit.
  Result<void> deleteCleared();
  void clearingDone() { cleared = {}; }
  /// Folds the write-ahead log into the file, leaves WAL and closes. A second call does nothing.
  Result<void> finish();

  std::mutex mutex;
  std::unique_ptr<Database> database;
  std::array<bool, 2> cleared = {}; ///< per SweepRole: samples to delete with the next transaction
  bool leavesLog;                   ///< opened for writing, hence in WAL
};

struct Session::Impl {
  std::filesystem::path file;
  SessionKind kind = SessionKind::Angle;
  bool readOnly = false;
  std::string note;
  std::shared_ptr<Connection> connection;
};

inline std::size_t indexOf(SweepRole role) { return role == SweepRole::Calibration ? 0 : 1; }
inline std::int64_t sweepNumber(SweepRole role) { return role == SweepRole::Calibration ? 0 : 1; }

/// Opens the connection for Session::open: checks, migrates, enters WAL. Leaves a file that it refuses as it was.
Result<std::unique_ptr<Session::Impl>> openConnection(const std::filesystem::path& file);

/// Likewise for Session::openReadOnly, and for what cannot be written.
Result<std::unique_ptr<Session::Impl>> openConnectionForReading(const std::filesystem::path& file);

/// Makes an entry of a folder durable, as far as the system can.
void flushFolderOf(const std::filesystem::path& file);
/// A name beside `file` that nobody else uses.
std::filesystem::path temporaryNameFor(const std::filesystem::path& file);

} // namespace straightedge::session
