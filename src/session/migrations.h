// How the schema grew: numbered SQL files in the folder migrations, embedded in the program. They only lead
// forward. A file that was released is never changed; what is to be changed gets the next number, and
// tests/session a fixture of the version before.
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

// All that this program knows.
std::span<const Migration> migrations();
int newestVersion();

// Applies those that the database lacks, each in one transaction with its number, so that a stop leaves one
// version or the next. Foreign keys hold again before each commit. Fails with newerSchema, and changes
// nothing, where the database has a number above the last of `all`. Another process may migrate at the same
// time.
Result<void> migrate(Connection& connection, std::span<const Migration> all = migrations());

// Fails with damaged where tables, indexes or triggers of a migrated database are not, word for word, those
// that the migrations make. A migration therefore makes a changed table anew, and does not alter it: SQLite
// words an altered one itself, each version in its way.
Result<void> checkSchema(Connection& connection);

}  // namespace macula::session
