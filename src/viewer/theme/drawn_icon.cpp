#include "viewer/theme/drawn_icon.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>
#include <algorithm>
#include <initializer_list>

namespace macula::viewer {

namespace {

// Glyphs are drawn on a square of 24 by 24, y down. Lines are 2 wide and lie on whole numbers, so that they
// fill whole pixels at 24 and 48.
constexpr double kSide = 24.0;
constexpr double kPen = 2.0;

void drawLines(QPainter& painter, std::initializer_list<QPointF> points) {
    painter.drawPolyline(points.begin(), int(points.size()));
}

void fillShape(QPainter& painter, std::initializer_list<QPointF> points) {
    painter.save();
    painter.setBrush(painter.pen().color());
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(points.begin(), int(points.size()));
    painter.restore();
}

void fillDot(QPainter& painter, const QPointF& middle, double radius) {
    painter.save();
    painter.setBrush(painter.pen().color());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(middle, radius, radius);
    painter.restore();
}

void drawCrosshair(QPainter& painter) {
    painter.drawLine(QPointF(12, 2), QPointF(12, 9));
    painter.drawLine(QPointF(12, 15), QPointF(12, 22));
    painter.drawLine(QPointF(2, 12), QPointF(9, 12));
    painter.drawLine(QPointF(15, 12), QPointF(22, 12));
}

// A circle half dark and half bright, the usual sign for contrast.
void drawWindow(QPainter& painter) {
    const QRectF circle(3, 3, 18, 18);
    painter.drawEllipse(circle);
    QPainterPath half;
    half.moveTo(12, 3);
    half.arcTo(circle, 90, -180);
    painter.fillPath(half, painter.pen().color());
}

void drawZoom(QPainter& painter) {
    painter.drawEllipse(QPointF(10, 10), 7, 7);
    painter.drawLine(QPointF(15, 15), QPointF(21, 21));
    painter.drawLine(QPointF(7, 10), QPointF(13, 10));
    painter.drawLine(QPointF(10, 7), QPointF(10, 13));
}

void drawPan(QPainter& painter) {
    painter.drawLine(QPointF(12, 3), QPointF(12, 21));
    painter.drawLine(QPointF(3, 12), QPointF(21, 12));
    drawLines(painter, {{9, 6}, {12, 3}, {15, 6}});
    drawLines(painter, {{9, 18}, {12, 21}, {15, 18}});
    drawLines(painter, {{6, 9}, {3, 12}, {6, 15}});
    drawLines(painter, {{18, 9}, {21, 12}, {18, 15}});
}

void drawDistance(QPainter& painter) {
    painter.drawLine(QPointF(3, 12), QPointF(21, 12));
    painter.drawLine(QPointF(3, 7), QPointF(3, 17));
    painter.drawLine(QPointF(21, 7), QPointF(21, 17));
}

// A long line, and a short one across it.
void drawBidirectional(QPainter& painter) {
    painter.drawLine(QPointF(3, 20), QPointF(20, 3));
    painter.drawLine(QPointF(7, 7), QPointF(16, 16));
}

void drawAngle(QPainter& painter) {
    drawLines(painter, {{17, 3}, {4, 20}, {22, 20}});
    painter.drawArc(QRectF(-6, 10, 20, 20), 0, 16 * 52);
}

void drawCobb(QPainter& painter) {
    painter.drawLine(QPointF(3, 9), QPointF(21, 3));
    painter.drawLine(QPointF(3, 15), QPointF(21, 21));
}

void drawOutline(QPainter& painter) {
    QPainterPath path(QPointF(5, 8));
    path.cubicTo(QPointF(9, 0), QPointF(20, 2), QPointF(20, 10));
    path.cubicTo(QPointF(20, 16), QPointF(14, 13), QPointF(14, 18));
    path.cubicTo(QPointF(13, 24), QPointF(0, 18), QPointF(5, 8));
    painter.drawPath(path);
}

void drawLine(QPainter& painter) {
    QPainterPath path(QPointF(3, 16));
    path.cubicTo(QPointF(8, 2), QPointF(12, 6), QPointF(12, 12));
    path.cubicTo(QPointF(12, 20), QPointF(18, 20), QPointF(21, 8));
    painter.drawPath(path);
}

void drawArrow(QPainter& painter) {
    painter.drawLine(QPointF(20, 4), QPointF(5, 19));
    drawLines(painter, {{5, 10}, {5, 19}, {14, 19}});
}

void drawEllipse(QPainter& painter) {
    painter.drawEllipse(QPointF(12, 12), 10, 6);
    fillDot(painter, {12, 12}, 1.5);
}

// A point and the value beside it.
void drawProbe(QPainter& painter) {
    fillDot(painter, {6, 18}, 3);
    drawLines(painter, {{8, 16}, {12, 12}});
    painter.drawRect(QRectF(12, 4, 9, 8));
}

// A brush over what it has painted.
void drawSegment(QPainter& painter) {
    fillDot(painter, {8, 16}, 6);
    painter.drawLine(QPointF(11, 13), QPointF(21, 3));
}

// The values across a slab, and the one that the projection takes.
void drawSlab(QPainter& painter, double takenAtY, double fromX, double toX) {
    QPainterPath curve;
    curve.moveTo(3, 13);
    curve.cubicTo(7, 1, 10, 1, 12, 12);
    curve.cubicTo(14, 23, 17, 23, 21, 12);
    painter.drawPath(curve);
    painter.drawLine(QPointF(fromX, takenAtY), QPointF(toX, takenAtY));
}

void drawInvert(QPainter& painter) {
    painter.drawRect(QRectF(3, 3, 18, 18));
    fillShape(painter, {{3, 3}, {21, 3}, {3, 21}});
}

// Oblique slices, as the scanner acquired them.
void drawAcquired(QPainter& painter) {
    for (const double y : {6.0, 12.0, 18.0}) painter.drawLine(QPointF(4, y + 2), QPointF(20, y - 3));
}

// A turned cross, and the straight one that it returns to.
void drawStraight(QPainter& painter) {
    painter.drawLine(QPointF(12, 3), QPointF(12, 21));
    painter.drawLine(QPointF(3, 12), QPointF(21, 12));
    painter.drawArc(QRectF(5, 5, 14, 14), 20 * 16, 50 * 16);
    painter.drawArc(QRectF(5, 5, 14, 14), 200 * 16, 50 * 16);
}

void drawCurve(QPainter& painter) {
    QPainterPath path(QPointF(4, 19));
    path.cubicTo(QPointF(6, 4), QPointF(16, 22), QPointF(20, 5));
    painter.drawPath(path);
    for (const QPointF& at : {QPointF(4, 19), QPointF(12, 12.5), QPointF(20, 5)})
        painter.drawEllipse(at, 1.5, 1.5);
}

void drawFourPanes(QPainter& painter) {
    painter.drawRect(QRectF(3, 3, 18, 18));
    painter.drawLine(QPointF(12, 3), QPointF(12, 21));
    painter.drawLine(QPointF(3, 12), QPointF(21, 12));
}

void drawCube(QPainter& painter) {
    painter.drawRect(QRectF(3, 9, 12, 12));
    drawLines(painter, {{3, 9}, {9, 3}, {21, 3}, {15, 9}});
    drawLines(painter, {{21, 3}, {21, 15}, {15, 21}});
}

// A cube seen from the front, right and above, with a plane through its middle.
void drawPlane(QPainter& painter, std::initializer_list<QPointF> plane) {
    painter.save();
    QPen thin = painter.pen();
    thin.setWidthF(0.5 * kPen);
    painter.setPen(thin);
    drawCube(painter);
    painter.restore();
    fillShape(painter, plane);
}

void drawCine(QPainter& painter) {
    fillShape(painter, {{7, 4}, {20, 12}, {7, 20}});
    painter.drawLine(QPointF(4, 4), QPointF(4, 20));
}

void drawGlyph(QPainter& painter, Glyph glyph) {
    switch (glyph) {
        case Glyph::crosshair:
            return drawCrosshair(painter);
        case Glyph::window:
            return drawWindow(painter);
        case Glyph::zoom:
            return drawZoom(painter);
        case Glyph::pan:
            return drawPan(painter);
        case Glyph::distance:
            return drawDistance(painter);
        case Glyph::bidirectional:
            return drawBidirectional(painter);
        case Glyph::angle:
            return drawAngle(painter);
        case Glyph::cobb:
            return drawCobb(painter);
        case Glyph::ellipse:
            return drawEllipse(painter);
        case Glyph::outline:
            return drawOutline(painter);
        case Glyph::line:
            return drawLine(painter);
        case Glyph::arrow:
            return drawArrow(painter);
        case Glyph::probe:
            return drawProbe(painter);
        case Glyph::segment:
            return drawSegment(painter);
        case Glyph::slabMean:
            return drawSlab(painter, 12, 2, 22);
        case Glyph::slabMaximum:
            return drawSlab(painter, 4, 2, 14);
        case Glyph::slabMinimum:
            return drawSlab(painter, 20, 10, 22);
        case Glyph::invert:
            return drawInvert(painter);
        case Glyph::acquired:
            return drawAcquired(painter);
        case Glyph::straight:
            return drawStraight(painter);
        case Glyph::curve:
            return drawCurve(painter);
        case Glyph::fourPanes:
            return drawFourPanes(painter);
        case Glyph::volume:
            return drawCube(painter);
        case Glyph::axial:
            return drawPlane(painter, {{3, 15}, {9, 9}, {21, 9}, {15, 15}});
        case Glyph::coronal:
            return drawPlane(painter, {{6, 6}, {18, 6}, {18, 18}, {6, 18}});
        case Glyph::sagittal:
            return drawPlane(painter, {{9, 9}, {15, 3}, {15, 15}, {9, 21}});
        case Glyph::cine:
            return drawCine(painter);
    }
}

QColor colourOf(QIcon::Mode mode, QIcon::State state) {
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
    return palette.color(QPalette::Active,
                         state == QIcon::On ? QPalette::HighlightedText : QPalette::ButtonText);
}

class GlyphEngine : public QIconEngine {
  public:
    explicit GlyphEngine(Glyph glyph) : glyph_(glyph) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const double side = std::min(rect.width(), rect.height());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.x() + 0.5 * (rect.width() - side), rect.y() + 0.5 * (rect.height() - side));
        painter->scale(side / kSide, side / kSide);
        painter->setPen(QPen(colourOf(mode, state), kPen, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->setBrush(Qt::NoBrush);
        drawGlyph(*painter, glyph_);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap drawn(size);  // in device pixels
        drawn.fill(Qt::transparent);
        QPainter painter(&drawn);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return drawn;
    }
    QIconEngine* clone() const override { return new GlyphEngine(glyph_); }

  private:
    Glyph glyph_;
};

}  // namespace

QIcon drawnIcon(Glyph glyph) {
    return QIcon(new GlyphEngine(glyph));
}

}  // namespace macula::viewer
