#include "net/connect.h"

#include <variant>

#include "net/dimse/dimse_archive.h"
#include "net/web/web_archive.h"
#include "net/web/web_peer.h"

namespace macula::net {

Result<std::unique_ptr<Archive>> archiveOf(const Source& source, const Secrets& secrets) {
    if (const auto* dimse = std::get_if<DimsePeer>(&source.peer)) {
        MACULA_TRY_VOID(checkDimsePeer(*dimse));
        return makeDimseArchive(source, secrets);
    }
    MACULA_TRY_VOID(checkWebPeer(std::get<WebPeer>(source.peer), secrets));
    return makeWebArchive(source, secrets);
}

}  // namespace macula::net
