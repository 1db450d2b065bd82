// Decides how far to trust the machine's clock when stored things are deleted for their age. Private to
// src/session.
//
// Each opening stores its time. The clock is doubted if it shows less than a stored opening, or so much more
// than the last opening that everything would be deleted at once. The audit trail records a doubt as "held".
// A clock that is ahead is trusted a day after the doubt; one that is behind never is.
#pragma once

#include <cstdint>
#include <optional>

#include "session/store_state.h"

namespace macula::session {

struct AgeClock {
    // The time from which ages are counted back. Nothing: nothing is deleted for its age.
    std::optional<std::int64_t> countsToMs;
    ClockDoubt doubt = ClockDoubt::none;
    bool isOnTheTrail = false;  // a doubt was recorded within the last day
};

// Call within inTransaction or inReading.
AgeClock ageClock(StoreState& state, std::chrono::days retention);

// The time to store for an opening: that of the clock, or of the last opening if the clock is behind it. So
// entries opened while the clock is behind do not count as old once it is set right.
std::int64_t openingMs(StoreState& state);

// Limits the opening and creation times of an imported row to `latestMs`: a machine whose clock is ahead may
// have written it. Later times would outlive the retention and cast doubt on the clock here.
void setTimesBefore(Row& row, const Table& table, std::int64_t latestMs);

// Call in a transaction: sets openings that are later than the clock to its time.
void setOpeningsToTheClock(StoreState& state);

}  // namespace macula::session
