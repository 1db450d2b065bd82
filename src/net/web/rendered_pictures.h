// Pictures that an archive of the web draws: thumbnails of series (PS3.18 10.4.1.1.5), or rendered instances
// (10.4.1.1.3).
#pragma once

#include <memory>

#include "net/archive/picture_source.h"
#include "net/archive/source.h"
#include "net/web/sign_in.h"

namespace macula::net {

// Of a source whose peer is a WebPeer, and whose settings were checked (web_peer.h).
std::unique_ptr<PictureSource> makeRenderedPictures(const Source& source, const Secrets& secrets,
                                                    RenewTokens renew = {});

}  // namespace macula::net
