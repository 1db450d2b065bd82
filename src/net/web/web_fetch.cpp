#include "net/web/web_fetch.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <thread>

#include "net/archive/first_images.h"
#include "net/archive/query_check.h"
#include "net/web/qido_search.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostAtOnce = 4;
constexpr std::size_t kMostSeriesOfStudy = 20'000;
constexpr int kMostFailures = 3;  // one after the other, without an instance in between
constexpr std::size_t kSpareInstances = 16;

Error nothingOfStudy() {
    return {ErrorCode::archiveNotUsable,
            Text("The archive has no images of this study."),
            {},
            Text("Search again: it may have been removed, or moved to another archive.")};
}

// Archives without this search exist.
bool isNotOffered(const HttpOutcome& outcome) {
    return outcome.trouble == HttpTrouble::badRequest || outcome.trouble == HttpTrouble::notFound ||
           outcome.trouble == HttpTrouble::notOffered || outcome.trouble == HttpTrouble::serverFailed;
}

}  // namespace

WebFetch::WebFetch(const std::string& service, HttpClient& client, const Wanted& wanted, Receiver& receiver,
                   Progress& progress)
    : service_(service),
      client_(client),
      wanted_(wanted),
      progress_(progress),
      tally_{receiver, progress, {}, {}, {}} {}

Result<Fetched> WebFetch::run() {
    progress_.beginStage(Text("Asking the archive for images"), 1);
    MACULA_TRY_VOID(askForInstances());
    countPromised();
    progress_.advance();
    std::size_t left = missing();
    progress_.beginStage(Text("Fetching {} images from the archive", left), std::max<std::size_t>(left, 1));
    for (int failures = 0; left > 0 && failures <= kMostFailures;) {
        if (failures > 0) MACULA_TRY_VOID(pauseBeforeRound(failures));
        MACULA_TRY_VOID(round());
        const std::size_t now = missing();
        failures = now < left ? 0 : failures + 1;
        left = now;
    }
    Fetched& fetched = tally_.fetched;
    for (const SeriesToCome& series : series_) {
        for (const FoundInstance& instance : series.instances) {
            const bool isHere = wanted_.sopInstancesHad.contains(instance.sopInstanceUid) ||
                                tally_.came.contains(instance.sopInstanceUid);
            if (!isHere) fetched.never.push_back(instance);
        }
    }
    if (!fetched.isListWhole) fetched.promised = std::max(fetched.promised, tally_.came.size());
    if (lastError_ && tally_.came.empty() && fetched.kept == 0 && fetched.refused == 0) return *lastError_;
    return std::move(fetched);
}

Result<void> WebFetch::askForInstances() {
    if (wanted_.seriesInstanceUids.empty()) {
        MACULA_TRY(const bool isThere, askForStudyAtOnce());
        if (isThere) return {};
    }
    return askBySeries();
}

Result<bool> WebFetch::askForStudyAtOnce() {
    MACULA_TRY(const std::string url, instancesUrl(service_, wanted_.studyInstanceUid, {}));
    HttpOutcome outcome;
    auto found = searchAll<FoundInstance>(client_, url, kMostInstancesOfStudy, instancesInJson,
                                          &FoundInstance::sopInstanceUid, progress_, &outcome);
    if (!found) {
        if (isNotOffered(outcome)) return false;
        return found.error();
    }
    std::map<std::string, std::size_t> places;
    for (FoundInstance& instance : found->found) {
        if (instance.seriesInstanceUid.empty()) {
            series_.clear();
            return false;
        }
        const auto [place, isNew] = places.emplace(instance.seriesInstanceUid, series_.size());
        if (isNew) series_.emplace_back().uid = instance.seriesInstanceUid;
        series_[place->second].instances.push_back(std::move(instance));
    }
    tally_.fetched.isListWhole = !found->isCutShort && found->unusable == 0;
    return !series_.empty();
}

Result<void> WebFetch::askBySeries() {
    MACULA_TRY(const std::string url, seriesUrl(service_, wanted_.studyInstanceUid));
    auto found = searchAll<FoundSeries>(client_, url, kMostSeriesOfStudy, seriesInJson,
                                        &FoundSeries::seriesInstanceUid, progress_, nullptr);
    if (!found) return found.error();
    bool isWhole = !found->isCutShort && found->unusable == 0;
    std::size_t left = kMostInstancesOfStudy;
    const auto& chosen = wanted_.seriesInstanceUids;
    for (const FoundSeries& series : found->found) {
        const bool isWanted =
            chosen.empty() || std::ranges::find(chosen, series.seriesInstanceUid) != chosen.end();
        if (!isWanted) continue;
        SeriesToCome& to = series_.emplace_back();
        to.uid = series.seriesInstanceUid;
        to.expected = series.instanceCount.value_or(0);
        MACULA_TRY(const std::string ofSeries, instancesUrl(service_, wanted_.studyInstanceUid, to.uid));
        HttpOutcome outcome;
        auto instances = searchAll<FoundInstance>(client_, ofSeries, left, instancesInJson,
                                                  &FoundInstance::sopInstanceUid, progress_, &outcome);
        if (!instances && !isNotOffered(outcome)) return instances.error();
        to.isListed = instances.ok() && !instances->found.empty();
        // Numbers of images that series have are no list.
        isWhole = isWhole && to.isListed && !instances->isCutShort && instances->unusable == 0;
        if (!instances) continue;
        left -= std::min(left, instances->found.size());
        to.instances = std::move(instances->found);
        for (FoundInstance& instance : to.instances) instance.seriesInstanceUid = to.uid;
    }
    tally_.fetched.isListWhole = isWhole;
    if (series_.empty()) return nothingOfStudy();
    return {};
}

