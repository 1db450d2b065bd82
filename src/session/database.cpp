#include "session/database.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <vector>

#include "session/row_check.h"

namespace macula::session {

namespace fs = std::filesystem;

namespace {

// macula_check('models', id, key, ...): row_check for migrations, which change rows in SQL.
void checkFunction(sqlite3_context* context, int count, sqlite3_value** arguments) {
    const auto textOf = [](sqlite3_value* value) {
        const auto* text = reinterpret_cast<const char*>(sqlite3_value_text(value));
        return text == nullptr ? std::string()
                               : std::string(text, static_cast<std::size_t>(sqlite3_value_bytes(value)));
    };
    std::vector<Value> values;
    for (int i = 1; i < count; ++i) {
        switch (sqlite3_value_type(arguments[i])) {
            case SQLITE_NULL:
                values.emplace_back();
                break;
            case SQLITE_INTEGER:
                values.emplace_back(static_cast<std::int64_t>(sqlite3_value_int64(arguments[i])));
                break;
            default:
                values.emplace_back(textOf(arguments[i]));
        }
    }
    if (count > 0) sqlite3_result_int64(context, rowCheck(textOf(arguments[0]), values));
}

// SQLite calls this repeatedly while another process holds a lock. The pauses are short and vary: SQLite's
// own grow to 100 ms, and of two processes that keep writing one would hardly get a turn.
int waitForLock(void* argument, int callsBefore) {
    auto& connection = *static_cast<Connection*>(argument);
    const auto now = std::chrono::steady_clock::now();
    if (callsBefore == 0) connection.waitsSince = now;
    if (now - connection.waitsSince >= connection.patience) return 0;
    std::this_thread::sleep_for(std::chrono::microseconds(500 + now.time_since_epoch().count() % 2000));
    return 1;
}

void configure(Connection& connection) {
    SQLite::Database& sqlite = connection.sqlite;
    sqlite3* const handle = sqlite.getHandle();
    sqlite3_busy_handler(handle, waitForLock, &connection);
    // Disables what a crafted or damaged schema could call, and statements that write to SQLite's own tables.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite.exec("PRAGMA cell_size_check = ON");
    sqlite.exec("PRAGMA mmap_size = 0");        // an I/O error is a result, not a signal
    sqlite.exec("PRAGMA temp_store = MEMORY");  // no stored data in a temporary file elsewhere
    sqlite.exec("PRAGMA cache_size = -32000");  // 32 MB: lists of thousands of studies are read once
    sqlite.exec("PRAGMA foreign_keys = ON");
    sqlite.exec("PRAGMA secure_delete = ON");
    sqlite.exec("PRAGMA synchronous = FULL");
    addCheckFunction(sqlite);
}

Trouble troubleOfIoError(int extended, int systemError) {
    switch (extended) {
        case SQLITE_IOERR_LOCK:
        case SQLITE_IOERR_UNLOCK:
        case SQLITE_IOERR_RDLOCK:
        case SQLITE_IOERR_CHECKRESERVEDLOCK:
            return Trouble::noLocks;
        case SQLITE_IOERR_NOMEM:
            return Trouble::noMemory;
        default:
            return troubleOfErrno(systemError) == Trouble::diskFull ? Trouble::diskFull : Trouble::diskError;
    }
}

Trouble troubleOfCode(int code, int extended, int systemError) {
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return Trouble::lockedByAnother;
        case SQLITE_FULL:
            return Trouble::diskFull;
        case SQLITE_READONLY:
        case SQLITE_CANTOPEN:
        case SQLITE_PERM:
        case SQLITE_AUTH:
            return Trouble::readOnly;
        case SQLITE_PROTOCOL:
            return Trouble::noLocks;
        case SQLITE_NOMEM:
            return Trouble::noMemory;
        case SQLITE_IOERR:
            return troubleOfIoError(extended, systemError);
        case SQLITE_INTERRUPT:
            return Trouble::diskError;
        // The statements are ours and tested, so a missing table or a row that breaks a constraint comes from
        // a damaged file.
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
        default:
            return Trouble::damaged;
    }
}

bool hasTable(SQLite::Database& sqlite, const char* name) {
    SQLite::Statement query(sqlite, "SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = ?");
    query.bind(1, name);
    return query.executeStep();
}

}  // namespace

