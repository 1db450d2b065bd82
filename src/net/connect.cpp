#include "net/connect.h"

#include <variant>

#include "net/web/web_archive.h"
#include "net/web/web_peer.h"

namespace macula::net {

Result<std::unique_ptr<Archive>> archiveOf(const Source& source, const Secrets& secrets) {
    if (const WebPeer* const peer = std::get_if<WebPeer>(&source.peer)) {
        MACULA_TRY_VOID(checkWebPeer(*peer, secrets));
        return makeWebArchive(source, secrets);
    }
    return Error{ErrorCode::usage, Text("This build cannot speak with archives."), {}, {}};
}

}  // namespace macula::net
