// Lines and letters that are legible on white and on black.
#pragma once

#include <QColor>
#include <QPainter>
#include <QPainterPath>
#include <QString>

namespace macula::viewer {

// Draws the path in `ink` over a wider dark line. The painter must use antialiasing.
void drawHaloed(QPainter& painter, const QPainterPath& path, const QColor& ink, double widthPx);

// Draws text in the painter's font; its base line begins at `at`.
void drawHaloedText(QPainter& painter, const QPointF& at, const QString& text, const QColor& ink);

}  // namespace macula::viewer
