#include "live/store/purge_plan.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

namespace macula::app {

namespace {

constexpr std::int64_t kDayMs = 86'400'000;

Result<std::vector<session::StudyEntry>> chosen(session::Listing<session::StudyEntry> stored,
                                                const PurgeWish& wish, std::int64_t nowMs) {
    if (wish.all) return std::move(stored.entries);
    if (!wish.unusedDays) {
        MACULA_TRY(session::StudyEntry study, studyOfPrefix(stored, wish.study));
        return std::vector{std::move(study)};
    }
    std::erase_if(stored.entries, [&](const session::StudyEntry& study) {
        return study.lastOpenedMs >= nowMs - *wish.unusedDays * kDayMs;
    });
    return std::move(stored.entries);
}

// And the states of volumes that are of no study.
Result<std::size_t> withThoseOfVolumes(session::Store& store, std::size_t documents) {
    using session::DocumentKind;
    for (const DocumentKind kind :
         {DocumentKind::session, DocumentKind::view, DocumentKind::layout, DocumentKind::measurement}) {
        MACULA_TRY(const auto listing, store.listDocuments(kind, {}));
        documents += static_cast<std::size_t>(std::ranges::count_if(
            listing.entries, [](const auto& entry) { return session::isOfVolume(entry.id); }));
    }
    return documents;
}

}  // namespace

Error keptForClock(session::ClockDoubt doubt) {
    const bool isBehind = doubt == session::ClockDoubt::behind;
    return {ErrorCode::inputNotUsable,
            isBehind ? "The clock of this machine shows an earlier time than an opening of a study that is "
                       "stored, so nothing was deleted for its age."
                     : "The clock of this machine is so far ahead of the last opening that every stored "
                       "study would be deleted for its age; those that were not old then were kept.",
            {},
            isBehind ? "Set the clock. Where it is right, run `macula sessions purge --unused-days N "
                       "--trust-clock`."
                     : "Where the clock is right there is nothing to do: from tomorrow on it is believed. To "
                       "delete now, run `macula sessions purge --unused-days N --trust-clock`."};
}

Result<PurgePlan> planPurge(session::Store& store, const PurgeWish& wish, std::int64_t nowMs) {
    PurgePlan plan{.wish = wish};
    MACULA_TRY(const session::Listing<session::StudyEntry> stored, store.listStudies());
    MACULA_TRY(plan.studies, chosen(stored, wish, nowMs));
    std::set<std::string> goes;
    for (const session::StudyEntry& study : plan.studies) {
        goes.insert(study.identity);
        plan.documents += study.documents;
    }
    if (wish.unusedDays && wish.clock == session::Store::Clock::checked) {
        MACULA_TRY(plan.clock, store.clockDoubt(std::chrono::days(*wish.unusedDays)));
    }
    if (wish.all) {
        MACULA_TRY(plan.documents, withThoseOfVolumes(store, plan.documents));
    }
    MACULA_TRY(const StudiesByVolume studies, studiesByVolume(store, stored.entries));
    MACULA_TRY(const auto models, store.listModels());
    for (const session::ModelInfo& model : models.entries) {
        const auto owners = studies.find(model.key.volume);
        const bool isOfNone = owners == studies.end();
        if (isOfNone ? wish.all : std::ranges::includes(goes, owners->second)) plan.models.add(model);
    }
    return plan;
}

Result<session::PurgeReport> purge(session::Store& store, const PurgePlan& plan) {
    const PurgeWish& wish = plan.wish;
    if (wish.all) return store.purgeAll(wish.damaged);
    if (wish.unusedDays)
        return store.purgeUnused(std::chrono::days(*wish.unusedDays), wish.damaged, wish.clock);
    MACULA_CHECK(plan.studies.size() == 1);
    return store.purgeStudy(plan.studies.front().identity, wish.damaged);
}

}  // namespace macula::app
