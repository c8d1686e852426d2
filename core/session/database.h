// SQLite behind RAII: the one place in core that includes sqlite3.h.
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace straightedge::session {

/// A prepared statement. Parameters count from 1, columns from 0. Must not outlive its Database.
class Statement {
public:
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, double value);
  void bind(int parameter, std::string_view value);
  void bindNull(int parameter);

  Result<bool> step();    ///< true: a row is there
  Result<void> execute(); ///< steps to the end and resets
  void reset();

  std::int64_t integer(int column) const;
  double real(int column) const;
  std::optional<double> optionalReal(int column) const;
  std::string text(int column) const;

private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Statement(class Database& database, sqlite3_stmt* statement) : m_database(&database), m_statement(statement) {}

  class Database* m_database;
  std::unique_ptr<sqlite3_stmt, Finalize> m_statement;
};

/// One connection. Not thread-safe by contract: the owner serialises.
class Database {
public:
  enum class Access : std::uint8_t {
    ReadWrite, ///< an existing file; SQLite falls back to reading where the file cannot be written
    ReadOnly,
    Immutable, ///< for read-only media: no locks, no journal; ignores a write-ahead log beside the file
    Create,
  };
  /// Errors as in lastError().
  static Result<std::unique_ptr<Database>> open(const std::filesystem::path& file, Access access);
  ~Database() = default;
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  Result<void> run(const char* sql); ///< one or several statements, rows ignored
  Result<Statement> prepare(std::string_view sql);
  Result<std::int64_t> integer(std::string_view sql); ///< first column of the first row; 0 where there is none
  Result<std::string> text(std::string_view sql);     ///< likewise; empty where there is none

  bool isReadOnly() const;
  bool inTransaction() const;
  void keepLogOnClose(); ///< do not fold the write-ahead log into the file on closing: leaves a refused file untouched
  Result<void> close();

  /// What SQLite's last result code means for a person. Kind Input: not a database; Storage: everything else.
  Error lastError() const;
  int lastCode() const; ///< primary SQLite code, for decisions inside this room

private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  friend class Statement;
  explicit Database(std::filesystem::path file) : m_file(std::move(file)) {}
  /// SQLite forgets why a write failed in the middle of a commit; a quota or a file-size limit is to be told as such.
  void rememberSystemError(int error) { m_systemError = error; }

  std::filesystem::path m_file;
  std::unique_ptr<sqlite3, Close> m_handle;
  int m_systemError = 0; ///< errno of the last statement that failed
};

/// BEGIN IMMEDIATE … COMMIT; rolls back unless committed.
class Transaction {
public:
  explicit Transaction(Database& database) : m_database(database) {}
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  Result<void> begin();
  Result<void> commit();

private:
  Database& m_database;
  bool m_open = false;
};

} // namespace straightedge::session
