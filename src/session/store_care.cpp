// Purge, verification and garbage of a Store.
#include <SQLiteCpp/Column.h>

#include <algorithm>
#include <set>

#include "base/draft.h"
#include "session/store.h"
#include "session/store_state.h"
#include "session/trouble.h"

namespace macula::session {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> textsOf(Connection& connection, const std::string& sql,
                                 std::span<const std::string> texts = {}) {
    std::vector<std::string> found;
    SQLite::Statement statement(connection.sqlite, sql);
    for (int i = 0; i < static_cast<int>(texts.size()); ++i)
        statement.bind(i + 1, texts[static_cast<std::size_t>(i)]);
    while (statement.executeStep()) found.push_back(statement.getColumn(0).getString());
    return found;
}

std::size_t foldersIn(const fs::path& folder) {
    std::error_code error;
    std::size_t count = 0;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        ++count;
    return count;
}

bool isAnyOpen(StoreState& state, const std::vector<std::string>& volumes) {
    return std::ranges::any_of(volumes, [&](const std::string& volume) {
        const std::string texts[]{volume};
        return std::ranges::any_of(
            textsOf(*state.connection, "SELECT key FROM models WHERE volume = ? AND aside IS NULL", texts),
            [&](const std::string& key) { return state.locks->isMarked(LockFile::byteOf(key)); });
    });
}

std::vector<std::string> volumesOfStudy(Connection& connection, const std::string& study) {
    const std::string texts[]{study};
    return textsOf(
        connection,
        "SELECT DISTINCT v.volume FROM series s JOIN series_volumes v ON v.series = s.identity WHERE "
        "s.study = ?",
        texts);
}

// A volume that some study still has stays.
void deleteVolume(StoreState& state, const std::string& volume, PurgeReport& report,
                  std::vector<std::string>& blobs) {
    Connection& connection = *state.connection;
    const std::string texts[]{volume};
    if (numberOf(connection, "SELECT count(*) FROM series_volumes WHERE volume = ?", texts) > 0) return;
    const auto ofModels = textsOf(connection, "SELECT blob FROM models WHERE volume = ?", texts);
    report.models += ofModels.size();
    blobs.insert(blobs.end(), ofModels.begin(), ofModels.end());
    report.volumes += static_cast<std::size_t>(
        numberOf(connection, "SELECT count(*) FROM volumes WHERE digest = ?", texts));
    execute(connection, "DELETE FROM volumes WHERE digest = ?", texts);
}

// Deletes the rows of one study and tells which blobs nobody has a row for.
void deleteStudy(StoreState& state, const std::string& study, PurgeReport& report,
                 std::vector<std::string>& blobs) {
    Connection& connection = *state.connection;
    const std::string texts[]{study};
    const auto volumes = volumesOfStudy(connection, study);
    report.documents += static_cast<std::size_t>(
        numberOf(connection, "SELECT count(*) FROM documents WHERE study = ?", texts));
    report.studies += static_cast<std::size_t>(
        numberOf(connection, "SELECT count(*) FROM studies WHERE identity = ?", texts));
    execute(connection, "DELETE FROM studies WHERE identity = ?", texts);
    for (const std::string& volume : volumes) deleteVolume(state, volume, report, blobs);
}

// Unallocated bytes of pages can hold rows that were moved before they were deleted: writing the file anew
// leaves none. The copy that SQLite makes on the way is in memory.
Result<void> compact(StoreState& state) {
    return guarded(*state.connection, [&]() -> Result<void> {
        state.connection->sqlite.exec("VACUUM");
        return {};
    });
}

// Blobs and pages of what was deleted, so that no byte of it is left.
Result<void> eraseTraces(StoreState& state, std::span<const std::string> blobs) {
    const Error incomplete = errorOf(Trouble::purgeIncomplete, state.folder);
    MACULA_TRY(const bool areRemoved,
               removeBlobs(state, blobs, BlobFiles::Removal::overwritten, state.options.patience));
    auto compacted = compact(state);
    if (!compacted && troubleOf(compacted.error()) == Trouble::lockedByAnother) return incomplete;
    if (!compacted) return compacted;
    if (!areRemoved) return incomplete;
    return {};
}

// Blobs that no row names: with them a purge that was stopped is completed.
Result<std::vector<BlobFiles::Entry>> orphansOf(StoreState& state) {
    MACULA_TRY(std::vector<BlobFiles::Entry> entries, state.blobs.list());
    MACULA_TRY(const std::set<std::string> named,
               guarded(*state.connection, [&]() -> Result<std::set<std::string>> {
                   const auto blobs = textsOf(*state.connection, "SELECT blob FROM models");
                   return std::set<std::string>(blobs.begin(), blobs.end());
               }));
    std::erase_if(entries, [&](const BlobFiles::Entry& entry) { return named.contains(entry.digest); });
    return entries;
}

// Reads all rows of a table; damaged models and documents are set aside. What was set aside before counts as
// that alone.
void verifyRows(StoreState& state, const Table& table, VerifyReport& report) {
    Connection& connection = *state.connection;
    const bool hasAside = table.columns.back().name == "aside";
    std::vector<std::int64_t> damaged;
    SQLite::Statement statement = select(connection, table, "");
    while (statement.executeStep()) {
        ++report.rows;
        const auto row = readRow(statement, table);
        const int aside = static_cast<int>(table.columns.size()) - 1;
        if (hasAside && !statement.getColumn(aside).isNull()) {
            ++report.setAside;
        } else if (!row || (&table == &kModels && !modelOf(*row))) {
            ++report.damagedRows;
            if (hasAside) damaged.push_back(statement.getColumn(0).getInt64());
        }
    }
    for (const std::int64_t id : damaged) setRowAside(connection, table, id);
    report.setAside += damaged.size();
}

Result<void> verifyDatabase(StoreState& state, VerifyReport& report) {
    Connection& connection = *state.connection;
    const auto isDamaged = [](const Result<void>& result) {
        return !result && troubleOf(result.error()) == Trouble::damaged;
    };
    auto pages = guarded(connection, [&]() -> Result<void> {
        report.isDatabaseSound =
            isSound(connection.sqlite, Thoroughness::full) &&
            !SQLite::Statement(connection.sqlite, "PRAGMA foreign_key_check").executeStep();
        return {};
    });
    if (!pages && !isDamaged(pages)) return pages;
    for (const Table* table : allTables()) {
        auto rows = inTransaction(connection, [&]() -> Result<void> {
            verifyRows(state, *table, report);
            return {};
        });
        if (isDamaged(rows)) report.isDatabaseSound = false;
        if (!rows && !isDamaged(rows)) return rows;
    }
    return {};
}

}  // namespace

