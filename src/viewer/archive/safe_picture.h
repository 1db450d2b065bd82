// Decodes pictures that an archive sends. They may be crafted to attack the decoder, so their format and size
// are bounded first.
#pragma once

#include <QImage>
#include <QSize>

#include "net/archive/picture_source.h"

namespace macula::viewer {

inline constexpr int kMostEncodedEdgePx = 2048;

// At most `largest`, with the proportions of the picture. A null image where it is not what it claims to be,
// is larger than kMostEncodedEdgePx on a side, or cannot be decoded. Thread-safe.
QImage decodedPicture(const net::EncodedPicture& picture, QSize largest);

}  // namespace macula::viewer
