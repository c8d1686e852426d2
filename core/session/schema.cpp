#include "core/session/schema.h"

#include <array>
#include <string>
#include <system_error>
#include <utility>

namespace straightedge::session {

namespace {

/// Of both kinds of session. Columns as in FieldSample.
constexpr const char* fieldTable = R"sql(
CREATE TABLE field_sample(
  sweep INTEGER NOT NULL, sequence INTEGER NOT NULL, stage INTEGER NOT NULL, point INTEGER NOT NULL,
  attempt INTEGER NOT NULL, time_s REAL NOT NULL, step INTEGER NOT NULL, axis INTEGER, orientation INTEGER,
  locked INTEGER NOT NULL, reference_t REAL, chamber_c REAL, pt100_ohm REAL, electronics_c REAL,
  raw_x_t REAL NOT NULL, raw_y_t REAL NOT NULL, raw_z_t REAL NOT NULL, PRIMARY KEY(sweep, sequence)) WITHOUT ROWID;
)sql";

constexpr const char* tablesOfVersion1 = R"sql(
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE document(name TEXT PRIMARY KEY, json TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE angle_sample(
  sweep INTEGER NOT NULL, sequence INTEGER NOT NULL, point INTEGER NOT NULL, attempt INTEGER NOT NULL,
  turn INTEGER NOT NULL, direction INTEGER NOT NULL, time_s REAL NOT NULL, encoder_deg REAL NOT NULL,
  sensor_deg REAL NOT NULL, temperature_c REAL, PRIMARY KEY(sweep, sequence)) WITHOUT ROWID;
CREATE TABLE sample_gap(
  sweep INTEGER NOT NULL, first_missing INTEGER NOT NULL, count INTEGER NOT NULL, reason TEXT NOT NULL,
  PRIMARY KEY(sweep, first_missing)) WITHOUT ROWID;
)sql";

/// Step i leads from version i to i + 1. Version 0 had one sweep, no repeated points and no record of gaps;
/// version 1 no samples of fields.
constexpr std::array<const char*, Session::schemaVersion> migrations = {R"sql(
ALTER TABLE angle_sample RENAME TO angle_sample_0;
CREATE TABLE angle_sample(
  sweep INTEGER NOT NULL, sequence INTEGER NOT NULL, point INTEGER NOT NULL, attempt INTEGER NOT NULL,
  turn INTEGER NOT NULL, direction INTEGER NOT NULL, time_s REAL NOT NULL, encoder_deg REAL NOT NULL,
  sensor_deg REAL NOT NULL, temperature_c REAL, PRIMARY KEY(sweep, sequence)) WITHOUT ROWID;
INSERT INTO angle_sample
  SELECT 0, sequence, point, 0, turn, direction, time_s, encoder_deg, sensor_deg, temperature_c FROM angle_sample_0;
DROP TABLE angle_sample_0;
CREATE TABLE sample_gap(
  sweep INTEGER NOT NULL, first_missing INTEGER NOT NULL, count INTEGER NOT NULL, reason TEXT NOT NULL,
  PRIMARY KEY(sweep, first_missing)) WITHOUT ROWID;
)sql",
                                                                        fieldTable};

Result<void> setVersion(Database& database, int version) {
  return database.run(("PRAGMA user_version = " + std::to_string(version)).c_str());
}

std::unexpected<Error> damaged(const std::string& how, const std::filesystem::path& file) {
  return fail(ErrorKind::Storage, "the session file is damaged (" + how + ")",
              "use a copy from your backup, or rescue what is readable with: sqlite3 FILE .recover", file.string());
}

/// SQLite reads a page that is cut short as if it ended in zeros. While there is a log, the file may be shorter.
Result<void> checkWholePages(Database& database, const std::filesystem::path& file) {
  const auto mode = database.text("PRAGMA journal_mode");
  const auto page = database.integer("PRAGMA page_size");
  if (!mode || !page) {
    return std::unexpected(!mode ? mode.error() : page.error());
  }
  std::error_code problem;
  const auto size = std::filesystem::file_size(file, problem);
  if (*mode != "wal" && !problem && *page > 0 && size % static_cast<std::uintmax_t>(*page) != 0) {
    return damaged("it ends in the middle of a page", file);
  }
  return {};
}

