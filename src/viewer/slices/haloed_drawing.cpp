#include "viewer/slices/haloed_drawing.h"

#include <QPen>

namespace macula::viewer {

namespace {

const QColor kHalo(0, 0, 0, 190);
constexpr double kHaloPx = 1.5;  // on each side

}  // namespace

void drawHaloed(QPainter& painter, const QPainterPath& path, const QColor& ink, double widthPx) {
    painter.strokePath(path,
                       QPen(kHalo, widthPx + 2.0 * kHaloPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(ink, widthPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

void drawHaloedText(QPainter& painter, const QPointF& at, const QString& text, const QColor& ink) {
    QPainterPath path;
    path.addText(at, painter.font(), text);
    painter.strokePath(path, QPen(kHalo, 2.0 * kHaloPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, ink);
}

}  // namespace macula::viewer
