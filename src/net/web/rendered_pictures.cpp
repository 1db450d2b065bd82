#include "net/web/rendered_pictures.h"

#include <atomic>
#include <utility>
#include <variant>

#include "base/check.h"
#include "base/exceptions.h"
#include "net/archive/file_meta.h"
#include "net/web/gathered_body.h"
#include "net/web/http_client.h"
#include "net/web/multipart_parser.h"
#include "net/web/qido_search.h"
#include "net/web/web_address.h"
#include "net/web/web_peer.h"

namespace macula::net {

namespace {

using Picture = std::optional<EncodedPicture>;

constexpr std::uintmax_t kMostBytesOfPicture = std::uintmax_t{1} << 20;
// So many series without a picture, and none with one, are taken for an archive without pictures.
constexpr int kMostRefusals = 3;
// Orthanc refuses a request that accepts several types.
constexpr const char* kAccepted = "image/jpeg";

std::optional<EncodedPicture::Kind> kindOf(const HttpHead& head, const std::string& bytes) {
    const std::string type = mediaTypeOf(head.contentType);
    if (type == "image/jpeg" && bytes.starts_with("\xff\xd8\xff")) return EncodedPicture::Kind::jpeg;
    if (type == "image/png" && bytes.starts_with("\x89PNG\r\n\x1a\n")) return EncodedPicture::Kind::png;
    return {};
}

// That the archive has no such resource: other troubles may be of one series, or of a moment.
bool saysNotOffered(HttpTrouble trouble) {
    return trouble == HttpTrouble::notFound || trouble == HttpTrouble::notOffered ||
           trouble == HttpTrouble::notAcceptable;
}

// An answer of the archive, and not a connection that failed.
bool isRefusal(const HttpOutcome& outcome) {
    return outcome.status >= 400 && outcome.trouble != HttpTrouble::busy &&
           outcome.trouble != HttpTrouble::signInRefused && outcome.trouble != HttpTrouble::forbidden;
}

class RenderedPictures final : public PictureSource {
  public:
    RenderedPictures(const Source& source, const WebPeer& peer, const Secrets& secrets, RenewTokens renew)
        : service_(webAddressOf(peer.url).value().url),
          settings_(httpSettingsOf(source, peer, secrets)),
          signIn_(peer, secrets, settings_, std::move(renew)) {}

    Result<Picture> pictureOf(const std::string& studyInstanceUid, const FoundSeries& series, int edgePixels,
                              Progress& progress) override {
        try {
            return drawn(studyInstanceUid, series, edgePixels, progress);
        } catch (const std::exception& thrown) {
            return errorOf(thrown, Text("work with the archive"));
        }
    }

    bool isOffered() const override { return way_.load() != Way::none; }

  private:
    enum class Way { thumbnail, rendered, none };

    Result<Picture> drawn(const std::string& studyInstanceUid, const FoundSeries& series, int edgePixels,
                          Progress& progress) {
        if (!isUid(studyInstanceUid) || !isUid(series.seriesInstanceUid)) return Picture();
        HttpClient client(settings_, &signIn_);
        const std::string edge = std::to_string(edgePixels);
        const std::string viewport = "?viewport=" + edge + "," + edge;
        if (way_.load() == Way::thumbnail) {
            const std::string url = retrieveUrl(service_, studyInstanceUid, series.seriesInstanceUid);
            MACULA_TRY(Picture picture,
                       asked(client, url + "/thumbnail" + viewport, Way::thumbnail, progress));
            if (picture || way_.load() == Way::thumbnail) return picture;
        }
        if (way_.load() != Way::rendered) return Picture();
        MACULA_TRY(const std::string instance, instanceIn(client, studyInstanceUid, series, progress));
        if (instance.empty()) return refused(false, Way::rendered);
        const std::string url = retrieveUrl(service_, studyInstanceUid, series.seriesInstanceUid, instance);
        return asked(client, url + "/rendered" + viewport, Way::rendered, progress);
    }

    Result<Picture> asked(HttpClient& client, const std::string& url, Way way, Progress& progress) {
        GatheredBody body;
        HttpRequest request;
        request.url = url;
        request.accept = kAccepted;
        request.sink = &body;
        request.mostBytes = kMostBytesOfPicture;
        const HttpOutcome outcome = client.run(request, progress);
        if (outcome.ok()) {
            const auto kind = kindOf(body.head(), body.text());
            if (!kind) return refused(true, way);
            hasCome_ = true;
            return Picture(EncodedPicture{*kind, body.text()});
        }
        if (isRefusal(outcome)) return refused(saysNotOffered(outcome.trouble), way);
        if (outcome.trouble == HttpTrouble::tooLarge) return Picture();
        return outcome.error();
    }

    // Once a picture has come, what is refused is a matter of the one series. Of several that ask at once,
    // one may have gone on to the next way before.
    Picture refused(bool isOfTheArchive, Way way) {
        if (hasCome_.load()) return {};
        if (!isOfTheArchive && ++refusals_ < kMostRefusals) return {};
        if (way_.compare_exchange_strong(way, way == Way::thumbnail ? Way::rendered : Way::none))
            refusals_ = 0;
        return {};
    }

    // In the middle, where the archive says how many there are; empty where it names none.
    Result<std::string> instanceIn(HttpClient& client, const std::string& studyInstanceUid,
                                   const FoundSeries& series, Progress& progress) const {
        MACULA_TRY(const std::string url, instancesUrl(service_, studyInstanceUid, series.seriesInstanceUid));
        const QidoText answer =
            qidoText(client, pageUrl(url, 1, series.instanceCount.value_or(0) / 2), progress);
        if (!answer.outcome.ok() && isRefusal(answer.outcome)) return std::string();
        if (!answer.outcome.ok()) return answer.outcome.error();
        MACULA_TRY(const QidoPage<FoundInstance> page, instancesInJson(answer.text));
        return page.found.empty() ? std::string() : page.found.front().sopInstanceUid;
    }

    const std::string service_;
    const HttpSettings settings_;
    WebSignIn signIn_;
    std::atomic<Way> way_{Way::thumbnail};
    std::atomic<bool> hasCome_{false};
    std::atomic<int> refusals_{0};
};

}  // namespace

std::unique_ptr<PictureSource> makeRenderedPictures(const Source& source, const Secrets& secrets,
                                                    RenewTokens renew) {
    const WebPeer* const peer = std::get_if<WebPeer>(&source.peer);
    MACULA_CHECK(peer != nullptr);
    return std::make_unique<RenderedPictures>(source, *peer, secrets, std::move(renew));
}

}  // namespace macula::net
