#include "session/store_parts.h"

#include <SQLiteCpp/Column.h>

#include <algorithm>
#include <array>

#include "session/json_members.h"
#include "session/trouble.h"

namespace macula::session {

namespace {

constexpr std::size_t kMostNameBytes = 200;
constexpr std::array<std::string_view, 8> kKindNames{"preset",  "favourite", "clip",        "view",
                                                     "session", "layout",    "measurement", "calibration"};

bool isOfStudyOrMachine(const std::string& study) {
    return study.empty() || isDigest(study);
}

struct Found {
    std::optional<Row> row;
    std::optional<std::int64_t> damagedId;
};

Found findDocument(Connection& connection, const DocumentId& id) {
    SQLite::Statement statement =
        select(connection, kDocuments,
               "WHERE t.kind = ? AND coalesce(t.study, '') = ? AND t.name = ? AND t.aside IS NULL");
    statement.bind(1, std::string(nameOf(id.kind)));
    statement.bind(2, id.study);
    statement.bind(3, id.name);
    if (!statement.executeStep()) return {};
    auto row = readRow(statement, kDocuments);
    // A damaged index can lead to a row of another study.
    if (row && row->text(column::documentKind) == nameOf(id.kind) &&
        row->textOrNull(column::documentStudy).value_or("") == id.study &&
        row->text(column::documentName) == id.name)
        return {.row = std::move(row)};
    return {.damagedId = statement.getColumn(0).getInt64()};
}

DocumentEntry entryOf(const DocumentId& id, const Row& row) {
    return {.id = id,
            .version = row.number(column::documentVersion),
            .createdMs = row.number(column::documentCreated),
            .changedMs = row.number(column::documentChanged)};
}

}  // namespace

std::string_view nameOf(DocumentKind kind) {
    return kKindNames.at(static_cast<std::size_t>(kind));
}

bool isOfVolume(const DocumentId& id) {
    const bool isOfAStudy = id.kind == DocumentKind::studyState || id.kind == DocumentKind::view ||
                            id.kind == DocumentKind::layout || id.kind == DocumentKind::measurement;
    constexpr std::size_t kDigestLength = 64;
    return isOfAStudy && id.study.empty() && id.name.size() > kDigestLength &&
           id.name[kDigestLength] == ' ' && isDigest(std::string_view(id.name).substr(0, kDigestLength));
}

Result<void> StoreDocuments::change(const DocumentId& id, std::int64_t version,
                                    const Store::DocumentEdit& edit,
                                    std::span<const std::string_view> known) {
    MACULA_CHECK(isOfStudyOrMachine(id.study));
    Connection& connection = *state_.connection;
    if (id.name.empty() || id.name.size() > kMostNameBytes)
        return errorOf(Trouble::documentInvalid, state_.folder);
    return inTransaction(connection, [&]() -> Result<void> {
        const std::int64_t now = state_.nowMs();
        const Found before = findDocument(connection, id);
        std::optional<std::string> stored;
        if (before.row) stored = before.row->text(column::documentJson);
        std::string text = edit(stored);
        if (!isDocument(text)) return errorOf(Trouble::documentInvalid, state_.folder);
        if (!id.study.empty()) rememberStudy(connection, id.study, now);
        if (before.damagedId) setRowAside(connection, kDocuments, *before.damagedId);
        if (stored) text = withUnknownMembers(text, *stored, known);
        if (text.size() > kMostJsonBytes) return errorOf(Trouble::documentInvalid, state_.folder);
        putRow(connection, kDocuments,
               {{before.row ? before.row->number(column::documentId) : nextId(connection, kDocuments),
                 std::string(nameOf(id.kind)), id.study.empty() ? Value() : Value(id.study), id.name, version,
                 std::move(text), before.row ? before.row->number(column::documentCreated) : now, now,
                 Value()}});
        return {};
    });
}

Result<std::optional<Document>> StoreDocuments::get(const DocumentId& id) {
    MACULA_CHECK(isOfStudyOrMachine(id.study));
    Connection& connection = *state_.connection;
    MACULA_TRY(const Found found,
               guarded(connection, [&]() -> Result<Found> { return findDocument(connection, id); }));
    if (found.row)
        return std::optional(Document{entryOf(id, *found.row), found.row->text(column::documentJson)});
    if (!found.damagedId) return std::optional<Document>();
    MACULA_TRY_VOID(inTransaction(connection, [&]() -> Result<void> {
        if (const Found again = findDocument(connection, id); again.damagedId)
            setRowAside(connection, kDocuments, *again.damagedId);
        return {};
    }));
    return errorOf(Trouble::documentDamaged, state_.folder);
}

Result<Listing<DocumentEntry>> StoreDocuments::list(DocumentKind kind, const std::string& study) {
    MACULA_CHECK(isOfStudyOrMachine(study));
    Connection& connection = *state_.connection;
    return guarded(connection, [&]() -> Result<Listing<DocumentEntry>> {
        Listing<DocumentEntry> listing;
        SQLite::Statement statement = select(
            connection, kDocuments,
            "WHERE t.kind = ? AND coalesce(t.study, '') = ? AND t.aside IS NULL ORDER BY t.name, t.id");
        statement.bind(1, std::string(nameOf(kind)));
        statement.bind(2, study);
        while (statement.executeStep()) {
            const auto row = readRow(statement, kDocuments);
            if (row && row->text(column::documentKind) == nameOf(kind) &&
                row->textOrNull(column::documentStudy).value_or("") == study) {
                listing.entries.push_back(entryOf({kind, study, row->text(column::documentName)}, *row));
            } else {
                ++listing.damaged;
            }
        }
        return listing;
    });
}

Result<bool> StoreDocuments::remove(const DocumentId& id) {
    MACULA_CHECK(isOfStudyOrMachine(id.study));
    Connection& connection = *state_.connection;
    return inTransaction(connection, [&]() -> Result<bool> {
        const Found found = findDocument(connection, id);
        if (!found.row && !found.damagedId) return false;
        const std::int64_t row = found.row ? found.row->number(column::documentId) : *found.damagedId;
        execute(connection, "DELETE FROM documents WHERE id = " + std::to_string(row));
        addAuditRow(state_, AuditAction::deleted, AuditKind::document, id.study, 1);
        return true;
    });
}

}  // namespace macula::session
