#include "session/age_clock.h"

#include <SQLiteCpp/Column.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <vector>

namespace macula::session {

namespace {

using std::chrono::milliseconds;

constexpr std::int64_t kHourMs = milliseconds(std::chrono::hours(1)).count();
constexpr std::int64_t kDayMs = milliseconds(std::chrono::days(1)).count();
constexpr std::int64_t kNoEnd = std::numeric_limits<std::int64_t>::max();

// The columns of a table with the first and the last opening.
struct Opening {
    const Table* table;
    std::size_t first;
    std::size_t last;
};
constexpr std::array kOpenings{Opening{&kStudies, column::studyFirstOpened, column::studyLastOpened},
                               Opening{&kSeries, column::seriesFirstOpened, column::seriesLastOpened},
                               Opening{&kVolumes, column::volumeFirstOpened, column::volumeLastOpened}};

// The newest time below a bound in a sound row. `select` must sort by that time, newest first.
std::optional<std::int64_t> newestOf(SQLite::Statement statement, const Table& table, std::size_t time,
                                     std::int64_t belowMs) {
    statement.bind(1, belowMs);
    while (statement.executeStep())
        if (isRowSound(statement, table)) return statement.getColumn(static_cast<int>(time)).getInt64();
    return {};
}

// Covers every opening and every saved model, because each of them updates its volume's row.
std::optional<std::int64_t> newestOpening(Connection& connection, std::int64_t belowMs) {
    return newestOf(select(connection, kVolumes, "WHERE t.last_opened < ? ORDER BY t.last_opened DESC"),
                    kVolumes, column::volumeLastOpened, belowMs);
}

std::optional<std::int64_t> newestHeld(Connection& connection, std::int64_t nowMs) {
    return newestOf(select(connection, kAudit, "WHERE t.action = 'held' AND t.at < ? ORDER BY t.at DESC"),
                    kAudit, column::auditAt, nowMs + 1);
}

bool isBehind(std::optional<std::int64_t> newestMs, std::int64_t nowMs) {
    return newestMs && *newestMs > nowMs + kHourMs;
}

}  // namespace

AgeClock ageClock(StoreState& state, std::chrono::days retention) {
    Connection& connection = *state.connection;
    const std::int64_t now = state.nowMs();
    const auto held = newestHeld(connection, now);
    const bool isHeldToday = held && now - *held < kDayMs;
    if (isBehind(newestOpening(connection, kNoEnd), now))
        return {.doubt = ClockDoubt::behind, .isOnTheTrail = isHeldToday};
    // Openings since today's doubt do not confirm the clock: they have the time of the doubted clock.
    auto borneOut = newestOpening(connection, isHeldToday ? *held : kNoEnd);
    if (held && !isHeldToday) borneOut = std::max(borneOut.value_or(*held), *held);
    const std::int64_t longest = std::max(milliseconds(retention).count(), kDayMs);
    if (!borneOut || now - *borneOut <= longest) return {.countsToMs = now};
    // A user who comes once in two months meets this doubt each time: entries that were old at the last
    // confirmed time are deleted nevertheless.
    if (held && !isHeldToday) return {.countsToMs = *borneOut, .doubt = ClockDoubt::ahead};
    return {.doubt = ClockDoubt::ahead, .isOnTheTrail = isHeldToday};
}

std::int64_t openingMs(StoreState& state) {
    const std::int64_t now = state.nowMs();
    const auto newest = newestOpening(*state.connection, kNoEnd);
    return isBehind(newest, now) ? *newest : now;
}

void setTimesBefore(Row& row, const Table& table, std::int64_t latestMs) {
    const auto putBack = [&](std::size_t time) { row.values[time] = std::min(row.number(time), latestMs); };
    if (&table == &kModels) putBack(column::modelCreated);
    if (&table == &kDocuments) putBack(column::documentCreated);
    const auto opening = std::ranges::find(kOpenings, &table, &Opening::table);
    if (opening == kOpenings.end()) return;
    putBack(opening->first);
    putBack(opening->last);
}

void setOpeningsToTheClock(StoreState& state) {
    Connection& connection = *state.connection;
    const std::int64_t now = state.nowMs();
    for (const Opening& opening : kOpenings) {
        std::vector<Row> later;
        SQLite::Statement statement = select(connection, *opening.table, "WHERE t.last_opened > ?");
        statement.bind(1, now);
        while (statement.executeStep())
            if (auto row = readRow(statement, *opening.table)) later.push_back(std::move(*row));
        statement.reset();
        for (Row& row : later) {
            setTimesBefore(row, *opening.table, now);
            putRow(connection, *opening.table, row);
        }
    }
}

}  // namespace macula::session