Result<PurgeReport> Store::purge(std::span<const std::string> studies, std::span<const std::string> volumes,
                                 DamagedFiles damaged, AuditAction action) {
    StoreState& state = *state_;
    PurgeReport report;
    std::vector<std::string> blobs;
    MACULA_TRY_VOID(inTransaction(*state.connection, [&]() -> Result<void> {
        for (const std::string& study : studies) {
            if (isAnyOpen(state, volumesOfStudy(*state.connection, study)))
                return errorOf(Trouble::lockedByAnother, state.folder);
            const std::size_t before = report.studies;
            deleteStudy(state, study, report, blobs);
            addAuditRow(state, action, AuditKind::study, study,
                        static_cast<std::int64_t>(report.studies - before));
        }
        for (const std::string& volume : volumes) {
            if (isAnyOpen(state, {volume})) return errorOf(Trouble::lockedByAnother, state.folder);
            const std::size_t before = report.volumes;
            deleteVolume(state, volume, report, blobs);
            addAuditRow(state, action, AuditKind::volume, volume,
                        static_cast<std::int64_t>(report.volumes - before));
        }
        return {};
    }));
    MACULA_TRY(const auto orphans, orphansOf(state));
    for (const BlobFiles::Entry& orphan : orphans) blobs.push_back(orphan.digest);
    removeAbandonedDrafts(state.folder);
    removeAbandonedDrafts(state.blobs.folder());
    MACULA_TRY_VOID(eraseTraces(state, blobs));
    const fs::path damagedFolder = state.folder / kDamagedName;
    std::error_code ignored;
    if (damaged == DamagedFiles::remove) fs::remove_all(damagedFolder, ignored);
    report.damagedFolders = foldersIn(damagedFolder);
    return report;
}

