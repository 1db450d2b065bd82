#include "session/store_parts.h"

#include <SQLiteCpp/Column.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <limits>

#include "base/draft.h"
#include "session/age_clock.h"
#include "session/model_key.h"
#include "session/trouble.h"

namespace macula::session {

namespace fs = std::filesystem;

namespace {

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

// SQL for documents that belong to volumes without a study, and for the digest of their volume
// (DocumentId::name).
constexpr std::string_view kAreOfVolumes =
    "study IS NULL AND kind IN ('view', 'session', 'layout', 'measurement') AND substr(name, 65, 1) = ' '";
constexpr std::string_view kTheirVolume = "substr(name, 1, 64)";

// Keeps a volume that some study still has.
void deleteVolume(StoreState& state, const std::string& volume, PurgeReport& report) {
    Connection& connection = *state.connection;
    const std::string texts[]{volume};
    if (numberOf(connection, "SELECT count(*) FROM series_volumes WHERE volume = ?", texts) > 0) return;
    report.models +=
        static_cast<std::size_t>(numberOf(connection, "SELECT count(*) FROM models WHERE volume = ?", texts));
    report.volumes += static_cast<std::size_t>(
        numberOf(connection, "SELECT count(*) FROM volumes WHERE digest = ?", texts));
    const std::string documents =
        fmt::format("FROM documents WHERE {} AND {} = ?", kAreOfVolumes, kTheirVolume);
    report.documents += static_cast<std::size_t>(numberOf(connection, "SELECT count(*) " + documents, texts));
    execute(connection, "DELETE " + documents, texts);
    execute(connection, "DELETE FROM volumes WHERE digest = ?", texts);
}

void deleteStudy(StoreState& state, const std::string& study, PurgeReport& report) {
    Connection& connection = *state.connection;
    const std::string texts[]{study};
    const auto volumes = volumesOfStudy(connection, study);
    report.documents += static_cast<std::size_t>(
        numberOf(connection, "SELECT count(*) FROM documents WHERE study = ?", texts));
    report.studies += static_cast<std::size_t>(
        numberOf(connection, "SELECT count(*) FROM studies WHERE identity = ?", texts));
    execute(connection, "DELETE FROM studies WHERE identity = ?", texts);
    for (const std::string& volume : volumes) deleteVolume(state, volume, report);
}

// Unallocated bytes of pages can hold rows that were moved before they were deleted: rewriting the file
// leaves none. SQLite's temporary copy is in memory.
Result<void> compact(StoreState& state) {
    return guarded(*state.connection, [&]() -> Result<void> {
        state.connection->sqlite.exec("VACUUM");
        return {};
    });
}

fs::path purgeFile(const StoreState& state) {
    return state.folder / kPurgeName;
}

Result<void> beginPurge(const StoreState& state) {
    const fs::path file = purgeFile(state);
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (descriptor < 0) return errorOf(troubleOfErrno(errno), file);
    close(descriptor);
    return syncToDisk(state.folder);
}

// Nobody can tell to which study a damaged row belongs.
void deleteDamagedRows(StoreState& state, PurgeReport& report) {
    for (const Table* table : {&kModels, &kDocuments}) {
        std::vector<std::string> damaged;
        SQLite::Statement statement = select(*state.connection, *table, "");
        while (statement.executeStep()) {
            const auto row = readRow(statement, *table);
            if (!row || (table == &kModels && !modelOf(*row)))
                damaged.push_back(statement.getColumn(0).getString());
        }
        for (const std::string& id : damaged)
            execute(*state.connection, "DELETE FROM " + std::string(table->name) + " WHERE id = " + id);
        (table == &kModels ? report.models : report.documents) += damaged.size();
    }
}

Result<void> eraseDamagedFiles(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_regular_file(error)) files.push_back(entry->path());
    for (const fs::path& file : files) MACULA_TRY_VOID(eraseFile(file));
    fs::remove_all(folder, error);
    if (error) return errorOf(troubleOfErrno(error.value()), folder);
    return {};
}

struct Targets {
    std::vector<std::string> studies;
    std::vector<std::string> volumes;
    std::size_t skippedOpen = 0;
    ClockDoubt clock = ClockDoubt::none;
};

Result<void> deleteTargets(StoreState& state, const Targets& targets, AuditAction action,
                           PurgeReport& report) {
    Error isOpen = errorOf(Trouble::lockedByAnother, state.folder);
    for (const std::string& study : targets.studies) {
        if (isAnyOpen(state, volumesOfStudy(*state.connection, study))) return isOpen;
        const std::size_t before = report.studies;
        deleteStudy(state, study, report);
        addAuditRow(state, action, AuditKind::study, study,
                    static_cast<std::int64_t>(report.studies - before));
    }
    for (const std::string& volume : targets.volumes) {
        if (isAnyOpen(state, {volume})) return isOpen;
        const std::size_t before = report.volumes;
        deleteVolume(state, volume, report);
        addAuditRow(state, action, AuditKind::volume, volume,
                    static_cast<std::int64_t>(report.volumes - before));
    }
    return {};
}

// Finds the targets in the transaction that deletes them, so that nothing opened meanwhile is among them.
Result<PurgeReport> purge(StoreState& state, const std::function<Targets()>& targetsNow, DamagedFiles damaged,
                          AuditAction action) {
    const fs::path damagedFolder = state.folder / kDamagedName;
    PurgeReport report;
    MACULA_TRY(const bool hasTraces, inTransaction(*state.connection, [&]() -> Result<bool> {
                   const Targets targets = targetsNow();
                   report.skippedOpen = targets.skippedOpen;
                   report.clock = targets.clock;
                   if (targets.studies.empty() && targets.volumes.empty() && damaged == DamagedFiles::keep)
                       return isPurgeBegun(state);
                   MACULA_TRY_VOID(beginPurge(state));
                   MACULA_TRY_VOID(deleteTargets(state, targets, action, report));
                   if (damaged == DamagedFiles::remove) deleteDamagedRows(state, report);
                   return true;
               }));
    if (hasTraces) MACULA_TRY_VOID(finishPurge(state));
    if (damaged == DamagedFiles::remove) MACULA_TRY_VOID(eraseDamagedFiles(damagedFolder));
    report.damagedFolders = foldersIn(damagedFolder);
    return report;
}

// Volumes that have documents but no row: earlier versions deleted volumes without their documents. `before`
// is an SQL comparison for the time of change.
std::vector<std::string> volumesOfDocumentsAlone(Connection& connection, const std::string& before) {
    std::vector<std::string> volumes = textsOf(
        connection,
        fmt::format(
            "SELECT DISTINCT {0} FROM documents WHERE {1} AND changed{2} AND {0} NOT IN (SELECT digest "
            "FROM volumes)",
            kTheirVolume, kAreOfVolumes, before));
    std::erase_if(volumes, [](const std::string& volume) { return !isDigest(volume); });
    return volumes;
}

Targets unusedSince(StoreState& state, std::int64_t timeMs) {
    Connection& connection = *state.connection;
    const std::string before = " < " + std::to_string(timeMs);
    Targets targets;
    for (std::string& study :
         textsOf(connection, "SELECT identity FROM studies WHERE last_opened" + before)) {
        const bool isOpen = isAnyOpen(state, volumesOfStudy(connection, study));
        targets.skippedOpen += isOpen ? 1 : 0;
        if (!isOpen) targets.studies.push_back(std::move(study));
    }
    for (std::string& volume :
         textsOf(connection, "SELECT digest FROM volumes WHERE last_opened" + before +
                                 " AND NOT EXISTS (SELECT 1 FROM series_volumes WHERE volume = digest)")) {
        const bool isOpen = isAnyOpen(state, {volume});
        targets.skippedOpen += isOpen ? 1 : 0;
        if (!isOpen) targets.volumes.push_back(std::move(volume));
    }
    for (std::string& volume : volumesOfDocumentsAlone(connection, before))
        targets.volumes.push_back(std::move(volume));
    return targets;
}

// The studies and volumes that are old by the clock, as far as it is trusted.
Targets unusedFor(StoreState& state, std::chrono::days retention) {
    const AgeClock clock = ageClock(state, retention);
    if (clock.doubt != ClockDoubt::none && !clock.isOnTheTrail)
        addAuditRow(state, AuditAction::held, AuditKind::store, {}, 1);
    if (!clock.countsToMs) return {.clock = clock.doubt};
    Targets targets = unusedSince(state, *clock.countsToMs - std::chrono::milliseconds(retention).count());
    targets.clock = clock.doubt;
    return targets;
}

}  // namespace

