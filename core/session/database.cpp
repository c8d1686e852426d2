#include "core/session/database.h"

#include <sqlite3.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace straightedge::session {

namespace {

/// How long to wait for another program that is about to close the file.
constexpr int busyTimeoutMs = 300;

std::string uriOf(const std::filesystem::path& file, const char* query) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.~/";
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char character : std::filesystem::absolute(file).string()) {
    if (plain.find(character) != std::string_view::npos) {
      uri += character;
    } else {
      const auto byte = static_cast<unsigned char>(character);
      uri += '%';
      uri += hex[byte >> 4U];
      uri += hex[byte & 15U];
    }
  }
  return uri + query;
}

Error errorOf(int extendedCode, int systemError, const char* detail, const std::filesystem::path& file) {
  const std::string where = file.string();
  const bool full = systemError == ENOSPC || systemError == EFBIG || systemError == EDQUOT;
  const auto is = [extendedCode](int primary) { return (extendedCode & 0xff) == primary; };
  if (is(SQLITE_FULL) || (is(SQLITE_IOERR) && full)) {
    return {ErrorKind::Storage, "the disk is full",
            "free some space and go on; everything committed so far is in the file", where};
  }
  if (is(SQLITE_BUSY) || is(SQLITE_LOCKED)) {
    return {ErrorKind::Storage, "another program has this session open", "close it there and try again", where};
  }
  if (is(SQLITE_READONLY)) {
    return {ErrorKind::Storage, "the file or its folder is read-only",
            "save the session under another name, or make the folder writable", where};
  }
  if (is(SQLITE_CORRUPT)) {
    return {ErrorKind::Storage, std::string("the session file is damaged (") + detail + ")",
            "use a copy from your backup, or rescue what is readable with: sqlite3 FILE .recover", where};
  }
  if (is(SQLITE_NOTADB)) {
    return {ErrorKind::Input, "this is not a Straightedge session, or its beginning is damaged",
            "choose a .sedge file, or use a copy from your backup", where};
  }
  const std::string system = systemError != 0 ? std::system_category().message(systemError) : std::string(detail);
  if (is(SQLITE_CANTOPEN) || is(SQLITE_PERM) || is(SQLITE_AUTH)) {
    return {ErrorKind::Storage, "the session file cannot be opened (" + system + ")",
            "see to the permissions of the file and its folder", where};
  }
  if (is(SQLITE_IOERR)) {
    return {ErrorKind::Storage, "reading or writing the session file failed (" + system + ")",
            "see whether the disk is still connected; everything committed so far is in the file", where};
  }
  return {ErrorKind::Storage, std::string("the session file refused an operation (") + detail + ")",
          "use a copy from your backup, and report this as a fault of the program", where};
}

} // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
void Database::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

// A bind fails only for a parameter that the statement has not (a bug) or for want of memory; the step then fails too.
void Statement::bind(int parameter, std::int64_t value) { sqlite3_bind_int64(m_statement.get(), parameter, value); }
void Statement::bind(int parameter, double value) { sqlite3_bind_double(m_statement.get(), parameter, value); }
void Statement::bind(int parameter, std::string_view value) {
  sqlite3_bind_text64(m_statement.get(), parameter, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}
void Statement::bindNull(int parameter) { sqlite3_bind_null(m_statement.get(), parameter); }

Result<bool> Statement::step() {
  errno = 0;
  const int code = sqlite3_step(m_statement.get());
  if (code == SQLITE_ROW || code == SQLITE_DONE) {
    return code == SQLITE_ROW;
  }
  m_database->rememberSystemError(errno);
  return std::unexpected(m_database->lastError());
}

Result<void> Statement::execute() {
  for (;;) {
    auto row = step();
    if (!row) {
      reset();
      return std::unexpected(std::move(row.error()));
    }
    if (!*row) {
      reset();
      return {};
    }
  }
}

void Statement::reset() { sqlite3_reset(m_statement.get()); }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(m_statement.get(), column); }
double Statement::real(int column) const { return sqlite3_column_double(m_statement.get(), column); }

