#include "session/rows.h"

#include <limits>

namespace macula::session {

namespace {

constexpr bool kInteger = true;
constexpr bool kNullable = true;

constexpr Column kStudyColumns[]{
    {"identity"}, {"readable", false, kNullable}, {"first_opened", kInteger}, {"last_opened", kInteger}};
constexpr Column kSeriesColumns[]{{"identity"},
                                  {"study"},
                                  {"readable", false, kNullable},
                                  {"first_opened", kInteger},
                                  {"last_opened", kInteger}};
constexpr Column kVolumeColumns[]{{"digest"}, {"first_opened", kInteger}, {"last_opened", kInteger}};
constexpr Column kSeriesVolumeColumns[]{{"series"}, {"volume"}};
constexpr Column kModelColumns[]{{"id", kInteger},
                                 {"key"},
                                 {"volume"},
                                 {"trainer", kInteger},
                                 {"parts"},
                                 {"bytes", kInteger},
                                 {"blob"},
                                 {"created", kInteger},
                                 {"saved", kInteger},
                                 {"used", kInteger},
                                 {"aside", false, kNullable}};
constexpr Column kDocumentColumns[]{
    {"id", kInteger},           {"kind"}, {"study", false, kNullable}, {"name"},
    {"version", kInteger},      {"json"}, {"created", kInteger},       {"changed", kInteger},
    {"aside", false, kNullable}};
constexpr Column kAuditColumns[]{{"id", kInteger}, {"at", kInteger}, {"action"},
                                 {"kind"},         {"subject"},      {"amount", kInteger}};

std::string listOf(const Table& table, std::string_view before) {
    std::string list;
    for (const Column& column : table.columns) list.append(before).append(column.name).append(", ");
    return list.append(before).append("row_check");
}

void bindValue(SQLite::Statement& statement, int index, const Value& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value)) {
        statement.bind(index, *number);
    } else if (const auto* text = std::get_if<std::string>(&value)) {
        statement.bind(index, *text);
    } else {
        statement.bind(index);
    }
}

// Inserts, or changes the row with the same primary key.
std::string sqlOf(const Table& table) {
    std::string places;
    std::string changes;
    std::string key;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string name(table.columns[i].name);
        places += "?, ";
        if (i < static_cast<std::size_t>(table.keyColumns)) {
            if (!key.empty()) key += ", ";
            key += name;
        } else {
            changes.append(name).append(" = excluded.").append(name).append(", ");
        }
    }
    return "INSERT INTO " + std::string(table.name) + " (" + listOf(table, "") + ") VALUES (" + places +
           "?) ON CONFLICT (" + key + ") DO UPDATE SET " + changes + "row_check = excluded.row_check";
}

void bindTexts(SQLite::Statement& statement, std::span<const std::string> texts) {
    for (int i = 0; i < static_cast<int>(texts.size()); ++i)
        statement.bind(i + 1, texts[static_cast<std::size_t>(i)]);
}

}  // namespace

const Table kStudies{"studies", kStudyColumns};
const Table kSeries{"series", kSeriesColumns};
const Table kVolumes{"volumes", kVolumeColumns};
const Table kSeriesVolumes{"series_volumes", kSeriesVolumeColumns, 2};
const Table kModels{"models", kModelColumns};
const Table kDocuments{"documents", kDocumentColumns};
const Table kAudit{"audit", kAuditColumns};

std::span<const Table* const> allTables() {
    static constexpr const Table* kAll[]{&kStudies, &kSeries,    &kVolumes, &kSeriesVolumes,
                                         &kModels,  &kDocuments, &kAudit};
    return kAll;
}

std::optional<std::string> Row::textOrNull(std::size_t column) const {
    if (isNull(column)) return {};
    return text(column);
}

