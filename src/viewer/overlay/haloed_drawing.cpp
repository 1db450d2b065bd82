#include "viewer/overlay/haloed_drawing.h"

#include <QFontMetricsF>
#include <QPen>
#include <QPixmap>
#include <QPixmapCache>
#include <cmath>

namespace macula::viewer {

namespace {

const QColor kHalo(0, 0, 0, 190);
constexpr double kHaloPx = 1.5;       // on each side
constexpr double kMostKeptPx = 2048;  // wider texts are not cached

void paintText(QPainter& painter, const QFont& font, const QPointF& at, const QString& text,
               const QColor& ink) {
    QPainterPath path;
    path.addText(at, font, text);
    painter.strokePath(path, QPen(kHalo, 2.0 * kHaloPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, ink);
}

// The text with its halo, and the start of its base line in the picture.
struct KeptText {
    QPixmap picture;
    QPointF begin;
};
KeptText keptText(const QPainter& on, const QString& text, const QColor& ink, double pixelRatio) {
    const QFont font = on.font();
    const QRectF letters = QFontMetricsF(font).boundingRect(text);
    const double edge = std::ceil(kHaloPx) + 1.0;
    KeptText kept{.picture = {},
                  .begin = {edge + std::ceil(-letters.left()), edge + std::ceil(-letters.top())}};
    // How many pixels a size in points has depends on the screen, which font.key() does not contain.
    const QString key = QStringLiteral("macula haloed text|%1|%2|%3|%4|%5")
                            .arg(font.key())
                            .arg(on.device()->logicalDpiY())
                            .arg(ink.rgba(), 0, 16)
                            .arg(pixelRatio)
                            .arg(text);
    if (QPixmapCache::find(key, &kept.picture)) return kept;
    const QSizeF size(kept.begin.x() + std::ceil(letters.right()) + edge,
                      kept.begin.y() + std::ceil(letters.bottom()) + edge);
    kept.picture = QPixmap((size * pixelRatio).toSize());
    kept.picture.setDevicePixelRatio(pixelRatio);
    kept.picture.fill(Qt::transparent);
    {
        QPainter painter(&kept.picture);
        painter.setRenderHint(QPainter::Antialiasing);
        paintText(painter, font, kept.begin, text, ink);
    }
    QPixmapCache::insert(key, kept.picture);
    return kept;
}

}  // namespace

void drawHaloed(QPainter& painter, const QPainterPath& path, const QColor& ink, double widthPx) {
    painter.strokePath(path,
                       QPen(kHalo, widthPx + 2.0 * kHaloPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(ink, widthPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

// Caches texts: outlining letters costs more than everything else on a slice, and most texts do not change
// between pictures.
void drawHaloedText(QPainter& painter, const QPointF& at, const QString& text, const QColor& ink) {
    const bool isShifted = painter.transform().type() <= QTransform::TxTranslate;
    if (!isShifted || QFontMetricsF(painter.font()).horizontalAdvance(text) > kMostKeptPx)
        return paintText(painter, painter.font(), at, text, ink);
    const double pixelRatio = painter.device()->devicePixelRatioF();
    const KeptText kept = keptText(painter, text, ink, pixelRatio);
    // Aligned to device pixels, so that letters stay sharp.
    const auto whole = [&](double px) { return std::round(px * pixelRatio) / pixelRatio; };
    painter.drawPixmap(QPointF(whole(at.x() - kept.begin.x()), whole(at.y() - kept.begin.y())), kept.picture);
}

}  // namespace macula::viewer