Result<void> checkTables(Database& database, std::int64_t version, const std::filesystem::path& file) {
  std::vector<std::string> tables = {"meta", "document", "angle_sample"};
  if (version >= 1) {
    tables.emplace_back("sample_gap");
  }
  if (version >= 2) {
    tables.emplace_back("field_sample");
  }
  for (const std::string& table : tables) {
    const auto count =
        database.integer("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name = '" + table + "'");
    if (!count) {
      return std::unexpected(count.error());
    }
    if (*count != 1) {
      return damaged("table " + table + " is missing", file);
    }
  }
  return {};
}

} // namespace

Result<void> createSchema(Database& database, SessionKind kind) {
  Transaction transaction(database);
  if (auto begun = transaction.begin(); !begun) {
    return begun;
  }
  const std::string identity =
      "PRAGMA application_id = " + std::to_string(sessionApplicationId) + "; INSERT INTO meta VALUES('kind', '" +
      (kind == SessionKind::Angle ? "angle" : "field") + "'), ('software', 'straightedge " STRAIGHTEDGE_VERSION "')";
  if (auto made = database.run(tablesOfVersion1); !made) {
    return made;
  }
  if (auto made = database.run(fieldTable); !made) {
    return made;
  }
  if (auto named = database.run(identity.c_str()); !named) {
    return named;
  }
  if (auto set = setVersion(database, Session::schemaVersion); !set) {
    return set;
  }
  return transaction.commit();
}

Result<void> checkSession(Database& database, const std::filesystem::path& file) {
  const auto application = database.integer("PRAGMA application_id");
  if (!application) {
    return std::unexpected(application.error());
  }
  if (*application != sessionApplicationId) {
    return fail(ErrorKind::Input, "this is a database of another program, not a Straightedge session",
                "choose a .sedge file", file.string());
  }
  const auto version = database.integer("PRAGMA user_version");
  if (!version) {
    return std::unexpected(version.error());
  }
  if (*version > Session::schemaVersion) {
    return fail(ErrorKind::Input,
                "the session was written by a later Straightedge (file version " + std::to_string(*version) +
                    ", this program knows up to " + std::to_string(Session::schemaVersion) + ")",
                "install the newer program; the file was not changed", file.string());
  }
  if (*version < 0) {
    return damaged("its version is " + std::to_string(*version), file);
  }
  const auto verdict = database.text("PRAGMA quick_check(1)");
  if (!verdict) {
    return std::unexpected(verdict.error());
  }
  if (*verdict != "ok") {
    return damaged(verdict->substr(0, verdict->find('\n')), file);
  }
  if (auto whole = checkWholePages(database, file); !whole) {
    return whole;
  }
  return checkTables(database, *version, file);
}

Result<void> migrate(Database& database) {
  const auto version = database.integer("PRAGMA user_version");
  if (!version) {
    return std::unexpected(version.error());
  }
  if (*version >= Session::schemaVersion) {
    return {};
  }
  Transaction transaction(database);
  if (auto begun = transaction.begin(); !begun) {
    return begun;
  }
  for (auto step = static_cast<std::size_t>(*version); step < migrations.size(); ++step) {
    if (auto done = database.run(migrations.at(step)); !done) {
      return done;
    }
  }
  if (auto set = setVersion(database, Session::schemaVersion); !set) {
    return set;
  }
  return transaction.commit();
}

Result<SessionKind> kindOf(Database& database, const std::filesystem::path& file) {
  const auto kind = database.text("SELECT value FROM meta WHERE key = 'kind'");
  if (!kind) {
    return std::unexpected(kind.error());
  }
  if (*kind == "angle") {
    return SessionKind::Angle;
  }
  if (*kind == "field") {
    return SessionKind::Field;
  }
  return damaged("its kind is '" + *kind + "'", file);
}

} // namespace straightedge::session
