#include "net/connect.h"

#include <utility>
#include <variant>

#include "net/dimse/dimse_archive.h"
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

}  // namespace

Result<std::unique_ptr<Archive>> archiveOf(const Source& source, const Secrets& secrets) {
    return archiveFor(source, secrets, {});
}

Result<std::unique_ptr<Archive>> archiveOf(const SourceList& list, const Source& source) {
    MACULA_TRY(const Secrets secrets, list.secretsOf(source));
    return archiveFor(source, secrets, [list, source](const Secrets& ours, const auto& ask) {
        return list.renewTokens(source, ours, ask);
    });
}

}  // namespace macula::net
