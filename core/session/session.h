// One SQLite file per calibration (.sedge): raw samples as they arrive; plan, review, choices and results beside them.
#pragma once

#include "core/base/error.h"
#include "core/base/traceability.h"
#include "core/session/sample_sink.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace straightedge::session {

enum class SessionKind : std::uint8_t { Angle, Field };

/// Raw samples belong to a sweep: the calibration sweep, or a fresh one taken to verify it.
enum class SweepRole : std::uint8_t { Calibration, Verification };

/// An open session file. One thread at a time, beside which a sink may be used by the capture thread.
/// The file is in WAL mode while open, and no other program may have it open meanwhile; close() checkpoints and leaves
/// WAL, so that a finished file opens on read-only media. A commit is flushed to the disk (synchronous=FULL): it
/// survives the death of the program, and a power loss as far as the disk keeps its word about flushing.
class Session {
public:
  static constexpr int schemaVersion = 2;
  /// From this one on a file is read as it is where it cannot be migrated.
  static constexpr int oldestReadableVersion = 1;

  /// Creates a new file whole or not at all; refuses to overwrite. Errors: Storage.
  static Result<std::unique_ptr<Session>> create(const std::filesystem::path& file, SessionKind kind);
  /// Opens an existing file, migrating an older schema. A file on read-only media opens read-only.
  /// Errors: Input (not there, not a session, later version), Storage (damaged, locked by another program).
  static Result<std::unique_ptr<Session>> open(const std::filesystem::path& file);

  /// For looking at a file without changing it; another program may do the same at the same time. Errors as for open().
  static Result<std::unique_ptr<Session>> openReadOnly(const std::filesystem::path& file);

  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const std::filesystem::path& file() const;
  SessionKind kind() const;
  bool readOnly() const;
  /// A sentence for the user where something about the file was noticed on opening that does not keep it from being
  /// used; else empty.
  const std::string& openingNote() const;

  Result<std::vector<AngleSample>> angleSamples(SweepRole role) const; ///< all committed, in order of sequence
  Result<std::int64_t> angleSampleCount(SweepRole role) const;
  Result<std::vector<FieldSample>> fieldSamples(SweepRole role) const; ///< likewise, of a session of kind Field
  Result<std::int64_t> fieldSampleCount(SweepRole role) const;
  Result<std::vector<SampleGap>> gaps(SweepRole role) const;
  /// Starts a sweep over: its samples are not seen any more at once, and leave the file in one transaction with the
  /// next thing that is written (samples of the new sweep, or a document that speaks of it), or on closing.
  Result<void> clearSamples(SweepRole role);

  /// A sink for one capture; commits at most 0.5 s after the oldest uncommitted sample by itself, in a thread of its
  /// own. Destroy it before close(). Samples that could not be written are kept and tried again with the next commit.
  Result<std::unique_ptr<SampleSink>> angleSink(SweepRole role);
  Result<std::unique_ptr<FieldSampleSink>> fieldSink(SweepRole role); ///< likewise

  /// Named JSON documents beside the samples: "plan", "bench", "review", "models", "traceability", "result", … ;
  /// empty string where there is none yet. Written in one transaction each.
  Result<std::string> document(std::string_view name) const;
  Result<void> setDocument(std::string_view name, std::string_view json);

  Result<Traceability> traceability() const;
  Result<void> setTraceability(const Traceability& traceability);

  /// Checkpoints, leaves WAL and closes. The destructor does the same and swallows the error. Errors: Storage; a sink
  /// that still exists is one, and leaves the session open.
  Result<void> close();

  /// Copies the whole session to another file (Save as), whole or not at all, replacing what is there. Errors: Storage.
  Result<void> copyTo(const std::filesystem::path& file) const;

  struct Impl;

private:
  explicit Session(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::session
