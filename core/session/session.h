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

/// An open session file. One thread at a time; the sink opens a connection of its own for the capture thread.
/// The file is in WAL mode while open; close() checkpoints and leaves WAL, so that a finished file opens on read-only
/// media.
class Session {
public:
  static constexpr int schemaVersion = 1;

  /// Creates a new file; refuses to overwrite. Errors: Storage.
  static Result<std::unique_ptr<Session>> create(const std::filesystem::path& file, SessionKind kind);
  /// Opens an existing file, migrating an older schema. A file on read-only media opens read-only.
  /// Errors: Input (not there, not a session, later version), Storage (damaged, locked by another program).
  static Result<std::unique_ptr<Session>> open(const std::filesystem::path& file);

  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const std::filesystem::path& file() const;
  SessionKind kind() const;
  bool readOnly() const;

  Result<std::vector<AngleSample>> angleSamples(SweepRole role) const; ///< all committed, in order of sequence
  Result<std::int64_t> angleSampleCount(SweepRole role) const;
  Result<std::vector<SampleGap>> gaps(SweepRole role) const;
  Result<void> clearSamples(SweepRole role); ///< start a sweep over; kept until the next commit succeeds

  /// A sink for one capture; commits at most 0.5 s after the oldest uncommitted sample.
  Result<std::unique_ptr<SampleSink>> angleSink(SweepRole role);

  /// Named JSON documents beside the samples: "plan", "bench", "review", "models", "traceability", "result", … ;
  /// empty string where there is none yet. Written in one transaction each.
  Result<std::string> document(std::string_view name) const;
  Result<void> setDocument(std::string_view name, std::string_view json);

  Result<Traceability> traceability() const;
  Result<void> setTraceability(const Traceability& traceability);

  /// Checkpoints, leaves WAL and closes. The destructor does the same and swallows the error.
  Result<void> close();

  /// Copies the whole session to another file (Save as). Errors: Storage.
  Result<void> copyTo(const std::filesystem::path& file) const;

private:
  struct Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::session