void WebFetch::countPromised() {
    for (const SeriesToCome& series : series_) {
        tally_.fetched.promised += series.isListed ? series.instances.size() : series.expected;
        for (const FoundInstance& instance : series.instances)
            if (wanted_.sopInstancesHad.contains(instance.sopInstanceUid) &&
                tally_.had.insert(instance.sopInstanceUid).second)
                ++tally_.fetched.hadAlready;
    }
}

bool WebFetch::isMissing(const FoundInstance& instance) const {
    return !wanted_.sopInstancesHad.contains(instance.sopInstanceUid) &&
           !tally_.came.contains(instance.sopInstanceUid) && !givenUp_.contains(instance.sopInstanceUid);
}

bool WebFetch::isMissing(const SeriesToCome& series) const {
    return std::ranges::all_of(series.instances,
                               [this](const FoundInstance& instance) { return isMissing(instance); });
}

std::size_t WebFetch::missing() const {
    std::size_t count = 0;
    for (const SeriesToCome& series : series_) {
        if (!series.isListed && !series.hasCome) count += std::max<std::size_t>(series.expected, 1);
        for (const FoundInstance& instance : series.instances) count += isMissing(instance) ? 1 : 0;
    }
    return count;
}

std::deque<WebFetch::Pull> WebFetch::pullsOfRound() {
    std::deque<Pull> pulls;
    const auto add = [&](SeriesToCome& series, const std::string& sopClass, const std::string& instance,
                         std::size_t most) {
        Pull& pull = pulls.emplace_back(
            tally_, InstanceKey{wanted_.studyInstanceUid, series.uid, sopClass, instance}, most);
        pull.series = &series;
        pull.sopInstanceUid = instance;
        pull.request.url = retrieveUrl(service_, wanted_.studyInstanceUid, series.uid, instance);
        pull.request.accept = kInstancesAsStored;
        pull.request.sink = &pull.sink;
    };
    // They come once more with their series, which the archive sends as a whole.
    std::vector<FoundInstance> ofWholeSeries;
    for (const SeriesToCome& series : series_)
        if (isMissing(series)) std::ranges::copy(series.instances, std::back_inserter(ofWholeSeries));
    for (const FoundInstance& one : firstImagesOf(ofWholeSeries))
        add(*std::ranges::find(series_, one.seriesInstanceUid, &SeriesToCome::uid), one.sopClassUid,
            one.sopInstanceUid, 1);
    for (SeriesToCome& series : series_) {
        if (!series.isListed) {
            if (!series.hasCome) add(series, {}, {}, kMostInstancesOfStudy);
            continue;
        }
        std::vector<const FoundInstance*> toCome;
        for (const FoundInstance& instance : series.instances)
            if (isMissing(instance)) toCome.push_back(&instance);
        if (toCome.size() > 1 && isMissing(series)) {
            add(series, {}, {}, toCome.size() + kSpareInstances);
        } else {
            for (const FoundInstance* one : toCome) add(series, one->sopClassUid, one->sopInstanceUid, 1);
        }
    }
    return pulls;
}

Result<void> WebFetch::round() {
    std::deque<Pull> pulls = pullsOfRound();
    std::vector<HttpRequest> requests;
    for (const Pull& pull : pulls) requests.push_back(pull.request);
    const std::vector<HttpOutcome> outcomes = client_.run(requests, kMostAtOnce, progress_);
    for (std::size_t i = 0; i < pulls.size(); ++i) MACULA_TRY_VOID(judge(pulls[i], outcomes[i]));
    return {};
}

// Fails where the whole fetch must end.
Result<void> WebFetch::judge(Pull& pull, const HttpOutcome& outcome) {
    if (outcome.ended && outcome.ended->code == ErrorCode::cancelled) return *outcome.ended;
    if (outcome.ended && pull.sink.endsAll()) return *outcome.ended;
    if (!outcome.ok()) {
        lastError_ = outcome.error();
        // What the archive says no to, it will say no to again; and what is no image will be none. One that
        // is too large may have others behind it.
        const bool isRefused = outcome.trouble != HttpTrouble::none && !mayPass(outcome.trouble);
        const bool isSomethingElse = outcome.ended && pull.sink.isStrange();
        if (isRefused || isSomethingElse) giveUp(pull);
        return {};
    }
    auto whole = pull.sink.finish();
    if (!whole) return whole.error();
    if (!*whole) {
        lastError_ = errorOf(HttpTrouble::closed, outcome.status);
        return {};
    }
    if (!pull.series->isListed) pull.series->hasCome = true;
    if (!pull.sopInstanceUid.empty()) giveUp(pull);  // unless it came, it never will
    return {};
}

void WebFetch::giveUp(const Pull& pull) {
    if (!pull.sopInstanceUid.empty()) {
        givenUp_.insert(pull.sopInstanceUid);
        return;
    }
    pull.series->hasCome = true;
    for (const FoundInstance& instance : pull.series->instances) givenUp_.insert(instance.sopInstanceUid);
}

Result<void> WebFetch::pauseBeforeRound(int failures) {
    constexpr std::chrono::milliseconds kFirstPause{250};
    constexpr std::chrono::milliseconds kStep{50};
    for (auto left = kFirstPause * (1 << failures); left.count() > 0; left -= kStep) {
        if (progress_.cancelled()) return cancelledByPerson();
        std::this_thread::sleep_for(kStep);
    }
    return {};
}

}  // namespace macula::net
