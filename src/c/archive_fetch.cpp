// A study from an archive, in a folder that macula_study_open opens.
#include <filesystem>
#include <utility>

#include "c/archive.h"
#include "c/arrivals.h"
#include "c/sized.h"
#include "study/archive/fetched_study.h"

namespace macula::c {

namespace {

namespace fs = std::filesystem;

Result<study::FetchRequest> requestOf(const macula_fetch& fetch) {
    MACULA_TRY_VOID(checkUid(fetch.study_uid));
    study::FetchRequest request{.studyInstanceUid = fetch.study_uid};
    if (fetch.series_count > 0 && fetch.series_uids == nullptr) return nullHandle();
    for (std::uint32_t i = 0; i < fetch.series_count; ++i) {
        MACULA_TRY_VOID(checkUid(fetch.series_uids[i]));
        request.seriesInstanceUids.emplace_back(fetch.series_uids[i]);
    }
    return request;
}

Result<study::Spool> spoolOf(const macula_fetch& fetch) {
    const std::string into = textOrEmpty(fetch.into);
    if (into.empty()) return study::Spool::open();
    // The host may change its working folder before it opens the study.
    std::error_code failure;
    const fs::path folder = fs::absolute(into, failure);
    return study::Spool::chosen(failure ? fs::path(into) : folder);
}

macula_fetched toldOf(const study::FetchedStudy& fetched, const macula_archive& archive) {
    macula_fetched told{};
    told.is_complete = fetched.isComplete ? 1 : 0;
    told.folder = archive.folder.c_str();
    told.promised = fetched.counts.promised;
    told.kept = fetched.counts.kept;
    told.had_already = fetched.counts.hadAlready;
    told.refused = fetched.counts.refused;
    told.never = fetched.counts.never.size();
    told.bytes = fetched.counts.bytes;
    return told;
}

Result<void> fetch(macula_archive& archive, const study::FetchRequest& request, study::Spool& spool,
                   Arrivals& arrivals, Progress& progress, macula_fetched* told) {
    archive.notes.clear();
    MACULA_TRY(
        const study::FetchedStudy fetched,
        study::fetchStudy(*archive.archive, archive.name, request, spool, progress,
                          [&](const study::Arrival& arrival) { arrivals.tell(arrival, progress.token()); }));
    arrivals.tellRest(fetched.folder, progress.token());
    archive.folder = fetched.folder.string();
    for (const Message& message : fetched.messages)
        archive.notes.push_back(message.sentence.english() + " " + message.action.english());
    give(toldOf(fetched, archive), told);
    return {};
}

}  // namespace

extern "C" {

macula_status macula_archive_fetch(macula_archive* archive, const macula_fetch* fetch,
                                   const macula_progress* progress, macula_fetched* fetched) {
    return guarded([&]() -> Result<void> {
        if (!isSized(fetched)) return wrongSize(fetched);
        MACULA_TRY(const macula_fetch asked, taken(fetch));
        MACULA_TRY(const study::FetchRequest request, requestOf(asked));
        MACULA_TRY(const macula_progress told, taken(progress));
        MACULA_TRY(const Held<macula_archive> of, changing(archive));
        Arrivals arrivals(told, asked);
        return withProgress(arrivals.progress(), [&](Progress& to) -> Result<void> {
            MACULA_TRY(study::Spool spool, spoolOf(asked));
            return c::fetch(*of, request, spool, arrivals, to, fetched);
        });
    });
}

const char* macula_archive_note(const macula_archive* archive, std::uint32_t index) {
    return textAt(
        archive, index, [](const macula_archive& of) -> const auto& { return of.notes; });
}

}  // extern "C"

}  // namespace macula::c
