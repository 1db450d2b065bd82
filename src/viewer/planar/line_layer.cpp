#include "viewer/planar/line_layer.h"

#include <QPainter>
#include <QPainterPath>

#include "viewer/overlay/haloed_drawing.h"

namespace macula::viewer {

void LineLayer::paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF&) {
    if (!outline_) return;
    QPolygonF outline;
    for (const glm::dvec2& corner : *outline_) outline += paneFromPicture.map(QPointF(corner.x, corner.y));
    QPainterPath path;
    path.addPolygon(outline);
    path.closeSubpath();
    drawHaloed(painter, path, QColor(255, 230, 90), 1.0);
}

}  // namespace macula::viewer
