// How far the clock of the machine is believed where stored things are deleted for their age. Private to
// src/session.
//
// Each opening stores its time, so the clock is doubted where it shows less than an opening has stored, and
// where it shows so much more than the last opening that everything would be deleted at once. A doubt is on
// the audit trail as "held". A clock that is ahead is believed once it has gone on for a day since; one that
// is behind never is.
#pragma once

#include <cstdint>
#include <optional>

#include "session/store_state.h"

namespace macula::session {

struct AgeClock {
    // Ages are counted to then. Nothing: nothing is deleted for its age.
    std::optional<std::int64_t> countsToMs;
    ClockDoubt doubt = ClockDoubt::none;
    bool isOnTheTrail = false;  // the doubt, from within the last day
};

// In a transaction or reading.
AgeClock ageClock(StoreState& state, std::chrono::days retention);

// The time to store of an opening: that of the clock, or of the last opening where the clock is behind it. So
// what is opened while a clock is wrong is not taken for old when it is set right.
std::int64_t openingMs(StoreState& state);

// What another machine, whose clock may be ahead, has stored was opened or made at no later time than that:
// it would outlive its retention, and the clock here would be doubted.
void setTimesBefore(Row& row, const Table& table, std::int64_t latestMs);

// In a transaction: openings that are later than the clock are of now.
void setOpeningsToTheClock(StoreState& state);

}  // namespace macula::session
