#include "core/session/session.h"

#include "core/session/schema.h"
#include "core/session/session_impl.h"
#include "core/session/traceability_json.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace straightedge::session {

namespace {

std::unexpected<Error> cannotWrite(int systemError, const std::filesystem::path& file) {
  const bool full = systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG;
  return fail(ErrorKind::Storage,
              full ? "the disk is full"
                   : "the file cannot be written (" + std::system_category().message(systemError) + ")",
              full ? "free some space, or choose another folder" : "choose another name or folder", file.string());
}

/// Removes a half-made file unless it was renamed.
struct TemporaryFile {
  std::filesystem::path name;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(name, ignored);
  }
};

std::unexpected<Error> alreadyThere(const std::filesystem::path& file) {
  return fail(ErrorKind::Storage, "the file exists already", "open it, or choose another name", file.string());
}

Result<void> flushFile(const std::filesystem::path& name, const std::filesystem::path& shownAs) {
  const int descriptor = ::open(name.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) {
    return cannotWrite(errno, shownAs);
  }
  const bool flushed = ::fsync(descriptor) == 0;
  const int problem = errno;
  ::close(descriptor);
  if (!flushed) {
    return cannotWrite(problem, shownAs);
  }
  return {};
}

/// Error messages about the temporary name would puzzle; they speak of the file asked for.
std::unexpected<Error> about(const std::filesystem::path& file, Error error) {
  error.where = file.string();
  return std::unexpected(std::move(error));
}

std::unexpected<Error> isReadOnlyError(const std::filesystem::path& file) {
  return fail(ErrorKind::Storage, "the session was opened from a read-only place", "save it under another name first",
              file.string());
}

} // namespace

void flushFolderOf(const std::filesystem::path& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor); // some file systems cannot; the file itself is flushed all the same
    ::close(descriptor);
  }
}

std::filesystem::path temporaryNameFor(const std::filesystem::path& file) {
  static std::atomic<unsigned> counter = 0;
  std::filesystem::path name = file;
  name.replace_filename("." + file.filename().string() + ".new-" + std::to_string(::getpid()) + "-" +
                        std::to_string(++counter));
  return name;
}

Connection::~Connection() { std::ignore = finish(); }

Result<void> Connection::deleteCleared() {
  for (std::size_t sweep = 0; sweep < cleared.size(); ++sweep) {
    if (!cleared.at(sweep)) {
      continue;
    }
    const std::string number = std::to_string(sweep);
    const std::string sql = "DELETE FROM angle_sample WHERE sweep = " + number +
                            "; DELETE FROM field_sample WHERE sweep = " + number +
                            "; DELETE FROM sample_gap WHERE sweep = " + number;
    if (auto deleted = database->run(sql.c_str()); !deleted) {
      return deleted;
    }
  }
  return {};
}

Result<void> Connection::finish() {
  const std::scoped_lock lock(mutex);
  if (!database) {
    return {};
  }
  Result<void> outcome;
  if (leavesLog) {
    const auto leave = [this]() -> Result<void> {
      if (cleared[0] || cleared[1]) {
        Transaction transaction(*database);
        if (auto begun = transaction.begin(); !begun) {
          return begun;
        }
        if (auto deleted = deleteCleared(); !deleted) {
          return deleted;
        }
        if (auto committed = transaction.commit(); !committed) {
          return committed;
        }
        clearingDone();
      }
      if (auto folded = database->run("PRAGMA wal_checkpoint(TRUNCATE)"); !folded) {
        return folded;
      }
      return database->run("PRAGMA journal_mode = DELETE");
    };
    outcome = leave();
  }
  auto closed = database->close();
  database.reset();
  return outcome ? closed : outcome;
}

Session::Session(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Session::~Session() = default;

Result<std::unique_ptr<Session>> Session::create(const std::filesystem::path& file, SessionKind kind) {
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
    return alreadyThere(file);
  }
  const TemporaryFile temporary{temporaryNameFor(file)};
  {
    auto made = Database::open(temporary.name, Database::Access::Create);
    if (!made) {
      return about(file, std::move(made.error()));
    }
    if (auto filled = createSchema(**made, kind); !filled) {
      return about(file, std::move(filled.error()));
    }
    if (auto closed = (*made)->close(); !closed) {
      return about(file, std::move(closed.error()));
    }
  }
  // Never over a file that appeared meanwhile; where the file system cannot promise that, at least not knowingly.
  if (::renameat2(AT_FDCWD, temporary.name.c_str(), AT_FDCWD, file.c_str(), RENAME_NOREPLACE) != 0) {
    if (errno == EEXIST) {
      return alreadyThere(file);
    }
    if ((errno != EINVAL && errno != ENOSYS) || std::rename(temporary.name.c_str(), file.c_str()) != 0) {
      return cannotWrite(errno, file);
    }
  }
  flushFolderOf(file);
  return open(file);
}

