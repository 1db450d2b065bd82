// The connection to the database file, and the settings that keep it safe.
//
// Journal: a truncated rollback journal (journal_mode=TRUNCATE, synchronous=FULL), never WAL. In WAL mode,
// SQLite 3.7.0 to 3.51.2, and so that of Debian 12, can corrupt a file when two connections write and
// checkpoint at the same moment (the WAL-reset fault, sqlite.org/wal.html). A lock of our own around
// checkpoints would not bind the sqlite3 tool. A rollback journal has no such fault. It needs no shared
// memory, so it also works on network drives that lock files. It is empty between transactions, so it holds
// no deleted data. It costs more disk synchronisations per transaction (docs/measurements), for which no
// frame waits, and readers wait while another process commits. Opening a file of ours in WAL mode puts it
// back into this mode.
//
// Nothing else may open the database file while a connection is open: closing any descriptor of a file drops
// SQLite's locks on it in the whole process.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <new>
#include <string>

#include "base/result.h"
#include "session/trouble.h"

namespace macula::session {

// "Macu": the application id in the file's header, which marks it as ours.
inline constexpr int kApplicationId = 0x4d616375;

enum class Access { readOnly, readWrite };

struct ConnectionOptions {
    Access access = Access::readWrite;         // readWrite creates a missing file
    std::chrono::milliseconds patience{5000};  // the longest wait for another process's lock
    std::string vfs;                           // name of SQLite's file layer; empty: the default
    bool isOurs = true;                        // false: the file does not change until settle()
};

// Used by one thread at a time.
struct Connection {
    std::filesystem::path file;
    SQLite::Database sqlite;
    std::chrono::milliseconds patience{};
    std::chrono::steady_clock::time_point waitsSince{};  // when the current wait for a lock began
};

// Fails with damaged for a file that is not a database, or with the Trouble that prevents its use.
Result<std::unique_ptr<Connection>> connect(const std::filesystem::path& file,
                                            const ConnectionOptions& options);

// Sets mode 0600, which the journal gets as well, and the rollback journal. Call before anything is written
// to the file.
Result<void> settle(Connection& connection);

// Adds the SQL function macula_check(table, column, ...): row_check for migrations that change columns.
void addCheckFunction(SQLite::Database& sqlite);

// The error, for the user, of an exception that SQLite threw.
Error errorOf(const SQLite::Exception& exception, const Connection& connection);

// What inspect() finds.
struct Inspection {
    bool isEmpty = false;  // no table yet
    int version = 0;       // user_version: the number of the last migration
};

// PRAGMA quick_check, or integrity_check and foreign_key_check.
enum class Thoroughness { quick, full };
// Whether the check passes. Throws if the disk cannot read a page, because that is not damage.
bool isSound(SQLite::Database& sqlite, Thoroughness thoroughness);

// Fails with notOurs for a database of another program, and with damaged if the check finds damage.
Result<Inspection> inspect(Connection& connection, Thoroughness thoroughness);

// Runs `work`, which returns a Result, and turns SQLite's exceptions into an Error, so that no caller has to
// catch them.
template <class Work>
auto guarded(const Connection& connection, Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const SQLite::Exception& exception) {
        return errorOf(exception, connection);
    } catch (const std::bad_alloc&) {
        return errorOf(Trouble::noMemory, connection.file);
    }
}

// Commits everything that `work` writes, or nothing if it returns an error. Waits for writers of other
// processes before `work` begins, and not later.
template <class Work>
auto inTransaction(Connection& connection, Work&& work) -> decltype(work()) {
    return guarded(connection, [&]() -> decltype(work()) {
        SQLite::Transaction transaction(connection.sqlite, SQLite::TransactionBehavior::IMMEDIATE);
        auto result = work();
        if (result.ok()) transaction.commit();
        return result;
    });
}

// Runs `work` in a read transaction: everything that it reads comes from the same moment.
template <class Work>
auto inReading(Connection& connection, Work&& work) -> decltype(work()) {
    return guarded(connection, [&]() -> decltype(work()) {
        SQLite::Transaction transaction(connection.sqlite, SQLite::TransactionBehavior::DEFERRED);
        return work();
    });
}

}  // namespace macula::session
