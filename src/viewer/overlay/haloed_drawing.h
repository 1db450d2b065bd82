// Lines and letters that read on white as on black.
#pragma once

#include <QColor>
#include <QPainter>
#include <QPainterPath>
#include <QString>

namespace macula::viewer {

// In the colour, on something dark that is wider. The painter must smooth edges.
void drawHaloed(QPainter& painter, const QPainterPath& path, const QColor& ink, double widthPx);

// With the painter's font, its base line beginning there.
void drawHaloedText(QPainter& painter, const QPointF& at, const QString& text, const QColor& ink);

}  // namespace macula::viewer