void addCheckFunction(SQLite::Database& sqlite) {
    sqlite.createFunction("macula_check", -1, true, nullptr, checkFunction, nullptr, nullptr, nullptr);
}

Error errorOf(const SQLite::Exception& exception, const Connection& connection) {
    sqlite3* const handle = connection.sqlite.getHandle();
    return errorOf(troubleOfCode(exception.getErrorCode(), exception.getExtendedErrorCode(),
                                 sqlite3_system_errno(handle)),
                   connection.file);
}

Result<std::unique_ptr<Connection>> connect(const fs::path& file, const ConnectionOptions& options) {
    const int flags = options.access == Access::readOnly ? SQLITE_OPEN_READONLY
                                                         : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    try {
        auto connection = std::unique_ptr<Connection>(
            new Connection{file,
                           SQLite::Database(file.string(), flags | SQLITE_OPEN_NOFOLLOW | SQLITE_OPEN_NOMUTEX,
                                            0, options.vfs),
                           options.patience});
        return guarded(*connection, [&]() -> Result<std::unique_ptr<Connection>> {
            configure(*connection);
            if (options.access == Access::readOnly) return std::move(connection);
            if (sqlite3_db_readonly(connection->sqlite.getHandle(), "main") != 0)
                return errorOf(Trouble::readOnly, file);
            if (options.isOurs) MACULA_TRY_VOID(settle(*connection));
            return std::move(connection);
        });
    } catch (const SQLite::Exception& exception) {
        return errorOf(troubleOfCode(exception.getErrorCode(), exception.getExtendedErrorCode(), 0), file);
    } catch (const std::bad_alloc&) {
        return errorOf(Trouble::noMemory, file);
    }
}

Result<void> settle(Connection& connection) {
    const fs::path& file = connection.file;
    if (chmod(file.c_str(), 0600) != 0 && errno != EPERM && errno != EOPNOTSUPP)
        return errorOf(troubleOfErrno(errno), file);
    return guarded(connection, [&]() -> Result<void> {
        if (connection.sqlite.execAndGet("PRAGMA journal_mode = TRUNCATE").getString() != "truncate")
            return errorOf(Trouble::lockedByAnother, file);
        return {};
    });
}

bool isSound(SQLite::Database& sqlite, Thoroughness thoroughness) {
    const char* check =
        thoroughness == Thoroughness::quick ? "PRAGMA quick_check(1)" : "PRAGMA integrity_check(1)";
    const std::string told = sqlite.execAndGet(check).getString();
    // SQLite reports a page that the disk cannot read like a damaged page, but with an error code.
    constexpr std::string_view kNumber = "error code=";
    const std::size_t number = told.find(kNumber);
    const int code =
        number == std::string::npos ? SQLITE_OK : std::atoi(told.c_str() + number + kNumber.size());
    // This report has no error code, and occurs for no other reason than an unreadable page.
    if (told.find("failed to get page") != std::string::npos)
        throw SQLite::Exception("a page cannot be read", SQLITE_IOERR_READ);
    if ((code & 0xff) == SQLITE_IOERR || (code & 0xff) == SQLITE_NOMEM)
        throw SQLite::Exception("a page cannot be read", code);
    if (told != "ok" || thoroughness == Thoroughness::quick) return told == "ok";
    return !SQLite::Statement(sqlite, "PRAGMA foreign_key_check").executeStep();
}

Result<Inspection> inspect(Connection& connection, Thoroughness thoroughness) {
    return inReading(connection, [&]() -> Result<Inspection> {
        SQLite::Database& sqlite = connection.sqlite;
        const int tables = sqlite.execAndGet("SELECT count(*) FROM sqlite_schema").getInt();
        const int id = sqlite.execAndGet("PRAGMA application_id").getInt();
        const int version = sqlite.execAndGet("PRAGMA user_version").getInt();
        if (tables == 0 && id == 0 && version == 0) return Inspection{.isEmpty = true};
        // The first migration sets tables, id and version in one transaction, so having only some of them is
        // damage.
        const bool looksOurs = hasTable(sqlite, "models") && hasTable(sqlite, "audit");
        if (id != kApplicationId)
            return errorOf(looksOurs ? Trouble::damaged : Trouble::notOurs, connection.file);
        if (!looksOurs || version <= 0 || !isSound(sqlite, thoroughness))
            return errorOf(Trouble::damaged, connection.file);
        return Inspection{.version = version};
    });
}

}  // namespace macula::session
