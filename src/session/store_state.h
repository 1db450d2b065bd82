// The members of a Store, and functions that its source files share. Private to src/session.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "session/blob_files.h"
#include "session/database.h"
#include "session/lock_file.h"
#include "session/rows.h"
#include "session/store.h"

namespace macula::session {

inline constexpr std::string_view kDatabaseName = "sessions.db";
inline constexpr std::string_view kLockName = "sessions.lock";
inline constexpr std::string_view kModelsName = "models";
inline constexpr std::string_view kDamagedName = "damaged";
// An empty file that marks an unfinished purge: it exists from the first deleted row until no trace of the
// deleted data is left.
inline constexpr std::string_view kPurgeName = "sessions.purge";

struct StoreState {
    StoreOptions options;
    std::filesystem::path folder;
    std::shared_ptr<LockFile> locks;
    HeldLock presence;
    BlobFiles blobs;
    std::unique_ptr<Connection> connection;  // destroyed before the locks
    OpeningNotes notes;

    std::int64_t nowMs() const;
};

// Within a transaction: ----------------------------------------------------------------------------------

void addAuditRow(StoreState& state, AuditAction action, AuditKind kind, const std::string& subject,
                 std::int64_t amount);

// The row with this primary key; nothing if it is missing or damaged.
std::optional<Row> findRow(Connection& connection, const Table& table, const std::string& key);

// Creates the row if it is missing. rememberVolume also widens its times of opening to include `atMs`.
void rememberStudy(Connection& connection, const std::string& identity, std::int64_t atMs);
void rememberVolume(Connection& connection, const std::string& digest, std::int64_t atMs);

// Sets `aside` of a damaged row, to keep it out of the way. Its row_check stays, so the row still fails the
// check.
void setRowAside(Connection& connection, const Table& table, std::int64_t id);

// Models. ------------------------------------------------------------------------------------------------

// The model of a row; nothing for a row that rowOf() cannot have written.
std::optional<ModelInfo> modelOf(const Row& row);
Row rowOf(const ModelInfo& info);

struct Evicted {
    EvictionReport report;
    std::vector<std::string> blobs;
};
// Call in a transaction: deletes rows, not blobs, and never the row with the id `kept`.
Evicted evictRows(StoreState& state, std::uint64_t capBytes, std::int64_t kept);

// In its own transaction, removes those of the blobs that no row names. If other processes read blobs for
// longer than `patience`, leaves them for collectGarbage(), and returns false.
Result<bool> removeBlobs(StoreState& state, std::span<const std::string> digests, BlobFiles::Removal removal,
                         std::chrono::milliseconds patience);

// Sets the model with that id aside, if it still has that blob.
Result<void> setModelAside(StoreState& state, std::int64_t id, const std::string& blob, std::string_view why);

// Blobs that no row names.
Result<std::vector<BlobFiles::Entry>> orphansOf(StoreState& state);

// Purge. -------------------------------------------------------------------------------------------------

bool isPurgeBegun(const StoreState& state);
// Finishes a purge that this process or a killed one began: overwrites the blobs that no row names, and
// rewrites the database (VACUUM), so that no byte of the deleted data is left.
Result<void> finishPurge(StoreState& state);
// The number of folders in `folder`: one for each damaged database that was set aside.
std::size_t foldersIn(const std::filesystem::path& folder);

// Rows of another database. ------------------------------------------------------------------------------

// Call in a transaction: adds the row with the rows it refers to, or replaces an older one of the same key.
// False if the existing row stays.
bool mergeRow(Connection& connection, const Table& table, const Row& row);

}  // namespace macula::session
