#include "live/store/purge_plan.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

namespace macula::live {

namespace {

constexpr std::int64_t kDayMs = 86'400'000;

Result<std::vector<session::StudyEntry>> chosen(session::Listing<session::StudyEntry> stored,
                                                const PurgeRequest& request, std::int64_t nowMs) {
    if (request.all) return std::move(stored.entries);
    if (!request.unusedDays) {
        MACULA_TRY(session::StudyEntry study, studyOfPrefix(stored, request.study));
        return std::vector{std::move(study)};
    }
    std::erase_if(stored.entries, [&](const session::StudyEntry& study) {
        return study.lastOpenedMs >= nowMs - *request.unusedDays * kDayMs;
    });
    return std::move(stored.entries);
}

// `documents`, and the states of volumes that belong to no study.
Result<std::size_t> withThoseOfVolumes(session::Store& store, std::size_t documents) {
    using session::DocumentKind;
    for (const DocumentKind kind :
         {DocumentKind::studyState, DocumentKind::view, DocumentKind::layout, DocumentKind::measurement}) {
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
            isBehind
                ? Text("The clock of this machine shows an earlier time than an opening of a study that is "
                       "stored, so nothing was deleted for its age.")
                : Text("The clock of this machine is so far ahead of the last opening that every stored "
                       "study would be deleted for its age; those that were not old then were kept."),
            {},
            isBehind
                ? Text("Set the clock. Where it is right, run `macula sessions purge --unused-days N "
                       "--trust-clock`.")
                : Text("Where the clock is right there is nothing to do: from tomorrow on it is believed. To "
                       "delete now, run `macula sessions purge --unused-days N --trust-clock`.")};
}

Result<PurgePlan> planPurge(session::Store& store, const PurgeRequest& request, std::int64_t nowMs) {
    PurgePlan plan{.request = request};
    MACULA_TRY(const session::Listing<session::StudyEntry> stored, store.listStudies());
    MACULA_TRY(plan.studies, chosen(stored, request, nowMs));
    std::set<std::string> goes;
    for (const session::StudyEntry& study : plan.studies) {
        goes.insert(study.identity);
        plan.documents += study.documents;
    }
    if (request.unusedDays && request.clock == session::Store::Clock::checked) {
        MACULA_TRY(plan.clock, store.clockDoubt(std::chrono::days(*request.unusedDays)));
    }
    if (request.all) {
        MACULA_TRY(plan.documents, withThoseOfVolumes(store, plan.documents));
    }
    MACULA_TRY(const StudiesByVolume studies, studiesByVolume(store, stored.entries));
    MACULA_TRY(const auto models, store.listModels());
    for (const session::ModelInfo& model : models.entries) {
        const auto owners = studies.find(model.key.volume);
        const bool isOfNone = owners == studies.end();
        if (isOfNone ? request.all : std::ranges::includes(goes, owners->second)) plan.models.add(model);
    }
    return plan;
}

Result<session::PurgeReport> purge(session::Store& store, const PurgePlan& plan) {
    const PurgeRequest& request = plan.request;
    if (request.all) return store.purgeAll(request.damaged);
    if (request.unusedDays)
        return store.purgeUnused(std::chrono::days(*request.unusedDays), request.damaged, request.clock);
    MACULA_CHECK(plan.studies.size() == 1);
    return store.purgeStudy(plan.studies.front().identity, request.damaged);
}

}  // namespace macula::live
