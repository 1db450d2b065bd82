#include "session/store_parts.h"

#include <SQLiteCpp/Column.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/check.h"
#include "session/age_clock.h"

namespace macula::session {

namespace {

// Points into a list that neither grows nor moves. The keys are views, so that looking up a column's text
// copies nothing.
using EntriesByStudy = std::unordered_map<std::string_view, StudyEntry*>;
EntriesByStudy byStudy(std::vector<StudyEntry>& entries) {
    EntriesByStudy found;
    found.reserve(entries.size());
    for (StudyEntry& entry : entries) found.emplace(entry.identity, &entry);
    return found;
}

// `sql` selects studies, and a number for each.
void putCounts(Connection& connection, const std::string& sql, const EntriesByStudy& entries,
               std::size_t StudyEntry::*count) {
    SQLite::Statement statement(connection.sqlite, sql);
    while (statement.executeStep()) {
        const auto found = entries.find(textOf(statement.getColumn(0)));
        if (found != entries.end())
            found->second->*count = static_cast<std::size_t>(statement.getColumn(1).getInt64());
    }
}

// Adds the models of each study. Their sizes come from rows with a valid checksum.
void putModels(Connection& connection, const EntriesByStudy& entries) {
    struct Share {
        std::size_t models = 0;
        std::uint64_t bytes = 0;
        std::vector<const StudyEntry*> given;  // two series of a study may have the same volume
    };
    std::unordered_map<std::string, Share> ofVolume;
    SQLite::Statement models = select(connection, kModels, "WHERE t.aside IS NULL");
    while (models.executeStep()) {
        if (!isRowSound(models, kModels)) continue;
        Share& share = ofVolume[models.getColumn(int{column::modelVolume}).getString()];
        ++share.models;
        share.bytes += static_cast<std::uint64_t>(models.getColumn(int{column::modelBytes}).getInt64());
    }
    SQLite::Statement links(connection.sqlite,
                            "SELECT s.study, v.volume FROM (SELECT DISTINCT volume FROM models WHERE aside "
                            "IS NULL) m JOIN series_volumes v ON v.volume = m.volume JOIN series s ON "
                            "s.identity = v.series");
    while (links.executeStep()) {
        const auto entry = entries.find(textOf(links.getColumn(0)));
        const auto found = ofVolume.find(links.getColumn(1).getString());
        if (entry == entries.end() || found == ofVolume.end()) continue;
        StudyEntry& study = *entry->second;
        Share& share = found->second;
        if (std::ranges::find(share.given, &study) != share.given.end()) continue;
        share.given.push_back(&study);
        study.models += share.models;
        study.modelBytes += share.bytes;
    }
}

Value valueOf(const std::optional<std::string>& text) {
    return text ? Value(*text) : Value();
}

struct Opened {
    std::int64_t firstMs;
    std::int64_t lastMs;
};

// Keeps the time of the first opening; the last opening never becomes earlier, whatever the clock shows now.
Opened openedAt(Connection& connection, const Table& table, const std::string& identity, std::size_t first,
                std::size_t last, std::int64_t nowMs) {
    const auto before = findRow(connection, table, identity);
    if (!before) return {nowMs, nowMs};
    return {before->number(first), std::max(before->number(last), nowMs)};
}

void putOpened(StoreState& state, const OpenedVolume& opened) {
    Connection& connection = *state.connection;
    const std::int64_t now = openingMs(state);
    rememberVolume(connection, opened.volume, now);
    if (opened.study.empty()) {
        addAuditRow(state, AuditAction::opened, AuditKind::volume, opened.volume, 1);
        return;
    }
    const Opened study =
        openedAt(connection, kStudies, opened.study, column::studyFirstOpened, column::studyLastOpened, now);
    putRow(connection, kStudies,
           {{opened.study, valueOf(opened.readableStudy), study.firstMs, study.lastMs}});
    const Opened series = openedAt(connection, kSeries, opened.series, column::seriesFirstOpened,
                                   column::seriesLastOpened, now);
    putRow(connection, kSeries,
           {{opened.series, opened.study, valueOf(opened.readableSeries), series.firstMs, series.lastMs}});
    putRow(connection, kSeriesVolumes, {{opened.series, opened.volume}});
    addAuditRow(state, AuditAction::opened, AuditKind::study, opened.study, 1);
}

// The row must be sound.
StudyEntry studyAt(SQLite::Statement& statement) {
    const SQLite::Column readable = statement.getColumn(int{column::studyReadable});
    StudyEntry entry{.identity = statement.getColumn(int{column::studyIdentity}).getString(),
                     .firstOpenedMs = statement.getColumn(int{column::studyFirstOpened}).getInt64(),
                     .lastOpenedMs = statement.getColumn(int{column::studyLastOpened}).getInt64()};
    if (readable.isText()) entry.readable = readable.getString();
    return entry;
}

std::vector<std::string> volumesOf(Connection& connection, const std::string& series, std::size_t& damaged) {
    std::vector<std::string> volumes;
    SQLite::Statement links = select(connection, kSeriesVolumes, "WHERE t.series = ? ORDER BY t.volume");
    links.bind(1, series);
    while (links.executeStep()) {
        const auto row = readRow(links, kSeriesVolumes);
        if (row && row->text(column::linkSeries) == series) {
            volumes.push_back(row->text(column::linkVolume));
        } else {
            ++damaged;
        }
    }
    return volumes;
}

}  // namespace

Result<void> StoreStudies::recordOpened(const OpenedVolume& opened) {
    MACULA_CHECK(isDigest(opened.volume));
    MACULA_CHECK((isDigest(opened.study) && isDigest(opened.series)) ||
                 (opened.study.empty() && opened.series.empty()));
    return inTransaction(*state_.connection, [&]() -> Result<void> {
        putOpened(state_, opened);
        return {};
    });
}

Result<Listing<StudyEntry>> StoreStudies::list() {
    Connection& connection = *state_.connection;
    return inReading(connection, [&]() -> Result<Listing<StudyEntry>> {
        Listing<StudyEntry> listing;
        SQLite::Statement statement = select(connection, kStudies, "");
        while (statement.executeStep()) {
            if (isRowSound(statement, kStudies)) {
                listing.entries.push_back(studyAt(statement));
            } else {
                ++listing.damaged;
            }
        }
        const EntriesByStudy entries = byStudy(listing.entries);
        putCounts(connection, "SELECT study, count(*) FROM series GROUP BY study", entries,
                  &StudyEntry::series);
        putCounts(connection,
                  "SELECT study, count(*) FROM documents WHERE study IS NOT NULL AND aside IS NULL GROUP BY "
                  "study",
                  entries, &StudyEntry::documents);
        putModels(connection, entries);
        std::ranges::stable_sort(listing.entries, std::greater(), &StudyEntry::lastOpenedMs);
        return listing;
    });
}

Result<Listing<SeriesEntry>> StoreStudies::listSeries(const std::string& study) {
    MACULA_CHECK(isDigest(study));
    Connection& connection = *state_.connection;
    return inReading(connection, [&]() -> Result<Listing<SeriesEntry>> {
        Listing<SeriesEntry> listing;
        SQLite::Statement statement =
            select(connection, kSeries, "WHERE t.study = ? ORDER BY t.last_opened DESC, t.identity");
        statement.bind(1, study);
        while (statement.executeStep()) {
            const auto row = readRow(statement, kSeries);
            // A damaged index can lead to a row of another study.
            if (!row || row->text(column::seriesStudy) != study) {
                ++listing.damaged;
                continue;
            }
            const std::string& identity = row->text(column::seriesIdentity);
            listing.entries.push_back(
                {identity, row->textOrNull(column::seriesReadable), row->number(column::seriesFirstOpened),
                 row->number(column::seriesLastOpened), volumesOf(connection, identity, listing.damaged)});
        }
        return listing;
    });
}

}  // namespace macula::session
