// Opening a session file: what is refused, what is read only, what is migrated.
#include "core/session/schema.h"
#include "core/session/session_impl.h"

#include <sqlite3.h>

#include <system_error>
#include <utility>

namespace straightedge::session {

namespace {

std::filesystem::path besides(const std::filesystem::path& file, const char* suffix) {
  std::filesystem::path name = file;
  name += suffix;
  return name;
}

bool hasContent(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored) && std::filesystem::file_size(file, ignored) > 0;
}

Result<void> checkIsFile(const std::filesystem::path& file) {
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  if (!std::filesystem::exists(status)) {
    return fail(ErrorKind::Input, "there is no such file", "see to the name and the folder", file.string());
  }
  if (!std::filesystem::is_regular_file(status)) {
    return fail(ErrorKind::Input, "this is not a file", "choose a .sedge file", file.string());
  }
  const auto size = std::filesystem::file_size(file, problem);
  if (!problem && size == 0) {
    return fail(ErrorKind::Input, "the file is empty, not a Straightedge session",
                "choose another file, or use a copy from your backup", file.string());
  }
  constexpr std::uintmax_t smallestPage = 512;
  if (!problem && size < smallestPage) {
    return fail(ErrorKind::Input, "this is not a Straightedge session, or all but its beginning is missing",
                "choose a .sedge file, or use a copy from your backup", file.string());
  }
  return {};
}

/// SQLite says so where the folder cannot take a journal, or a log its index.
bool meansReadOnlyFolder(const Database& database) {
  const int code = database.lastCode();
  return code == SQLITE_READONLY || code == SQLITE_CANTOPEN;
}

Result<std::unique_ptr<Session::Impl>>
finishOpening(const std::filesystem::path& file, std::unique_ptr<Database> database, bool writable, std::string note) {
  auto kind = kindOf(*database, file);
  if (!kind) {
    return std::unexpected(std::move(kind.error()));
  }
  auto impl = std::make_unique<Session::Impl>();
  impl->file = file;
  impl->kind = *kind;
  impl->readOnly = !writable;
  impl->note = std::move(note);
  impl->connection = std::make_shared<Connection>(std::move(database), writable);
  return impl;
}

} // namespace

Result<std::unique_ptr<Session::Impl>> openConnectionForReading(const std::filesystem::path& file) {
  if (auto checked = checkIsFile(file); !checked) {
    return std::unexpected(std::move(checked.error()));
  }
  const bool needsRecovery = hasContent(besides(file, "-wal")) || hasContent(besides(file, "-journal"));
  std::unique_ptr<Database> database;
  for (const auto access : {Database::Access::ReadOnly, Database::Access::Immutable}) {
    auto opened = Database::open(file, access);
    if (!opened) {
      return std::unexpected(std::move(opened.error()));
    }
    database = *std::move(opened);
    database->keepLogOnClose();
    auto checked = checkSession(*database, file);
    if (checked) {
      break;
    }
    if (!meansReadOnlyFolder(*database) || access == Database::Access::Immutable) {
      return std::unexpected(std::move(checked.error()));
    }
    if (needsRecovery) {
      return fail(
          ErrorKind::Storage, "the session was not closed, and the log beside it cannot be read in a read-only folder",
          "copy the file together with the one ending in -wal to a writable folder and open it there", file.string());
    }
  }
  const auto version = database->integer("PRAGMA user_version");
  if (version && *version < Session::oldestReadableVersion) {
    return fail(ErrorKind::Storage,
                "the session has the older file version " + std::to_string(*version) +
                    " and cannot be converted where it may not be written",
                "open it once in Straightedge, from a writable folder", file.string());
  }
  return finishOpening(file, std::move(database), false, {});
}

Result<std::unique_ptr<Session::Impl>> openConnection(const std::filesystem::path& file) {
  if (auto checked = checkIsFile(file); !checked) {
    return std::unexpected(std::move(checked.error()));
  }
  const bool hadLog = std::filesystem::exists(besides(file, "-wal"));
  auto opened = Database::open(file, Database::Access::ReadWrite);
  if (!opened) {
    return std::unexpected(std::move(opened.error()));
  }
  std::unique_ptr<Database> database = *std::move(opened);
  database->keepLogOnClose();
  if (database->isReadOnly()) {
    database.reset();
    return openConnectionForReading(file);
  }

  // Exclusive locking keeps other programs out while the file is open, and lets go when the program dies.
  std::string note;
  const auto prepare = [&]() -> Result<void> {
    if (auto locked = database->run("PRAGMA locking_mode = EXCLUSIVE"); !locked) {
      return locked;
    }
    if (auto checked = checkSession(*database, file); !checked) {
      return checked;
    }
    const auto before = database->text("PRAGMA journal_mode");
    if (before && *before == "wal" && !hadLog) {
      note = "This session was not closed, and the file ending in -wal that belongs to it is missing: the last samples "
             "before it was copied or moved may be missing too.";
    }
    if (auto migrated = migrate(*database); !migrated) {
      return migrated;
    }
    if (auto entered = database->run("PRAGMA journal_mode = WAL"); !entered) {
      return entered;
    }
    return database->run("PRAGMA synchronous = FULL; BEGIN EXCLUSIVE; COMMIT");
  };
  if (auto prepared = prepare(); !prepared) {
    const bool readable = meansReadOnlyFolder(*database);
    database.reset();
    if (readable) {
      return openConnectionForReading(file);
    }
    return std::unexpected(std::move(prepared.error()));
  }
  return finishOpening(file, std::move(database), true, std::move(note));
}

} // namespace straightedge::session