bool isPurgeBegun(const StoreState& state) {
    std::error_code error;
    return fs::exists(purgeFile(state), error) || error;
}

Result<void> finishPurge(StoreState& state) {
    Error incomplete = errorOf(Trouble::purgeIncomplete, state.folder);
    removeAbandonedDrafts(state.folder);
    removeAbandonedDrafts(state.blobs.folder());
    MACULA_TRY(const auto orphans, orphansOf(state));
    std::vector<std::string> blobs;
    for (const BlobFiles::Entry& orphan : orphans) blobs.push_back(orphan.digest);
    MACULA_TRY(const bool areRemoved,
               removeBlobs(state, blobs, BlobFiles::Removal::overwritten, state.options.patience));
    auto compacted = compact(state);
    if (!compacted && troubleOf(compacted.error()) == Trouble::lockedByAnother) return incomplete;
    if (!compacted) return compacted;
    if (!areRemoved) return incomplete;
    return eraseFile(purgeFile(state));
}

Result<PurgeReport> StorePurge::study(const std::string& study, DamagedFiles damaged) {
    MACULA_CHECK(isDigest(study));
    return purge(
        state_, [&] { return Targets{.studies = {study}}; }, damaged, AuditAction::deleted);
}

Result<PurgeReport> StorePurge::volume(const std::string& volume, DamagedFiles damaged) {
    MACULA_CHECK(isDigest(volume));
    return purge(
        state_, [&] { return Targets{.volumes = {volume}}; }, damaged, AuditAction::deleted);
}

Result<PurgeReport> StorePurge::unused(std::chrono::days retention, DamagedFiles damaged,
                                       Store::Clock clock) {
    MACULA_CHECK(retention.count() >= 0);
    const auto byTheClock = [&] {
        setOpeningsToTheClock(state_);
        return unusedSince(state_, state_.nowMs() - std::chrono::milliseconds(retention).count());
    };
    return purge(
        state_, [&] { return clock == Store::Clock::trusted ? byTheClock() : unusedFor(state_, retention); },
        damaged, AuditAction::expired);
}

Result<ClockDoubt> StorePurge::clockDoubt(std::chrono::days retention) {
    return inReading(*state_.connection,
                     [&]() -> Result<ClockDoubt> { return ageClock(state_, retention).doubt; });
}

Result<PurgeReport> StorePurge::all(DamagedFiles damaged) {
    return purge(
        state_, [&] { return unusedSince(state_, std::numeric_limits<std::int64_t>::max()); }, damaged,
        AuditAction::deleted);
}

}  // namespace macula::session
