#include "viewer/archive/safe_picture.h"

#include <QBuffer>
#include <QByteArray>
#include <QImageReader>
#include <limits>

namespace macula::viewer {

namespace {

const char* formatOf(net::EncodedPicture::Kind kind) {
    switch (kind) {
        case net::EncodedPicture::Kind::jpeg:
            return "jpeg";
        case net::EncodedPicture::Kind::png:
            return "png";
    }
    return "";
}

}  // namespace

// The size is read from the header, before there is memory for any pixel. No other format is tried: some of
// Qt's readers follow references, or run scripts.
QImage decodedPicture(const net::EncodedPicture& picture, QSize largest) {
    if (picture.bytes.size() > std::size_t(std::numeric_limits<int>::max())) return {};
    QByteArray bytes = QByteArray::fromRawData(picture.bytes.data(), qsizetype(picture.bytes.size()));
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::ReadOnly)) return {};
    QImageReader reader(&buffer, formatOf(picture.kind));
    reader.setAutoDetectImageFormat(false);
    const QSize size = reader.size();
    const bool isReasonable = size.isValid() && !size.isEmpty() && size.width() <= kMostEncodedEdgePx &&
                              size.height() <= kMostEncodedEdgePx;
    if (!isReasonable) return {};
    if (size.width() > largest.width() || size.height() > largest.height())
        reader.setScaledSize(size.scaled(largest, Qt::KeepAspectRatio).expandedTo(QSize(1, 1)));
    return reader.read();
}

}  // namespace macula::viewer
