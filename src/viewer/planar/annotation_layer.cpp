#include "viewer/planar/annotation_layer.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "viewer/language/harmless_text.h"
#include "viewer/overlay/haloed_drawing.h"

namespace macula::viewer {

namespace {

using Kind = dicom::SoftcopyGraphic::Kind;

constexpr int kPieces = 96;         // of a circle
constexpr int kPiecesOfCurve = 12;  // between two points of an interpolated line
constexpr double kPointPx = 3.0;
constexpr double kFarthestPx = 1e6;

// From units of the annotation to the pane.
class Place {
  public:
    Place(const QTransform& paneFromPicture, const QRectF& area) : picture_(paneFromPicture), area_(area) {}

    QPointF operator()(const glm::dvec2& point, dicom::GraphicUnits units) const {
        const QPointF at =
            units == dicom::GraphicUnits::pixel
                ? picture_.map(QPointF(point.x, point.y))
                : QPointF(area_.left() + point.x * area_.width(), area_.top() + point.y * area_.height());
        return {std::clamp(at.x(), -kFarthestPx, kFarthestPx), std::clamp(at.y(), -kFarthestPx, kFarthestPx)};
    }

  private:
    const QTransform& picture_;
    const QRectF& area_;
};

std::vector<glm::dvec2> around(const glm::dvec2& centre, const glm::dvec2& a, const glm::dvec2& b) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPieces;
        points.push_back(centre + std::cos(angle) * a + std::sin(angle) * b);
    }
    return points;
}

// A curve through all points (Catmull-Rom).
std::vector<glm::dvec2> curveThrough(const std::vector<glm::dvec2>& p) {
    std::vector<glm::dvec2> curve{p.front()};
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        const glm::dvec2& before = p[i == 0 ? 0 : i - 1];
        const glm::dvec2& after = p[std::min(i + 2, p.size() - 1)];
        for (int piece = 1; piece <= kPiecesOfCurve; ++piece) {
            const double t = double(piece) / kPiecesOfCurve;
            const glm::dvec2 linear = 0.5 * (p[i + 1] - before);
            const glm::dvec2 square = before - 2.5 * p[i] + 2.0 * p[i + 1] - 0.5 * after;
            const glm::dvec2 cubic = 0.5 * (after - before) + 1.5 * (p[i] - p[i + 1]);
            curve.push_back(p[i] + t * (linear + t * (square + t * cubic)));
        }
    }
    return curve;
}

std::vector<glm::dvec2> outlineOf(const dicom::SoftcopyGraphic& graphic) {
    const std::vector<glm::dvec2>& p = graphic.points;
    switch (graphic.kind) {
        case Kind::circle: {
            const double radius = glm::distance(p[0], p[1]);
            return around(p[0], {radius, 0.0}, {0.0, radius});
        }
        case Kind::ellipse:
            return around(0.5 * (p[0] + p[1]), 0.5 * (p[1] - p[0]), 0.5 * (p[3] - p[2]));
        case Kind::interpolated:
            return curveThrough(p);
        case Kind::point:
        case Kind::polyline:
            break;
    }
    return p;
}

void paintGraphic(QPainter& painter, const dicom::SoftcopyGraphic& graphic, const Place& placeOf,
                  const QColor& ink) {
    QPainterPath path;
    if (graphic.kind == Kind::point) {
        path.addEllipse(placeOf(graphic.points[0], graphic.units), kPointPx, kPointPx);
    } else {
        for (const glm::dvec2& point : outlineOf(graphic)) {
            const QPointF at = placeOf(point, graphic.units);
            if (path.elementCount() == 0)
                path.moveTo(at);
            else
                path.lineTo(at);
        }
    }
    if (graphic.isFilled) painter.fillPath(path, ink);
    drawHaloed(painter, path, ink, 1.5);
}

QRectF boxOf(const dicom::SoftcopyText::Box& box, const Place& placeOf) {
    return QRectF(placeOf(box.topLeft, box.units), placeOf(box.bottomRight, box.units)).normalized();
}

void paintText(QPainter& painter, const dicom::SoftcopyText& text, const Place& placeOf, const QColor& ink) {
    const QFontMetricsF metrics(painter.font());
    const double height = metrics.lineSpacing() * double(text.lines.size());
    QRectF block;
    if (text.box) {
        block = boxOf(*text.box, placeOf);
    } else {
        const QPointF at = placeOf(text.anchor->point, text.anchor->units);
        block = QRectF(at.x() + 2.0 * kPointPx, at.y() - 0.5 * height, 0.0, height);
    }
    if (text.anchor && text.anchor->isVisible) {
        const QPointF at = placeOf(text.anchor->point, text.anchor->units);
        QPainterPath path;
        path.addEllipse(at, kPointPx, kPointPx);
        if (text.box) {
            path.moveTo(at);
            path.lineTo(block.center());
        }
        drawHaloed(painter, path, ink, 1.0);
    }
    double y = block.top() + metrics.ascent();
    for (const std::string& each : text.lines) {
        const QString line = harmless(QString::fromStdString(each));
        const double spare = block.width() - metrics.horizontalAdvance(line);
        double x = block.left();
        if (text.justification == dicom::SoftcopyText::Justification::right) x += spare;
        if (text.justification == dicom::SoftcopyText::Justification::centre) x += 0.5 * spare;
        drawHaloedText(painter, {text.box ? x : block.left(), y}, line, ink);
        y += metrics.lineSpacing();
    }
}

}  // namespace

void AnnotationLayer::paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF& area) {
    const Place placeOf(paneFromPicture, area);
    for (const dicom::SoftcopyAnnotation& annotation : annotations_) {
        const QColor ink(annotation.grey, annotation.grey, annotation.grey);
        for (const dicom::SoftcopyGraphic& graphic : annotation.graphics)
            paintGraphic(painter, graphic, placeOf, ink);
        for (const dicom::SoftcopyText& text : annotation.texts) paintText(painter, text, placeOf, ink);
    }
}

}  // namespace macula::viewer
