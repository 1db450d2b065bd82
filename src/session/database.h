// The connection to the database file, and how it is kept safe.
//
// Journal: a rollback journal that is truncated (journal_mode=TRUNCATE, synchronous=FULL), never WAL. SQLite
// 3.7.0 to 3.51.2, so that of Debian 12 too, can corrupt a file in WAL mode when two connections write and
// checkpoint at the same moment (the WAL-reset fault, sqlite.org/wal.html). An own lock around checkpoints
// would hold only for programs that know of it, and not for the sqlite3 tool. A rollback journal has no such
// fault. It needs no shared memory, so it works on network drives too, where those lock files. It is empty
// between transactions, so what was deleted is not in it. It costs more synchronisations of the disk for each
// transaction (docs/measurements), which no frame waits for, and readers wait while another
// process commits. A file of ours that somebody has put into WAL mode is put back when it is opened.
//
// Nothing else opens the database file while a connection is open: closing any descriptor of a file drops
// SQLite's locks of it in the whole process.
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

// "Macu", in the header of the file, by which it is known to be ours.
inline constexpr int kApplicationId = 0x4d616375;

enum class Access { readOnly, readWrite };

struct ConnectionOptions {
    Access access = Access::readWrite;         // readWrite creates the file where it is missing
    std::chrono::milliseconds patience{5000};  // how long a lock of another process is waited for
    std::string vfs;                           // name of SQLite's file layer; empty: that of the system
    bool isOurs = true;                        // false: nothing of the file changes until settle()
};

// Used by one thread at a time.
struct Connection {
    std::filesystem::path file;
    SQLite::Database sqlite;
    std::chrono::milliseconds patience{};
    std::chrono::steady_clock::time_point waitsSince{};  // of the lock that is waited for now
};

// Fails with damaged for what is no database, and with the Trouble that keeps it from being used.
Result<std::unique_ptr<Connection>> connect(const std::filesystem::path& file,
                                            const ConnectionOptions& options);

// Mode 0600, which its journal gets as well, and the rollback journal: before anything is written to the
// file.
Result<void> settle(Connection& connection);

// Gives SQL the function macula_check(table, column, ...): row_check for migrations that change columns.
void addCheckFunction(SQLite::Database& sqlite);

// What SQLite threw, for a person.
Error errorOf(const SQLite::Exception& exception, const Connection& connection);

// What the database says of itself.
struct Inspection {
    bool isEmpty = false;  // no table yet
    int version = 0;       // user_version: the number of the last migration
};

// PRAGMA quick_check, or integrity_check and foreign_key_check.
enum class Thoroughness { quick, full };
// What they say; throws when the disk does not read a page, which is no damage.
bool isSound(SQLite::Database& sqlite, Thoroughness thoroughness);

// Fails with notOurs for a database of another program, and with damaged where the check finds something.
Result<Inspection> inspect(Connection& connection, Thoroughness thoroughness);

// Runs `work`, which returns a Result, and makes an Error of what SQLite throws: no exception leaves the file
// that calls this.
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

// All of `work` is written, or nothing: nothing when it returns an error. Whoever writes waits here for the
// writers of other processes, and for none later on.
template <class Work>
auto inTransaction(Connection& connection, Work&& work) -> decltype(work()) {
    return guarded(connection, [&]() -> decltype(work()) {
        SQLite::Transaction transaction(connection.sqlite, SQLite::TransactionBehavior::IMMEDIATE);
        auto result = work();
        if (result.ok()) transaction.commit();
        return result;
    });
}

// All that `work` reads is of one moment.
template <class Work>
auto inReading(Connection& connection, Work&& work) -> decltype(work()) {
    return guarded(connection, [&]() -> decltype(work()) {
        SQLite::Transaction transaction(connection.sqlite, SQLite::TransactionBehavior::DEFERRED);
        return work();
    });
}

}  // namespace macula::session
