// Tables of a session file, how an older file gets them, and what makes a file a session.
#pragma once

#include "core/base/error.h"
#include "core/session/database.h"
#include "core/session/session.h"

namespace straightedge::session {

/// "Sedg": SQLite's application_id of a session.
inline constexpr std::int64_t sessionApplicationId = 0x53656467;

Result<void> createSchema(Database& database, SessionKind kind);

/// Is this a whole session of a version we know? Reads only.
/// Errors: Input (not a session, later version), Storage (damaged).
Result<void> checkSession(Database& database, const std::filesystem::path& file);

/// Brings an older file to Session::schemaVersion, in one transaction. The file was checked.
Result<void> migrate(Database& database);

Result<SessionKind> kindOf(Database& database, const std::filesystem::path& file);

} // namespace straightedge::session
