#include "net/sources/source_address.h"

#include <fmt/format.h>

namespace macula::net {

std::string addressOf(const Source& source) {
    if (const auto* web = std::get_if<WebPeer>(&source.peer)) return web->url;
    const auto& peer = std::get<DimsePeer>(source.peer);
    return fmt::format("{}@{}:{}", peer.calledAe, peer.host, peer.port);
}

}  // namespace macula::net
