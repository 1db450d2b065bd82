// Merges single rows into the database, from this store, a damaged file or another store.
#include <SQLiteCpp/Column.h>

#include <algorithm>

#include "session/json_members.h"
#include "session/store_state.h"

namespace macula::session {

namespace {

using namespace column;

// Merges two rows of the same study, series or volume: keeps the earlier first and the later last opening.
bool mergeOpened(Connection& connection, const Table& table, const Row& row, std::size_t first,
                 std::size_t last) {
    auto before = findRow(connection, table, row.text(0));
    if (!before) {
        putRow(connection, table, row);
        return true;
    }
    const bool isNewer = row.number(last) > before->number(last);
    Row merged = isNewer ? row : *before;
    merged.values[first] = std::min(row.number(first), before->number(first));
    putRow(connection, table, merged);
    return isNewer;
}

// The existing row with the same key. Sets a damaged one aside, because nothing is known about it.
std::optional<Row> standing(Connection& connection, const Table& table, SQLite::Statement statement) {
    if (!statement.executeStep()) return {};
    auto row = readRow(statement, table);
    const std::int64_t id = statement.getColumn(0).getInt64();
    statement.reset();
    if (!row) setRowAside(connection, table, id);
    return row;
}

bool mergeById(Connection& connection, const Table& table, Row row, const std::optional<Row>& before,
               std::size_t time) {
    if (before && before->number(time) >= row.number(time)) return false;
    row.values[0] = before ? before->number(0) : nextId(connection, table);
    putRow(connection, table, row);
    return true;
}

bool mergeModel(Connection& connection, const Row& row) {
    if (!modelOf(row)) return false;
    rememberVolume(connection, row.text(modelVolume), row.number(modelCreated));
    if (!row.isNull(modelAside)) return mergeById(connection, kModels, row, {}, modelSaved);
    SQLite::Statement same = select(connection, kModels, "WHERE t.key = ? AND t.aside IS NULL");
    same.bind(1, row.text(modelKey));
    return mergeById(connection, kModels, row, standing(connection, kModels, std::move(same)), modelSaved);
}

bool mergeDocument(Connection& connection, const Row& row) {
    if (!isDocument(row.text(documentJson))) return false;
    if (!row.isNull(documentStudy) && !isDigest(row.text(documentStudy))) return false;
    if (!row.isNull(documentStudy))
        rememberStudy(connection, row.text(documentStudy), row.number(documentCreated));
    if (!row.isNull(documentAside)) return mergeById(connection, kDocuments, row, {}, documentChanged);
    SQLite::Statement same =
        select(connection, kDocuments,
               "WHERE t.kind = ? AND coalesce(t.study, '') = ? AND t.name = ? AND t.aside IS NULL");
    same.bind(1, row.text(documentKind));
    same.bind(2, row.textOrNull(documentStudy).value_or(""));
    same.bind(3, row.text(documentName));
    return mergeById(connection, kDocuments, row, standing(connection, kDocuments, std::move(same)),
                     documentChanged);
}

bool mergeLink(Connection& connection, const Row& row) {
    // Without its series row, the study of the link is unknown.
    if (!findRow(connection, kSeries, row.text(linkSeries))) return false;
    if (!findRow(connection, kVolumes, row.text(linkVolume))) return false;
    putRow(connection, kSeriesVolumes, row);
    return true;
}

bool mergeAudit(Connection& connection, const Row& row) {
    if (numberOf(connection, "SELECT count(*) FROM audit WHERE id = " + std::to_string(row.number(auditId))))
        return false;
    putRow(connection, kAudit, row);
    return true;
}

}  // namespace

std::optional<Row> findRow(Connection& connection, const Table& table, const std::string& key) {
    const std::string name(table.columns.front().name);
    SQLite::Statement statement = select(connection, table, "WHERE t." + name + " = ?");
    statement.bind(1, key);
    if (!statement.executeStep()) return {};
    auto row = readRow(statement, table);
    return row && row->text(0) == key ? row : std::nullopt;
}

void rememberStudy(Connection& connection, const std::string& identity, std::int64_t atMs) {
    if (!findRow(connection, kStudies, identity))
        putRow(connection, kStudies, {{identity, Value(), atMs, atMs}});
}

void rememberVolume(Connection& connection, const std::string& digest, std::int64_t atMs) {
    mergeOpened(connection, kVolumes, {{digest, atMs, atMs}}, volumeFirstOpened, volumeLastOpened);
}

void setRowAside(Connection& connection, const Table& table, std::int64_t id) {
    execute(connection,
            "UPDATE " + std::string(table.name) + " SET aside = 'row' WHERE id = " + std::to_string(id));
}

bool mergeRow(Connection& connection, const Table& table, const Row& row) {
    // An import may come from anybody, so an identity that is not a SHA-256 is refused.
    const bool isNamed = !table.columns.front().isInteger;
    if (isNamed && !isDigest(row.text(0))) return false;
    if (&table == &kStudies) return mergeOpened(connection, table, row, studyFirstOpened, studyLastOpened);
    if (&table == &kVolumes) return mergeOpened(connection, table, row, volumeFirstOpened, volumeLastOpened);
    if (&table == &kSeries) {
        if (!isDigest(row.text(seriesStudy))) return false;
        rememberStudy(connection, row.text(seriesStudy), row.number(seriesFirstOpened));
        const auto before = findRow(connection, table, row.text(column::seriesIdentity));
        if (before && before->text(seriesStudy) != row.text(seriesStudy)) return false;
        return mergeOpened(connection, table, row, seriesFirstOpened, seriesLastOpened);
    }
    if (&table == &kSeriesVolumes) return mergeLink(connection, row);
    if (&table == &kModels) return mergeModel(connection, row);
    if (&table == &kDocuments) return mergeDocument(connection, row);
    MACULA_CHECK(&table == &kAudit);
    return mergeAudit(connection, row);
}

}  // namespace macula::session
