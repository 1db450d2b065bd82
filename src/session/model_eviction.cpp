// Makes room for models: deletes rows, and then the blobs that no row names.
#include <SQLiteCpp/Column.h>

#include <algorithm>

#include "session/store_state.h"

namespace macula::session {

namespace {

struct Evictable {
    std::int64_t id = 0;
    std::string key;
    std::string blob;
    std::uint64_t bytes = 0;
    bool isAside = false;
    bool isDamaged = false;
};

// A damaged row's own size is not trusted: the size of its file counts towards the cap.
Evictable evictableAt(StoreState& state, SQLite::Statement& statement) {
    const auto row = readRow(statement, kModels);
    const auto textAt = [&](int place) { return statement.getColumn(place).getString(); };
    Evictable found{.id = statement.getColumn(column::modelId).getInt64(),
                    .key = textAt(column::modelKey),
                    .blob = textAt(column::modelBlob),
                    .isAside = !statement.getColumn(column::modelAside).isNull(),
                    .isDamaged = !row};
    if (row) {
        found.bytes = static_cast<std::uint64_t>(row->number(column::modelBytes));
    } else if (isDigest(found.blob)) {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(state.blobs.fileOf(found.blob), error);
        found.bytes = error ? 0 : size;
    }
    return found;
}

}  // namespace

Evicted evictRows(StoreState& state, std::uint64_t capBytes, std::int64_t kept) {
    Connection& connection = *state.connection;
    std::vector<Evictable> rows;
    std::uint64_t all = 0;
    SQLite::Statement statement = select(connection, kModels, "ORDER BY t.aside IS NULL, t.used, t.id");
    while (statement.executeStep()) {
        rows.push_back(evictableAt(state, statement));
        all += rows.back().bytes;
    }
    std::stable_partition(rows.begin(), rows.end(),
                          [](const Evictable& row) { return row.isAside || row.isDamaged; });
    Evicted evicted;
    for (const Evictable& row : rows) {
        if (all <= capBytes) break;
        const bool isOpen =
            !row.isAside && isDigest(row.key) && state.locks->isMarked(LockFile::byteOf(row.key));
        if (isOpen || row.id == kept) continue;
        execute(connection, "DELETE FROM models WHERE id = " + std::to_string(row.id));
        all -= row.bytes;
        ++evicted.report.models;
        evicted.report.bytes += row.bytes;
        evicted.blobs.push_back(row.blob);
    }
    evicted.report.bytesLeft = all;
    return evicted;
}

Result<bool> removeBlobs(StoreState& state, std::span<const std::string> digests, BlobFiles::Removal removal,
                         std::chrono::milliseconds patience) {
    if (digests.empty()) return true;
    // During the transaction no other process can commit a row for one of these blobs.
    return inTransaction(*state.connection, [&]() -> Result<bool> {
        auto alone = HeldLock::take(state.locks, LockFile::kBlobs, Hold::exclusive, patience);
        if (!alone && troubleOf(alone.error()) == Trouble::lockedByAnother) return false;
        if (!alone) return alone.error();
        for (const std::string& digest : digests) {
            if (!isDigest(digest)) continue;  // from a damaged row
            const std::string texts[]{digest};
            if (numberOf(*state.connection, "SELECT count(*) FROM models WHERE blob = ?", texts) > 0)
                continue;
            MACULA_TRY_VOID(state.blobs.remove(digest, removal));
        }
        return true;
    });
}

}  // namespace macula::session