std::optional<double> Statement::optionalReal(int column) const {
  if (sqlite3_column_type(m_statement.get(), column) == SQLITE_NULL) {
    return std::nullopt;
  }
  return real(column);
}

std::string Statement::text(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(m_statement.get(), column));
  const int size = sqlite3_column_bytes(m_statement.get(), column);
  return bytes == nullptr ? std::string() : std::string(bytes, static_cast<std::size_t>(size));
}

Result<std::unique_ptr<Database>> Database::open(const std::filesystem::path& file, Access access) {
  int flags = SQLITE_OPEN_URI | SQLITE_OPEN_FULLMUTEX | SQLITE_OPEN_EXRESCODE;
  switch (access) {
  case Access::ReadWrite:
    flags |= SQLITE_OPEN_READWRITE;
    break;
  case Access::ReadOnly:
  case Access::Immutable:
    flags |= SQLITE_OPEN_READONLY;
    break;
  case Access::Create:
    flags |= SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    break;
  }
  std::unique_ptr<Database> database(new Database(file));
  sqlite3* handle = nullptr;
  const std::string uri = uriOf(file, access == Access::Immutable ? "?immutable=1" : "");
  const int code = sqlite3_open_v2(uri.c_str(), &handle, flags, nullptr);
  database->m_handle.reset(handle);
  if (code != SQLITE_OK) {
    return std::unexpected(handle != nullptr ? database->lastError() : errorOf(code, 0, sqlite3_errstr(code), file));
  }
  sqlite3_busy_timeout(handle, busyTimeoutMs);
  return database;
}

Result<void> Database::run(const char* sql) {
  errno = 0;
  if (sqlite3_exec(m_handle.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
    rememberSystemError(errno);
    return std::unexpected(lastError());
  }
  return {};
}

Result<Statement> Database::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(m_handle.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr) != SQLITE_OK) {
    return std::unexpected(lastError());
  }
  return Statement(*this, statement);
}

Result<std::int64_t> Database::integer(std::string_view sql) {
  auto statement = prepare(sql);
  if (!statement) {
    return std::unexpected(std::move(statement.error()));
  }
  auto row = statement->step();
  if (!row) {
    return std::unexpected(std::move(row.error()));
  }
  return *row ? statement->integer(0) : 0;
}

Result<std::string> Database::text(std::string_view sql) {
  auto statement = prepare(sql);
  if (!statement) {
    return std::unexpected(std::move(statement.error()));
  }
  auto row = statement->step();
  if (!row) {
    return std::unexpected(std::move(row.error()));
  }
  return *row ? statement->text(0) : std::string();
}

bool Database::isReadOnly() const { return sqlite3_db_readonly(m_handle.get(), "main") == 1; }
bool Database::inTransaction() const { return sqlite3_get_autocommit(m_handle.get()) == 0; }

void Database::keepLogOnClose() { sqlite3_db_config(m_handle.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr); }

Result<void> Database::close() {
  if (m_handle && sqlite3_close(m_handle.get()) != SQLITE_OK) {
    return std::unexpected(lastError());
  }
  std::ignore = m_handle.release(); // closed above
  return {};
}

Error Database::lastError() const {
  const int fromSqlite = sqlite3_system_errno(m_handle.get());
  return errorOf(sqlite3_extended_errcode(m_handle.get()), fromSqlite != 0 ? fromSqlite : m_systemError,
                 sqlite3_errmsg(m_handle.get()), m_file);
}

int Database::lastCode() const { return sqlite3_errcode(m_handle.get()) & 0xff; }

Transaction::~Transaction() {
  if (m_open && m_database.inTransaction()) {
    std::ignore = m_database.run("ROLLBACK"); // the error that led here is the one to tell
  }
}

Result<void> Transaction::begin() {
  auto begun = m_database.run("BEGIN IMMEDIATE");
  m_open = begun.has_value();
  return begun;
}

Result<void> Transaction::commit() {
  auto committed = m_database.run("COMMIT");
  if (committed) {
    m_open = false;
  }
  return committed;
}

} // namespace straightedge::session