Result<std::unique_ptr<Session>> Session::open(const std::filesystem::path& file) {
  auto impl = openConnection(file);
  if (!impl) {
    return std::unexpected(std::move(impl.error()));
  }
  return std::unique_ptr<Session>(new Session(*std::move(impl)));
}

Result<std::unique_ptr<Session>> Session::openReadOnly(const std::filesystem::path& file) {
  auto impl = openConnectionForReading(file);
  if (!impl) {
    return std::unexpected(std::move(impl.error()));
  }
  return std::unique_ptr<Session>(new Session(*std::move(impl)));
}

const std::filesystem::path& Session::file() const { return m_impl->file; }
SessionKind Session::kind() const { return m_impl->kind; }
bool Session::readOnly() const { return m_impl->readOnly; }
const std::string& Session::openingNote() const { return m_impl->note; }

Result<std::string> Session::document(std::string_view name) const {
  const std::scoped_lock lock(m_impl->connection->mutex);
  auto select = m_impl->connection->database->prepare("SELECT json FROM document WHERE name = ?1");
  if (!select) {
    return std::unexpected(std::move(select.error()));
  }
  select->bind(1, name);
  const auto row = select->step();
  if (!row) {
    return std::unexpected(row.error());
  }
  return *row ? select->text(0) : std::string();
}

Result<void> Session::setDocument(std::string_view name, std::string_view json) {
  if (m_impl->readOnly) {
    return isReadOnlyError(m_impl->file);
  }
  Connection& connection = *m_impl->connection;
  const std::scoped_lock lock(connection.mutex);
  Transaction transaction(*connection.database);
  if (auto begun = transaction.begin(); !begun) {
    return begun;
  }
  if (auto deleted = connection.deleteCleared(); !deleted) {
    return deleted;
  }
  auto insert = connection.database->prepare("INSERT INTO document(name, json) VALUES(?1, ?2) "
                                             "ON CONFLICT(name) DO UPDATE SET json = excluded.json");
  if (!insert) {
    return std::unexpected(std::move(insert.error()));
  }
  insert->bind(1, name);
  insert->bind(2, json);
  if (auto inserted = insert->execute(); !inserted) {
    return inserted;
  }
  if (auto committed = transaction.commit(); !committed) {
    return committed;
  }
  connection.clearingDone();
  return {};
}

Result<Traceability> Session::traceability() const {
  auto json = document("traceability");
  if (!json) {
    return std::unexpected(std::move(json.error()));
  }
  if (json->empty()) {
    return Traceability{};
  }
  return traceabilityFromJson(*json, m_impl->file.string());
}

Result<void> Session::setTraceability(const Traceability& traceability) {
  return setDocument("traceability", traceabilityToJson(traceability));
}

Result<void> Session::close() {
  if (m_impl->connection.use_count() > 1) {
    return fail(ErrorKind::Storage, "a capture still writes to this session", "stop the capture first",
                m_impl->file.string());
  }
  return m_impl->connection->finish();
}

Result<void> Session::copyTo(const std::filesystem::path& file) const {
  std::error_code ignored;
  if (std::filesystem::equivalent(m_impl->file, file, ignored)) {
    return fail(ErrorKind::Storage, "this is the session's own file", "choose another name", file.string());
  }
  const TemporaryFile temporary{temporaryNameFor(file)};
  std::array<bool, 2> cleared = {};
  {
    Connection& connection = *m_impl->connection;
    const std::scoped_lock lock(connection.mutex);
    cleared = connection.cleared;
    auto copy = connection.database->prepare("VACUUM INTO ?1");
    if (!copy) {
      return about(file, std::move(copy.error()));
    }
    copy->bind(1, std::string_view(temporary.name.native()));
    if (auto copied = copy->execute(); !copied) {
      return about(file, std::move(copied.error()));
    }
  }
  if (cleared[0] || cleared[1]) {
    // The copy is what the session shows: samples of a sweep that was started over are not in it.
    auto opened = Database::open(temporary.name, Database::Access::ReadWrite);
    if (!opened) {
      return about(file, std::move(opened.error()));
    }
    Connection copied(*std::move(opened), false);
    copied.cleared = cleared;
    if (auto deleted = copied.deleteCleared(); !deleted) {
      return about(file, std::move(deleted.error()));
    }
    if (auto closed = copied.finish(); !closed) {
      return about(file, std::move(closed.error()));
    }
  }
  if (auto flushed = flushFile(temporary.name, file); !flushed) {
    return flushed;
  }
  if (std::rename(temporary.name.c_str(), file.c_str()) != 0) {
    return cannotWrite(errno, file);
  }
  flushFolderOf(file);
  return {};
}

} // namespace straightedge::session
