// Rows of any table, with their checksums: shared by repository, salvage, import and verification.
#pragma once

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "session/database.h"
#include "session/row_check.h"

namespace macula::session {

struct Column {
    std::string_view name;
    bool isInteger = false;
    bool mayBeNull = false;
};

// Columns are those of the newest schema in its order, without row_check, which is the last one.
struct Table {
    std::string_view name;
    std::span<const Column> columns;
    int keyColumns = 1;  // the number of leading columns in the primary key
};

extern const Table kStudies;
extern const Table kSeries;
extern const Table kVolumes;
extern const Table kSeriesVolumes;
extern const Table kModels;
extern const Table kDocuments;
extern const Table kAudit;

// Indices of the columns.
namespace column {
enum : std::size_t { studyIdentity, studyReadable, studyFirstOpened, studyLastOpened };
enum : std::size_t { seriesIdentity, seriesStudy, seriesReadable, seriesFirstOpened, seriesLastOpened };
enum : std::size_t { volumeDigest, volumeFirstOpened, volumeLastOpened };
enum : std::size_t { linkSeries, linkVolume };
enum : std::size_t {
    modelId,
    modelKey,
    modelVolume,
    modelTrainer,
    modelParts,
    modelBytes,
    modelBlob,
    modelCreated,
    modelSaved,
    modelUsed,
    modelAside
};
enum : std::size_t {
    documentId,
    documentKind,
    documentStudy,
    documentName,
    documentVersion,
    documentJson,
    documentCreated,
    documentChanged,
    documentAside
};
enum : std::size_t { auditId, auditAt, auditAction, auditKind, auditSubject, auditAmount };
}  // namespace column

// Parents before children.
std::span<const Table* const> allTables();

// The values of a row, in the order of the table's columns.
struct Row {
    std::vector<Value> values;

    std::int64_t number(std::size_t column) const { return std::get<std::int64_t>(values[column]); }
    const std::string& text(std::size_t column) const { return std::get<std::string>(values[column]); }
    bool isNull(std::size_t column) const { return std::holds_alternative<std::monostate>(values[column]); }
    std::optional<std::string> textOrNull(std::size_t column) const;
};

// Whether the types and the checksum of its values are right.
bool isSound(const Table& table, const Row& row, std::int64_t check);

// "SELECT t.id, t.key, ..., t.row_check FROM models t REST"
SQLite::Statement select(Connection& connection, const Table& table, const std::string& rest);

// The text of a column; valid until the statement's next step.
std::string_view textOf(const SQLite::Column& column);

// Whether the current row of a statement from select() has the right types and checksum.
bool isRowSound(SQLite::Statement& statement, const Table& table);
// The current row of a statement from select(); nothing if it is damaged.
std::optional<Row> readRow(SQLite::Statement& statement, const Table& table);

// Inserts rows, or replaces those with the same primary key.
class RowWriter {
  public:
    RowWriter(Connection& connection, const Table& table);
    void put(const Row& row);

  private:
    const Table* table_;
    SQLite::Statement statement_;
};
void putRow(Connection& connection, const Table& table, const Row& row);

// An id for a new row of models, documents or audit; never one that was used before.
std::int64_t nextId(Connection& connection, const Table& table);

// Runs one statement with texts for its parameters.
void execute(Connection& connection, const std::string& sql, std::span<const std::string> texts = {});
// numberOf returns the first column of the first row, or 0 without a row; textsOf returns the first column of
// all rows.
std::int64_t numberOf(Connection& connection, const std::string& sql,
                      std::span<const std::string> texts = {});
std::vector<std::string> textsOf(Connection& connection, const std::string& sql,
                                 std::span<const std::string> texts = {});

}  // namespace macula::session
