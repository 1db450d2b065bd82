// The history of the schema: numbered SQL files in the folder migrations, embedded in the program. They only
// lead forward. A released file never changes; a change gets a file with the next number, and tests/session
// gets a fixture of the version before.
//
// A migration that changes columns recomputes row_check with the SQL function macula_check('table', column,
// ...), and rows.h gets the new columns.
#pragma once

#include <span>
#include <string_view>

#include "base/result.h"
#include "session/database.h"

namespace macula::session {

struct Migration {
    int number = 0;         // from 1, without gaps
    std::string_view name;  // "0001_first"
    std::string_view sql;   // statements, without BEGIN and COMMIT
};

// All migrations that this program knows.
std::span<const Migration> migrations();
int newestVersion();

// Applies the migrations that the database lacks, each in one transaction with its number, so that a stop
// leaves one version or the next. Foreign keys hold before each commit. Fails with newerSchema, changing
// nothing, if the database has a number above the last of `all`. Another process may migrate at the same
// time.
Result<void> migrate(Connection& connection, std::span<const Migration> all = migrations());

// Fails with damaged if tables, indexes or triggers of a migrated database differ, in any word, from those
// that the migrations create. So a migration rebuilds a changed table instead of altering it: SQLite words an
// altered table itself, each version differently.
Result<void> checkSchema(Connection& connection);

}  // namespace macula::session