Result<PurgeReport> Store::purgeStudy(const std::string& study, DamagedFiles damaged) {
    MACULA_CHECK(isDigest(study));
    const std::string studies[]{study};
    return purge(studies, {}, damaged, AuditAction::deleted);
}

Result<PurgeReport> Store::purgeVolume(const std::string& volume, DamagedFiles damaged) {
    MACULA_CHECK(isDigest(volume));
    const std::string volumes[]{volume};
    return purge({}, volumes, damaged, AuditAction::deleted);
}

Result<PurgeReport> Store::purgeUnused(std::chrono::days retention, DamagedFiles damaged) {
    StoreState& state = *state_;
    Connection& connection = *state.connection;
    const std::string before = std::to_string(state.nowMs() - std::chrono::milliseconds(retention).count());
    std::vector<std::string> studies;
    std::vector<std::string> volumes;
    std::size_t skipped = 0;
    MACULA_TRY_VOID(inReading(connection, [&]() -> Result<void> {
        for (std::string& study :
             textsOf(connection, "SELECT identity FROM studies WHERE last_opened < " + before)) {
            if (isAnyOpen(state, volumesOfStudy(connection, study))) {
                ++skipped;
            } else {
                studies.push_back(std::move(study));
            }
        }
        for (std::string& volume : textsOf(
                 connection, "SELECT digest FROM volumes WHERE last_opened < " + before +
                                 " AND NOT EXISTS (SELECT 1 FROM series_volumes WHERE volume = digest)")) {
            if (isAnyOpen(state, {volume})) {
                ++skipped;
            } else {
                volumes.push_back(std::move(volume));
            }
        }
        return {};
    }));
    PurgeReport report{.damagedFolders = foldersIn(state.folder / kDamagedName)};
    if (!studies.empty() || !volumes.empty() || damaged == DamagedFiles::remove) {
        MACULA_TRY(report, purge(studies, volumes, damaged, AuditAction::expired));
    }
    report.skippedOpen = skipped;
    return report;
}

Result<VerifyReport> Store::verify(Progress& progress) {
    StoreState& state = *state_;
    VerifyReport report;
    progress.beginStage("Checking the database", 1);
    MACULA_TRY_VOID(verifyDatabase(state, report));
    progress.advance();
    MACULA_TRY(const Listing<ModelInfo> models, listModels());
    progress.beginStage("Checking stored models", models.entries.size());
    for (const ModelInfo& info : models.entries) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "The check was stopped.", {}, {}};
        progress.advance();
        if (!info.aside.empty()) continue;
        ++report.blobs;
        const auto model = readModel(info);
        const auto trouble = model ? std::nullopt : troubleOf(model.error());
        if (trouble == Trouble::modelDamaged) {
            ++report.damagedBlobs;
            ++report.setAside;
        } else if (!model && trouble != Trouble::modelGone) {
            return model.error();
        }
    }
    MACULA_TRY(const auto orphans, orphansOf(state));
    report.orphans = orphans.size();
    report.damagedFolders = foldersIn(state.folder / kDamagedName);
    return report;
}

Result<GcReport> Store::collectGarbage() {
    StoreState& state = *state_;
    removeAbandonedDrafts(state.folder);
    removeAbandonedDrafts(state.blobs.folder());
    MACULA_TRY(const auto orphans, orphansOf(state));
    GcReport report;
    std::vector<std::string> digests;
    for (const BlobFiles::Entry& orphan : orphans) {
        digests.push_back(orphan.digest);
        report.bytes += orphan.bytes;
    }
    MACULA_TRY(const bool areRemoved,
               removeBlobs(state, digests, BlobFiles::Removal::plain, state.options.patience));
    if (!areRemoved) return GcReport{};
    report.blobs = digests.size();
    return report;
}

}  // namespace macula::session
