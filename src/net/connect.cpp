#include "net/connect.h"

#include <utility>
#include <variant>

#include "net/dimse/dimse_archive.h"
#include "net/web/rendered_pictures.h"
#include "net/web/web_archive.h"
#include "net/web/web_peer.h"

namespace macula::net {

namespace {

Result<std::unique_ptr<Archive>> archiveFor(const Source& source, const Secrets& secrets, RenewTokens renew) {
    if (const auto* dimse = std::get_if<DimsePeer>(&source.peer)) {
        MACULA_TRY_VOID(checkDimsePeer(*dimse));
        return makeDimseArchive(source, secrets);
    }
    MACULA_TRY_VOID(checkWebPeer(std::get<WebPeer>(source.peer), secrets));
    return makeWebArchive(source, secrets, std::move(renew));
}

RenewTokens renewerIn(const SourceList& list, const Source& source) {
    const auto kept = list.secretsOf(source);
    return [list, source, read = kept ? kept->refreshToken : std::string()](
               const Secrets& ours, const AskForTokens& ask, const CancelToken& cancel) mutable {
        auto renewed = list.renewTokens(source, ours, read, ask, cancel);
        if (const auto now = list.secretsOf(source)) read = now->refreshToken;
        return renewed;
    };
}

Result<std::unique_ptr<PictureSource>> picturesFor(const Source& source, const Secrets& secrets,
                                                   RenewTokens renew) {
    const auto* web = std::get_if<WebPeer>(&source.peer);
    if (web == nullptr) return std::unique_ptr<PictureSource>();
    MACULA_TRY_VOID(checkWebPeer(*web, secrets));
    return makeRenderedPictures(source, secrets, std::move(renew));
}

}  // namespace

Result<std::unique_ptr<Archive>> archiveOf(const Source& source, const Secrets& secrets) {
    return archiveFor(source, secrets, {});
}

Result<std::unique_ptr<Archive>> archiveOf(const SourceList& list, const Source& source) {
    MACULA_TRY(const Secrets secrets, list.secretsOf(source));
    return archiveFor(source, secrets, renewerIn(list, source));
}

Result<std::unique_ptr<PictureSource>> picturesOf(const Source& source, const Secrets& secrets) {
    return picturesFor(source, secrets, {});
}

Result<std::unique_ptr<PictureSource>> picturesOf(const SourceList& list, const Source& source) {
    MACULA_TRY(const Secrets secrets, list.secretsOf(source));
    return picturesFor(source, secrets, renewerIn(list, source));
}

}  // namespace macula::net
