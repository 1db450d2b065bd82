// What a Store owns, and the steps that its files share. Private to src/session.
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
// Empty, and there from the first row that a purge deletes until no trace of it is left.
inline constexpr std::string_view kPurgeName = "sessions.purge";

struct StoreState {
    StoreOptions options;
    std::filesystem::path folder;
    std::shared_ptr<LockFile> locks;
    HeldLock presence;
    BlobFiles blobs;
    std::unique_ptr<Connection> connection;  // goes before the locks do
    OpeningNotes notes;

    std::int64_t nowMs() const;
};

// Inside of a transaction: -------------------------------------------------------------------------------

void addAuditRow(StoreState& state, AuditAction action, AuditKind kind, const std::string& subject,
                 std::int64_t amount);

// The row with this primary key; nothing where there is none or it is damaged.
std::optional<Row> findRow(Connection& connection, const Table& table, const std::string& key);

// Makes the row where it is missing, sets the time where it is later.
void rememberStudy(Connection& connection, const std::string& identity, std::int64_t atMs);
void rememberVolume(Connection& connection, const std::string& digest, std::int64_t atMs);

// Damaged rows keep their row_check, so they pass for nothing; aside only keeps them out of the way.
void setRowAside(Connection& connection, const Table& table, std::int64_t id);

// Models. ------------------------------------------------------------------------------------------------

// Nothing for a row that was never written like this.
std::optional<ModelInfo> modelOf(const Row& row);
Row rowOf(const ModelInfo& info);

struct Evicted {
    EvictionReport report;
    std::vector<std::string> blobs;
};
// In a transaction: deletes rows, not blobs. `kept` is never deleted.
Evicted evictRows(StoreState& state, std::uint64_t capBytes, std::int64_t kept);

// A transaction of its own: removes blobs that no row names. When other processes read blobs for longer than
// `patience`, they are left for collectGarbage(), and the result is false.
Result<bool> removeBlobs(StoreState& state, std::span<const std::string> digests, BlobFiles::Removal removal,
                         std::chrono::milliseconds patience);

// The model with that id is set aside, if it still has that blob.
Result<void> setModelAside(StoreState& state, std::int64_t id, const std::string& blob, std::string_view why);

// Blobs that no row names.
Result<std::vector<BlobFiles::Entry>> orphansOf(StoreState& state);

// Purge. -------------------------------------------------------------------------------------------------

bool isPurgeBegun(const StoreState& state);
// Finishes any purge that was begun, by this process or by one that was killed: overwrites the blobs that no
// row names, and rewrites the database (VACUUM), so that no byte of what was deleted is left.
Result<void> finishPurge(StoreState& state);
// Damaged files that were set aside have a folder each.
std::size_t foldersIn(const std::filesystem::path& folder);

// Rows of another database. ------------------------------------------------------------------------------

// In a transaction: adds the row with what it refers to, or puts it in place of an older one of the same key.
// False where the row that is there stays.
bool mergeRow(Connection& connection, const Table& table, const Row& row);

}  // namespace macula::session
