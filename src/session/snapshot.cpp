#include "session/store_parts.h"

#include <SQLiteCpp/Column.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "base/draft.h"
#include "session/age_clock.h"
#include "session/migrations.h"
#include "session/trouble.h"

namespace macula::session {

namespace fs = std::filesystem;

namespace {

const Error kCancelled{ErrorCode::cancelled, Text("The copy of stored sessions was stopped."), {}, {}};

// Copies the database as it is at one moment, through SQLite. `file` must not exist yet.
Result<void> copyDatabase(Connection& from, const fs::path& file) {
    return guarded(from, [&]() -> Result<void> {
        const std::string texts[]{file.string()};
        execute(from, "VACUUM INTO ?", texts);
        if (chmod(file.c_str(), 0600) != 0 && errno != EPERM) return errorOf(troubleOfErrno(errno), file);
        return syncToDisk(file);
    });
}

std::vector<ModelInfo> modelsOf(Connection& connection, SnapshotReport& report) {
    std::vector<ModelInfo> models;
    SQLite::Statement statement = select(connection, kModels, "WHERE t.aside IS NULL ORDER BY t.used, t.id");
    while (statement.executeStep()) {
        const auto row = readRow(statement, kModels);
        if (auto info = row ? modelOf(*row) : std::nullopt) {
            models.push_back(std::move(*info));
        } else {
            ++report.damaged;
        }
    }
    return models;
}

// Copies the sound blobs, and deletes the other models from the copied database.
Result<void> copyBlobs(Connection& copy, const BlobFiles& from, const BlobFiles& to, SnapshotReport& report,
                       Progress& progress) {
    MACULA_TRY(const std::vector<ModelInfo> models,
               guarded(copy, [&]() -> Result<std::vector<ModelInfo>> { return modelsOf(copy, report); }));
    progress.beginStage(Text("Copying stored models"), models.size());
    std::string kept = "0";
    for (const ModelInfo& info : models) {
        if (progress.cancelled()) return kCancelled;
        progress.advance();
        MACULA_TRY(const auto prepared, to.prepareCopy(from, info.checksum, info.bytes));
        if (!prepared) {
            ++report.damaged;
            continue;
        }
        MACULA_TRY_VOID(to.putInPlace(*prepared));
        kept += "," + std::to_string(info.id);
        ++report.models;
    }
    return inTransaction(copy, [&]() -> Result<void> {
        execute(copy, "DELETE FROM models WHERE id NOT IN (" + kept + ")");
        report.studies = static_cast<std::size_t>(numberOf(copy, "SELECT count(*) FROM studies"));
        report.documents = static_cast<std::size_t>(numberOf(copy, "SELECT count(*) FROM documents"));
        return {};
    });
}

Result<SnapshotReport> fillSnapshot(StoreState& state, const fs::path& folder, Progress& progress) {
    SnapshotReport report;
    if (chmod(folder.c_str(), 0700) != 0 && errno != EPERM) return errorOf(troubleOfErrno(errno), folder);
    MACULA_TRY(const BlobFiles blobs, BlobFiles::open(folder / kModelsName));
    const fs::path file = folder / kDatabaseName;
    {
        // The lock keeps blobs of this moment from being removed before they are copied.
        MACULA_TRY(const HeldLock reading,
                   HeldLock::take(state.locks, LockFile::kBlobs, Hold::shared, state.options.patience));
        MACULA_TRY_VOID(copyDatabase(*state.connection, file));
        MACULA_TRY(const auto copy, connect(file, {}));
        MACULA_TRY_VOID(copyBlobs(*copy, state.blobs, blobs, report, progress));
    }
    std::error_code ignored;
    fs::remove(file.string() + "-journal", ignored);
    MACULA_TRY_VOID(syncToDisk(file));
    MACULA_TRY_VOID(syncToDisk(folder));
    return report;
}

// Resolves symbolic links, which SQLite does not follow. Refuses a place within the store's own folder, which
// must hold only the store's files.
Result<fs::path> placeOfExport(const StoreState& state, const fs::path& newFolder) {
    const auto refused = [&](Text message, Text hint) {
        return Error{ErrorCode::outputNotWritable, std::move(message), newFolder.string(), std::move(hint)};
    };
    std::error_code error;
    fs::path whole = fs::absolute(newFolder, error).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();  // "copy/"
    const fs::path parent = fs::canonical(whole.parent_path(), error);
    if (error)
        return refused(Text("The folder to write into does not exist."),
                       Text("Create it, or choose another place."));
    fs::path target = parent / whole.filename();
    if (fs::exists(fs::symlink_status(target, error)))
        return refused(Text("Something of that name is there already."), Text("Choose another name."));
    const fs::path below = target.lexically_relative(state.folder);
    if (!below.empty() && *below.begin() != "..")
        return refused(Text("An export cannot be in the folder of the stored sessions itself."),
                       Text("Choose another place."));
    return target;
}

// Makes a private copy of the database to import, in the newest schema.
Result<std::unique_ptr<Connection>> openForImport(const fs::path& file, const fs::path& copy) {
    const auto translated = [&](const Error& error) {
        const auto trouble = troubleOf(error);
        const bool isTheFile = trouble == Trouble::damaged || trouble == Trouble::notOurs;
        return isTheFile ? errorOf(Trouble::snapshotInvalid, file) : error;
    };
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return errorOf(Trouble::snapshotInvalid, file);
    auto other = connect(file, {.access = Access::readOnly});
    if (!other) return translated(other.error());
    const auto found = inspect(**other, Thoroughness::quick);
    if (!found) return translated(found.error());
    if (found->isEmpty) return errorOf(Trouble::snapshotInvalid, file);
    if (found->version > newestVersion()) return errorOf(Trouble::newerSchema, file);
    if (auto copied = copyDatabase(**other, copy); !copied) return translated(copied.error());
    MACULA_TRY(auto connection, connect(copy, {}));
    MACULA_TRY_VOID(migrate(*connection));
    if (auto schema = checkSchema(*connection); !schema) return translated(schema.error());
    return connection;
}

// Imports all rows except those of models, which come with their blobs, and of the audit trail, which stays
// that of this store.
Result<void> importRows(StoreState& state, Connection& other, SnapshotReport& report) {
    return inTransaction(*state.connection, [&]() -> Result<void> {
        const std::int64_t latestMs = openingMs(state);
        for (const Table* table : allTables()) {
            if (table == &kModels || table == &kAudit) continue;
            SQLite::Statement rows = select(other, *table, "");
            while (rows.executeStep()) {
                auto row = readRow(rows, *table);
                if (!row) {
                    ++report.damaged;
                    continue;
                }
                setTimesBefore(*row, *table, latestMs);
                const bool isTaken = mergeRow(*state.connection, *table, *row);
                if (table == &kStudies && isTaken) ++report.studies;
                if (table == &kDocuments) ++(isTaken ? report.documents : report.skipped);
            }
        }
        addAuditRow(state, AuditAction::imported, AuditKind::store, {}, 1);
        return {};
    });
}

// The imported model keeps its old time of use, so it may be the first to be evicted. Checks its stated size
// against the cap before reading anything, because a foreign folder may state any size.
Result<void> importModel(StoreState& state, const ModelInfo& info, const BlobFiles& from,
                         SnapshotReport& report) {
    if (info.bytes > state.options.modelCapBytes) {
        ++report.skipped;
        return {};
    }
    MACULA_TRY(const auto copied, state.blobs.prepareCopy(from, info.checksum, info.bytes));
    if (!copied) {
        ++report.damaged;
        return {};
    }
    std::vector<std::string> unused{info.checksum};
    const auto isTaken = inTransaction(*state.connection, [&]() -> Result<bool> {
        MACULA_TRY_VOID(state.blobs.putInPlace(*copied));
        Row row = rowOf(info);
        setTimesBefore(row, kModels, openingMs(state));
        const bool taken = mergeRow(*state.connection, kModels, row);
        const Evicted evicted = evictRows(state, state.options.modelCapBytes, 0);
        unused.insert(unused.end(), evicted.blobs.begin(), evicted.blobs.end());
        return taken;
    });
    static_cast<void>(removeBlobs(state, unused, BlobFiles::Removal::plain, {}));
    if (!isTaken) return isTaken.error();
    ++(*isTaken ? report.models : report.skipped);
    return {};
}

}  // namespace

Result<SnapshotReport> StoreSnapshots::exportTo(const fs::path& newFolder, Progress& progress) {
    MACULA_TRY(const fs::path target, placeOfExport(state_, newFolder));
    MACULA_TRY(const Draft draft, Draft::beside(target, Draft::Kind::folder));
    MACULA_TRY(const SnapshotReport report, fillSnapshot(state_, draft.path(), progress));
    // The audit trail is written first: an entry for a failed export is better than an export without one.
    MACULA_TRY_VOID(AuditTrail(state_).add(AuditAction::exported, AuditKind::store, {}, 1));
    if (rename(draft.path().c_str(), target.c_str()) != 0) return errorOf(troubleOfErrno(errno), target);
    static_cast<void>(syncToDisk(target.parent_path()));  // best effort: the folder is in place even so
    return report;
}

Result<SnapshotReport> StoreSnapshots::importFrom(const fs::path& folder, Progress& progress) {
    std::error_code error;
    const fs::path source = fs::canonical(folder, error);
    if (error) return errorOf(Trouble::snapshotInvalid, folder);
    MACULA_TRY(const Draft draft, Draft::beside(state_.folder / kDatabaseName, Draft::Kind::folder));
    if (chmod(draft.path().c_str(), 0700) != 0 && errno != EPERM)
        return errorOf(troubleOfErrno(errno), draft.path());
    MACULA_TRY(const auto other, openForImport(source / kDatabaseName, draft.path() / kDatabaseName));
    SnapshotReport report;
    MACULA_TRY_VOID(importRows(state_, *other, report));
    MACULA_TRY(const std::vector<ModelInfo> models,
               guarded(*other, [&]() -> Result<std::vector<ModelInfo>> { return modelsOf(*other, report); }));
    const fs::path blobFolder = source / kModelsName;
    if (models.empty() || !fs::is_directory(blobFolder, error)) {
        report.damaged += models.size();
        return report;
    }
    MACULA_TRY(const BlobFiles blobs, BlobFiles::open(blobFolder));
    progress.beginStage(Text("Importing stored models"), models.size());
    for (const ModelInfo& info : models) {
        if (progress.cancelled()) return kCancelled;
        progress.advance();
        MACULA_TRY_VOID(importModel(state_, info, blobs, report));
    }
    return report;
}

}  // namespace macula::session
