#include "session/store_parts.h"

#include <SQLiteCpp/Column.h>

#include <algorithm>
#include <array>

namespace macula::session {

namespace {

constexpr std::array<std::string_view, 6> kActionNames{"opened",   "exported", "deleted",
                                                       "imported", "expired",  "held"};
constexpr std::array<std::string_view, 7> kAuditKindNames{"study",    "series",  "volume", "model",
                                                          "document", "picture", "store"};

}  // namespace

std::string_view nameOf(AuditAction action) {
    return kActionNames.at(static_cast<std::size_t>(action));
}
std::string_view nameOf(ClockDoubt doubt) {
    constexpr std::array<std::string_view, 3> kNames{"none", "behind", "ahead"};
    return kNames.at(static_cast<std::size_t>(doubt));
}
std::string_view nameOf(AuditKind kind) {
    return kAuditKindNames.at(static_cast<std::size_t>(kind));
}

void addAuditRow(StoreState& state, AuditAction action, AuditKind kind, const std::string& subject,
                 std::int64_t amount) {
    putRow(*state.connection, kAudit,
           {{nextId(*state.connection, kAudit), state.nowMs(), std::string(nameOf(action)),
             std::string(nameOf(kind)), subject, amount}});
}

Result<void> AuditTrail::add(AuditAction action, AuditKind kind, const std::string& subject,
                             std::int64_t amount) {
    MACULA_CHECK(subject.empty() || isDigest(subject));
    return inTransaction(*state_.connection, [&]() -> Result<void> {
        addAuditRow(state_, action, kind, subject, amount);
        return {};
    });
}

Result<Listing<AuditEntry>> AuditTrail::list(std::size_t most) {
    Connection& connection = *state_.connection;
    return guarded(connection, [&]() -> Result<Listing<AuditEntry>> {
        Listing<AuditEntry> listing;
        const std::size_t limit = std::min<std::size_t>(most, 1'000'000'000);
        SQLite::Statement statement =
            select(connection, kAudit, "ORDER BY t.id DESC LIMIT " + std::to_string(limit));
        while (statement.executeStep()) {
            const auto row = readRow(statement, kAudit);
            if (!row) {
                ++listing.damaged;
                continue;
            }
            listing.entries.push_back({row->number(column::auditId), row->number(column::auditAt),
                                       row->text(column::auditAction), row->text(column::auditKind),
                                       row->text(column::auditSubject), row->number(column::auditAmount)});
        }
        std::ranges::reverse(listing.entries);
        return listing;
    });
}

}  // namespace macula::session
