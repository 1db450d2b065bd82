#include "net/web/web_archive.h"
#include "net/archive/query_check.h"
#include "net/archive/query_match.h"

#include <type_traits>
#include <utility>
#include <vector>

#include "base/exceptions.h"
#include "net/web/http_client.h"
#include "net/web/qido_search.h"
#include "net/web/qido_wildcards.h"
#include "net/web/sign_in.h"
#include "net/web/web_address.h"
#include "net/web/web_fetch.h"
#include "net/web/web_peer.h"
#include "net/web/web_send.h"
#include "net/web/web_trial.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostSeriesFound = 20'000;

// Each call has connections of its own; the token of a sign-in is shared.
class WebArchive final : public Archive {
  public:
    WebArchive(const Source& source, const WebPeer& peer, const Secrets& secrets, RenewTokens renew)
        : service_(webAddressOf(peer.url).value().url),
          settings_(httpSettingsOf(source, peer, secrets)),
          signIn_(peer, secrets, settings_, std::move(renew)) {}

    Result<StudyAnswers> findStudies(const StudyQuery& query, Progress& progress) override {
        return guarded([&]() -> Result<StudyAnswers> {
            progress.beginStage(Text("Searching the archive"), 1);
            HttpClient client(settings_, &signIn_);
            MACULA_TRY(auto found, studiesFor(client, query, progress));
            if (const auto wide = withWildcards(query); wide && found.found.empty()) {
                MACULA_TRY(found, studiesFor(client, *wide, progress));
                std::erase_if(found.found,
                              [&](const FoundStudy& study) { return !matchesTexts(query, study); });
            }
            progress.advance();
            return StudyAnswers{std::move(found.found), found.isCutShort, found.unusable};
        });
    }

    Result<std::vector<FoundSeries>> findSeries(const std::string& studyInstanceUid,
                                                Progress& progress) override {
        return guarded([&]() -> Result<std::vector<FoundSeries>> {
            progress.beginStage(Text("Asking the archive for series"), 1);
            MACULA_TRY(const std::string url, seriesUrl(service_, studyInstanceUid));
            HttpClient client(settings_, &signIn_);
            MACULA_TRY(auto found, searchAll<FoundSeries>(client, url, kMostSeriesFound, seriesInJson,
                                                          &FoundSeries::seriesInstanceUid, progress));
            progress.advance();
            return std::move(found.found);
        });
    }

    Result<std::vector<FoundInstance>> findInstances(const std::string& studyInstanceUid,
                                                     const std::string& seriesInstanceUid,
                                                     Progress& progress) override {
        return guarded([&]() -> Result<std::vector<FoundInstance>> {
            progress.beginStage(Text("Asking the archive for images"), 1);
            MACULA_TRY(const std::string url, instancesUrl(service_, studyInstanceUid, seriesInstanceUid));
            HttpClient client(settings_, &signIn_);
            MACULA_TRY(auto found,
                       searchAll<FoundInstance>(client, url, kMostInstancesOfStudy, instancesInJson,
                                                &FoundInstance::sopInstanceUid, progress));
            if (found.isCutShort) return tooManyInstances();
            for (FoundInstance& instance : found.found)
                if (!seriesInstanceUid.empty()) instance.seriesInstanceUid = seriesInstanceUid;
            progress.advance();
            return std::move(found.found);
        });
    }

    Result<Fetched> fetch(const Wanted& wanted, Receiver& receiver, Progress& progress) override {
        return guarded([&]() -> Result<Fetched> {
            HttpClient client(settings_, &signIn_);
            return WebFetch(service_, client, wanted, receiver, progress).run();
        });
    }

    Result<Sent> send(std::span<const std::filesystem::path> files, Progress& progress) override {
        return guarded([&]() -> Result<Sent> {
            HttpClient client(settings_, &signIn_);
            return WebSend(service_, client, progress).run(files);
        });
    }

    std::vector<TestStep> test(Progress& progress) override {
        WebTrial trial(service_, settings_, signIn_, progress);
        const auto ran = guarded([&]() -> Result<bool> { return trial.run(), true; });
        if (!ran) trial.fail(ran.error());
        return trial.steps();
    }

  private:
    Result<QidoFound<FoundStudy>> studiesFor(HttpClient& client, const StudyQuery& query,
                                             Progress& progress) {
        MACULA_TRY(const std::string url, studiesUrl(service_, query));
        return searchAll<FoundStudy>(client, url, query.mostAnswers, studiesInJson,
                                     &FoundStudy::studyInstanceUid, progress);
    }

    template <class Work>
    static std::invoke_result_t<Work> guarded(Work work) {
        try {
            return work();
        } catch (const std::exception& thrown) {
            return errorOf(thrown, Text("work with the archive"));
        }
    }

    const std::string service_;
    const HttpSettings settings_;
    WebSignIn signIn_;
};

}  // namespace

std::unique_ptr<Archive> makeWebArchive(const Source& source, const Secrets& secrets, RenewTokens renew) {
    const WebPeer* const peer = std::get_if<WebPeer>(&source.peer);
    MACULA_CHECK(peer != nullptr);
    return std::make_unique<WebArchive>(source, *peer, secrets, std::move(renew));
}

}  // namespace macula::net
