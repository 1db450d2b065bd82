#include "study/archive/study_search.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "net/archive/query_match.h"
#include "study/archive/fetched_study.h"
#include "study/archive/local_studies.h"
#include "study/open/same_patient.h"
#include "study/spool/spool.h"

namespace macula::study {

namespace {

// Whether our copy still holds all that the archive has. If the archive has more by now, or names another
// patient, the study is fetched again, and the fetch reports it.
bool isStillWhole(const LocalStudy& local, const net::FoundStudy& now) {
    return local.isWhole && now.instanceCount.value_or(0) <= local.study.instanceCount.value_or(0) &&
           samePatient(identityOf(local.study), identityOf(now)) != SamePatient::no;
}

// What has come from each place, and the listing of it.
class Gathering {
  public:
    Gathering(const PlacesToSearch& places, const net::StudyQuery& query, const ListingListener& listener)
        : places_(places), query_(query), listener_(listener), answers_(places.archives.size()) {}

    void take(std::size_t archive, Result<net::StudyAnswers> answer) {
        const std::lock_guard lock(mutex_);
        answers_[archive] = std::move(answer);
        tell();
    }
    void take(std::vector<LocalStudy> local) {
        const std::lock_guard lock(mutex_);
        local_ = std::move(local);
        tell();
    }

    Listing listing() const {
        Listing listing;
        std::vector<bool> isListed(local_.size(), false);
        for (std::size_t place = 0; place < answers_.size(); ++place) {
            if (answers_[place]) list(places_.archives[place].name, *answers_[place], isListed, listing);
        }
        for (std::size_t i = 0; i < local_.size() && places_.isHereToo; ++i) {
            const LocalStudy& local = local_[i];
            if (!isListed[i] && net::matchesQuery(query_, local.study))
                listing.studies.push_back({local.study, {}, local.folder, local.isWhole});
        }
        return listing;
    }

  private:
    void list(const std::string& archive, const Result<net::StudyAnswers>& answer,
              std::vector<bool>& isListed, Listing& listing) const {
        if (!answer) {
            if (answer.error().code != ErrorCode::cancelled)
                listing.silent.push_back({archive, answer.error()});
            return;
        }
        listing.isCutShort = listing.isCutShort || answer->isCutShort;
        listing.unusable += answer->unusable;
        std::map<std::string_view, std::size_t> fetched;
        for (std::size_t i = 0; i < local_.size(); ++i) {
            if (local_[i].archive == archive) fetched.emplace(local_[i].study.studyInstanceUid, i);
        }
        for (const net::FoundStudy& study : answer->studies) {
            ListedStudy listed{study, archive, {}, false};
            if (const auto found = fetched.find(study.studyInstanceUid); found != fetched.end()) {
                listed.folder = local_[found->second].folder;
                listed.isWhole = isStillWhole(local_[found->second], study);
                isListed[found->second] = true;
            }
            listing.studies.push_back(std::move(listed));
        }
    }

    void tell() const {
        if (listener_) listener_(listing());
    }

    const PlacesToSearch& places_;
    const net::StudyQuery& query_;
    const ListingListener& listener_;
    std::mutex mutex_;
    std::vector<std::optional<Result<net::StudyAnswers>>> answers_;
    std::vector<LocalStudy> local_;
};

// Fetched studies are looked up for every search, so that those of an archive's answers are known.
void searchHere(const PlacesToSearch& places, const CancelToken& cancel, Gathering& gathering) {
    std::vector<LocalStudy> local;
    if (const auto spool = Spool::open(); spool) local = studiesInSpool(*spool, cancel);
    gathering.take(local);
    if (!places.isHereToo || places.folders.empty()) return;
    for (const std::filesystem::path& folder : places.folders) {
        if (cancel.cancelled() || folder.parent_path() == spoolFolder()) continue;
        for (LocalStudy& each : studiesInFolder(folder, cancel)) local.push_back(std::move(each));
    }
    gathering.take(std::move(local));
}

}  // namespace

Listing searchStudies(const PlacesToSearch& places, const net::StudyQuery& query, Progress& progress,
                      const ListingListener& listener) {
    progress.beginStage(Text("Searching"), places.archives.size() + 1);
    Gathering gathering(places, query, listener);
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < places.archives.size(); ++i) {
            threads.emplace_back([&, i] {
                Progress own({}, progress.token());
                const auto& archive = places.archives[i].archive;
                gathering.take(i, archive ? (*archive)->findStudies(query, own)
                                          : Result<net::StudyAnswers>(archive.error()));
                progress.advance();
            });
        }
        searchHere(places, progress.token(), gathering);
        progress.advance();
    }
    return gathering.listing();
}

Listing withStudiesHere(Listing listing, const net::StudyQuery& query, const CancelToken& cancel) {
    const auto spool = Spool::open();
    if (!spool) return listing;
    std::map<std::filesystem::path, std::size_t> byFolder;
    for (std::size_t i = 0; i < listing.studies.size(); ++i)
        if (!listing.studies[i].folder.empty()) byFolder.emplace(listing.studies[i].folder, i);
    for (LocalStudy& local : studiesInSpool(*spool, cancel)) {
        const auto found = byFolder.find(local.folder);
        if (found == byFolder.end()) {
            if (local.archive.empty() && net::matchesQuery(query, local.study))
                listing.studies.push_back({std::move(local.study), {}, local.folder, local.isWhole});
        } else if (ListedStudy& listed = listing.studies[found->second]; listed.archive.empty()) {
            listed.study = std::move(local.study);
            listed.isWhole = local.isWhole;
        }
    }
    return listing;
}

}  // namespace macula::study
