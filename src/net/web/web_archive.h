// An archive that speaks DICOMweb (PS3.18).
#pragma once

#include <memory>

#include "net/archive/archive.h"
#include "net/web/sign_in.h"

namespace macula::net {

// Of a source whose peer is a WebPeer, and whose settings were checked (web_peer.h).
std::unique_ptr<Archive> makeWebArchive(const Source& source, const Secrets& secrets, RenewTokens renew = {});

}  // namespace macula::net
