// Whether the settings of an archive of the web can work.
#pragma once

#include "base/result.h"
#include "net/archive/source.h"
#include "net/web/http_exchange.h"

namespace macula::net {

// Fails with usage where the settings cannot work: an address that is not of the web, a password or a token
// that would go over the network in the clear, files of TLS that do not exist.
Result<void> checkWebPeer(const WebPeer& peer, const Secrets& secrets);

HttpSettings httpSettingsOf(const Source& source, const WebPeer& peer, const Secrets& secrets);

}  // namespace macula::net
