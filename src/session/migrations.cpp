#include "session/migrations.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include <string>

namespace macula::session {

namespace {

// Applies one migration; false if there was none left.
Result<bool> applyNext(Connection& connection, std::span<const Migration> all) {
    return inTransaction(connection, [&]() -> Result<bool> {
        SQLite::Database& sqlite = connection.sqlite;
        const int version = sqlite.execAndGet("PRAGMA user_version").getInt();
        if (version > all.back().number) return errorOf(Trouble::newerSchema, connection.file);
        if (version == all.back().number) return false;
        const Migration& next = all[static_cast<std::size_t>(version)];
        MACULA_CHECK_EQ(next.number, version + 1);
        sqlite.exec(std::string(next.sql));
        if (SQLite::Statement(sqlite, "PRAGMA foreign_key_check").executeStep())
            return errorOf(Trouble::damaged, connection.file);
        if (version == 0) sqlite.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
        sqlite.exec("PRAGMA user_version = " + std::to_string(next.number));
        return true;
    });
}

// Names and SQL of the whole schema, in order, without the statistics tables that ANALYZE of any tool adds.
std::string schemaOf(SQLite::Database& sqlite) {
    std::string text;
    SQLite::Statement rows(sqlite,
                           "SELECT type, name, tbl_name, sql FROM sqlite_schema WHERE name NOT GLOB "
                           "'sqlite_stat*' ORDER BY type, name");
    while (rows.executeStep()) {
        for (int i = 0; i < 4; ++i) text += rows.getColumn(i).getString() + "\n";
    }
    return text;
}

std::string newestSchema() {
    SQLite::Database sqlite(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    addCheckFunction(sqlite);
    for (const Migration& migration : migrations()) sqlite.exec(std::string(migration.sql));
    return schemaOf(sqlite);
}

}  // namespace

int newestVersion() {
    return migrations().back().number;
}

Result<void> migrate(Connection& connection, std::span<const Migration> all) {
    return guarded(connection, [&]() -> Result<void> {
        const int version = connection.sqlite.execAndGet("PRAGMA user_version").getInt();
        if (version > all.back().number) return errorOf(Trouble::newerSchema, connection.file);
        if (version == all.back().number) return {};
        // Rebuilding a table drops it for a moment, and that must not delete the rows that refer to it.
        connection.sqlite.exec("PRAGMA foreign_keys = OFF");
        Result<bool> step = true;
        while (step.ok() && *step) step = applyNext(connection, all);
        connection.sqlite.exec("PRAGMA foreign_keys = ON");
        if (!step) return step.error();
        return {};
    });
}

Result<void> checkSchema(Connection& connection) {
    return guarded(connection, [&]() -> Result<void> {
        static const std::string expected = newestSchema();
        if (schemaOf(connection.sqlite) != expected) return errorOf(Trouble::damaged, connection.file);
        return {};
    });
}

}  // namespace macula::session
