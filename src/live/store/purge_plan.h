// What a purge would delete, told before anything is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "live/store/stored_sessions.h"
#include "session/store.h"

namespace macula::app {

// One of study, all and unusedDays.
struct PurgeWish {
    std::string study;  // first digits of its identity
    bool all = false;
    std::optional<int> unusedDays;                                 // all that was not opened for so many days
    session::Store::Clock clock = session::Store::Clock::checked;  // of unusedDays
    session::DamagedFiles damaged = session::DamagedFiles::keep;
};

// Counted before. Files that belong to no study are in `models` of a wish for all; how many of them were not
// opened for so long only the purge itself finds.
struct PurgePlan {
    PurgeWish wish;
    std::vector<session::StudyEntry> studies;
    ModelSum models;  // that go with them: those of volumes that no other study has
    std::size_t documents = 0;
    session::ClockDoubt clock = session::ClockDoubt::none;  // then the purge deletes less than is told here
};

// `nowMs`: milliseconds since 1970 (UTC). Fails as studyOfPrefix does.
Result<PurgePlan> planPurge(session::Store& store, const PurgeWish& wish, std::int64_t nowMs);

// Why what seems to be old was not deleted, and what to do; of a doubt alone.
Error keptForClock(session::ClockDoubt doubt);

// Does it. Fails as Store::purgeStudy does.
Result<session::PurgeReport> purge(session::Store& store, const PurgePlan& plan);

}  // namespace macula::app
