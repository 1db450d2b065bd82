#include "app/session/purge_plan.h"

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

}  // namespace

Result<PurgePlan> planPurge(session::Store& store, const PurgeWish& wish, std::int64_t nowMs) {
    PurgePlan plan{.wish = wish};
    MACULA_TRY(const session::Listing<session::StudyEntry> stored, store.listStudies());
    MACULA_TRY(plan.studies, chosen(stored, wish, nowMs));
    std::set<std::string> goes;
    for (const session::StudyEntry& study : plan.studies) {
        goes.insert(study.identity);
        plan.documents += study.documents;
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
    if (wish.unusedDays) return store.purgeUnused(std::chrono::days(*wish.unusedDays), wish.damaged);
    MACULA_CHECK(plan.studies.size() == 1);
    return store.purgeStudy(plan.studies.front().identity, wish.damaged);
}

}  // namespace macula::app