bool isSound(const Table& table, const Row& row, std::int64_t check) {
    if (row.values.size() != table.columns.size()) return false;
    for (std::size_t i = 0; i < row.values.size(); ++i) {
        const Column& column = table.columns[i];
        if (row.isNull(i)) {
            if (!column.mayBeNull) return false;
        } else if (std::holds_alternative<std::int64_t>(row.values[i]) != column.isInteger) {
            return false;
        }
    }
    return rowCheck(table.name, row.values) == check;
}

SQLite::Statement select(Connection& connection, const Table& table, const std::string& rest) {
    return {connection.sqlite,
            "SELECT " + listOf(table, "t.") + " FROM " + std::string(table.name) + " t " + rest};
}

std::string_view textOf(const SQLite::Column& column) {
    return {static_cast<const char*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())};
}

bool isRowSound(SQLite::Statement& statement, const Table& table) {
    RowSum sum(table.name);
    int place = 0;
    for (const Column& wanted : table.columns) {
        const SQLite::Column column = statement.getColumn(place++);
        const int type = column.getType();
        if (type == SQLite::INTEGER && wanted.isInteger) {
            sum.add(std::int64_t{column.getInt64()});
        } else if (type == SQLite::TEXT && !wanted.isInteger) {
            sum.add(textOf(column));
        } else if (type == SQLite::Null && wanted.mayBeNull) {
            sum.addNull();
        } else {
            return false;
        }
    }
    const SQLite::Column check = statement.getColumn(place);
    return check.isInteger() && check.getInt64() == sum.value();
}

std::optional<Row> readRow(SQLite::Statement& statement, const Table& table) {
    if (!isRowSound(statement, table)) return {};
    Row row;
    row.values.reserve(table.columns.size());
    for (int i = 0; i < static_cast<int>(table.columns.size()); ++i) {
        const SQLite::Column column = statement.getColumn(i);
        if (column.isInteger()) {
            row.values.emplace_back(std::int64_t{column.getInt64()});
        } else if (column.isText()) {
            row.values.emplace_back(std::string(textOf(column)));
        } else {
            row.values.emplace_back();
        }
    }
    return row;
}

RowWriter::RowWriter(Connection& connection, const Table& table)
    : table_(&table), statement_(connection.sqlite, sqlOf(table)) {}

void RowWriter::put(const Row& row) {
    MACULA_CHECK_EQ(row.values.size(), table_->columns.size());
    int index = 0;
    for (const Value& value : row.values) bindValue(statement_, ++index, value);
    statement_.bind(++index, rowCheck(table_->name, row.values));
    statement_.exec();
    statement_.reset();
}

void putRow(Connection& connection, const Table& table, const Row& row) {
    RowWriter(connection, table).put(row);
}

std::int64_t nextId(Connection& connection, const Table& table) {
    const std::string name(table.name);
    const std::int64_t last = numberOf(
        connection, "SELECT max(coalesce((SELECT max(id) FROM " + name +
                        "), 0), coalesce((SELECT seq FROM sqlite_sequence WHERE name = '" + name + "'), 0))");
    if (last < 0 || last == std::numeric_limits<std::int64_t>::max())
        throw SQLite::Exception("no number is left", 11);  // SQLITE_CORRUPT
    return last + 1;
}

void execute(Connection& connection, const std::string& sql, std::span<const std::string> texts) {
    SQLite::Statement statement(connection.sqlite, sql);
    bindTexts(statement, texts);
    statement.exec();
}

std::int64_t numberOf(Connection& connection, const std::string& sql, std::span<const std::string> texts) {
    SQLite::Statement statement(connection.sqlite, sql);
    bindTexts(statement, texts);
    return statement.executeStep() ? statement.getColumn(0).getInt64() : 0;
}

std::vector<std::string> textsOf(Connection& connection, const std::string& sql,
                                 std::span<const std::string> texts) {
    std::vector<std::string> found;
    SQLite::Statement statement(connection.sqlite, sql);
    bindTexts(statement, texts);
    while (statement.executeStep()) found.push_back(statement.getColumn(0).getString());
    return found;
}

}  // namespace macula::session
