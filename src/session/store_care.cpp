#include "session/store_parts.h"

#include <SQLiteCpp/Column.h>

#include <set>

#include "base/draft.h"
#include "session/trouble.h"

namespace macula::session {

namespace fs = std::filesystem;

namespace {

// Reads all rows of a table and sets damaged models and documents aside. Rows that were set aside earlier
// count only as set aside.
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
        report.isDatabaseSound = isSound(connection.sqlite, Thoroughness::full);
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

std::size_t foldersIn(const fs::path& folder) {
    std::error_code error;
    std::size_t count = 0;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        ++count;
    return count;
}

Result<VerifyReport> StoreCare::verify(Progress& progress) {
    VerifyReport report;
    progress.beginStage(Text("Checking the database"), 1);
    MACULA_TRY_VOID(verifyDatabase(state_, report));
    progress.advance();
    MACULA_TRY(const Listing<ModelInfo> models, StoreModels(state_).list({}));
    progress.beginStage(Text("Checking stored models"), models.entries.size());
    for (const ModelInfo& info : models.entries) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("The check was stopped."), {}, {}};
        progress.advance();
        if (!info.aside.empty()) continue;
        ++report.blobs;
        const auto model = StoreModels(state_).read(info);
        const auto trouble = model ? std::nullopt : troubleOf(model.error());
        if (trouble == Trouble::modelDamaged) {
            ++report.damagedBlobs;
            ++report.setAside;
        } else if (!model && trouble != Trouble::modelGone) {
            return model.error();
        }
    }
    MACULA_TRY(const auto orphans, orphansOf(state_));
    report.orphans = orphans.size();
    report.damagedFolders = foldersIn(state_.folder / kDamagedName);
    return report;
}

Result<GcReport> StoreCare::collectGarbage() {
    removeAbandonedDrafts(state_.folder);
    removeAbandonedDrafts(state_.blobs.folder());
    MACULA_TRY(const auto orphans, orphansOf(state_));
    GcReport report;
    std::vector<std::string> digests;
    for (const BlobFiles::Entry& orphan : orphans) {
        digests.push_back(orphan.digest);
        report.bytes += orphan.bytes;
    }
    if (isPurgeBegun(state_)) MACULA_TRY_VOID(finishPurge(state_));
    MACULA_TRY(const bool areRemoved,
               removeBlobs(state_, digests, BlobFiles::Removal::plain, state_.options.patience));
    if (!areRemoved) return GcReport{};
    report.blobs = digests.size();
    return report;
}

}  // namespace macula::session
