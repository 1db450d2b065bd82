// What a purge would delete, computed before it deletes anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "live/store/stored_studies.h"
#include "session/store.h"

namespace macula::live {

// Set one of study, all and unusedDays.
struct PurgeRequest {
    std::string study;  // the first digits of its identity
    bool all = false;
    std::optional<int> unusedDays;                                 // everything not opened for so many days
    session::Store::Clock clock = session::Store::Clock::checked;  // whether unusedDays doubts the clock
    session::DamagedFiles damaged = session::DamagedFiles::keep;
};

// The counts before the purge. `models` includes models that belong to no study only if `all` is set; with
// `unusedDays`, the purge deletes old ones of these too, but only its report counts them.
struct PurgePlan {
    PurgeRequest request;
    std::vector<session::StudyEntry> studies;
    ModelSum models;  // models of volumes that no remaining study has
    std::size_t documents = 0;
    session::ClockDoubt clock = session::ClockDoubt::none;  // with a doubt the purge deletes less
};

// `nowMs`: milliseconds since 1970 (UTC). Fails as studyOfPrefix does.
Result<PurgePlan> planPurge(session::Store& store, const PurgeRequest& request, std::int64_t nowMs);

// Says why old entries were not deleted, and what to do. `doubt` is not none.
Error keptForClock(session::ClockDoubt doubt);

// Carries out the plan. Fails as Store::purgeStudy.
Result<session::PurgeReport> purge(session::Store& store, const PurgePlan& plan);

}  // namespace macula::live
