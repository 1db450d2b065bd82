#include "viewer/overlay/slice_overlay.h"

#include <QFontMetricsF>
#include <QRegion>
#include <algorithm>
#include <cmath>
#include <limits>

#include "viewer/overlay/haloed_drawing.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/overlay/overlay_layout.h"
#include "viewer/overlay/slice_texts.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr double kMarginPx = 8.0;         // logical, as all below
constexpr double kCrosshairGapPx = 14.0;  // on each side, so that the centre stays visible
constexpr double kHandlePx = 3.5;
const QColor kInk(235, 235, 235);
const QColor kMeasureInk(120, 210, 255);
const QColor kSelectedInk(255, 225, 90);

QColor inkOf(const ShownMeasurement& shown) {
    return shown.isSelected ? kSelectedInk : kMeasureInk;
}

void addHead(QPainterPath& path, const QPointF& tip, const QPointF& tail) {
    constexpr double kLengthPx = 11.0;
    constexpr double kOpening = 0.42;  // radians to each side
    const QPointF along = tail - tip;
    const double turn = std::atan2(along.y(), along.x());
    for (const double side : {-kOpening, kOpening}) {
        path.moveTo(tip);
        path.lineTo(tip + kLengthPx * QPointF(std::cos(turn + side), std::sin(turn + side)));
    }
}

// Paints one overlay. Places texts first and paints them last: the cross-hair leaves gaps for them, because
// an I on its line would look like a part of it.
class OverlayPainter {
  public:
    OverlayPainter(QPainter& painter, const QSize& size, const SliceOverlay& overlay)
        : painter_(painter),
          size_(size),
          overlay_(overlay),
          font_(overlayFont(painter.font(), size, fontScaleOverPictures())),
          layout_(layOut(overlay, size, painter.font(), fontScaleOverPictures())) {
        placeMeasurementTexts();
    }

    void interpolatedEdges() const;
    void crosshair() const;
    void measurements() const;
    void texts() const;
    void scale() const;

  private:
    void placeMeasurementTexts();
    QPointF placeOf(const glm::dvec3& mm) const {
        const glm::dvec2 px = overlay_.frame.pictureFromWorld(mm) / overlay_.pixelRatio;
        return {px.x, px.y};
    }
    void line(const QPointF& from, const QPointF& to, const QColor& ink) const;
    void halfLine(const QPointF& at, const glm::dvec2& along, const QColor& ink) const;
    QPainterPath pathOf(const ShownMeasurement& shown) const;

    QPainter& painter_;
    QSize size_;
    const SliceOverlay& overlay_;
    QFont font_;
    OverlayLayout layout_;
    std::vector<PlacedText> measured_;
};

void OverlayPainter::line(const QPointF& from, const QPointF& to, const QColor& ink) const {
    QPainterPath path(from);
    path.lineTo(to);
    drawHaloed(painter_, path, ink, 1.0);
}

void OverlayPainter::crosshair() const {
    if (!overlay_.crosshairMm) return;
    QRegion free(QRect(QPoint(0, 0), size_));
    for (const auto* texts : {&layout_.texts, &measured_})
        for (const PlacedText& each : *texts) free -= each.box().toAlignedRect();
    painter_.save();
    painter_.setClipRegion(free, Qt::IntersectClip);
    const QPointF at = placeOf(*overlay_.crosshairMm);
    const QColor vertical = colourOf(verticalOf(overlay_.orientation));
    const QColor horizontal = colourOf(horizontalOf(overlay_.orientation));
    for (const double way : {-1.0, 1.0}) {
        halfLine(at, way * overlay_.lines.vertical, vertical);
        halfLine(at, way * overlay_.lines.horizontal, horizontal);
    }
    painter_.restore();
}

// From the gap around `at` to the edge of the pane, by slabs (Kay and Kajiya).
void OverlayPainter::halfLine(const QPointF& at, const glm::dvec2& along, const QColor& ink) const {
    double from = kCrosshairGapPx;
    double to = std::numeric_limits<double>::infinity();
    const glm::dvec2 start(at.x(), at.y());
    const glm::dvec2 size(size_.width(), size_.height());
    for (int axis = 0; axis < 2; ++axis) {
        if (along[axis] == 0.0) {
            if (start[axis] < 0.0 || start[axis] > size[axis]) return;
            continue;
        }
        const double a = -start[axis] / along[axis];
        const double b = (size[axis] - start[axis]) / along[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (!(from < to) || !std::isfinite(to)) return;
    const auto place = [&](double px) { return QPointF(at.x() + px * along.x, at.y() + px * along.y); };
    line(place(from), place(to), ink);
}

// Dashed, so that nobody mistakes them for the cross-hair.
void OverlayPainter::interpolatedEdges() const {
    painter_.save();
    painter_.setRenderHint(QPainter::Antialiasing, false);  // most lie along rows
    painter_.setPen(QPen(kNoteInk, 1.0, Qt::DashLine));
    for (const slices::PictureLine& edge : overlay_.interpolatedEdges) {
        const glm::dvec2 from = edge.from / overlay_.pixelRatio;
        const glm::dvec2 to = edge.to / overlay_.pixelRatio;
        painter_.drawLine(QPointF(from.x, from.y), QPointF(to.x, to.y));
    }
    painter_.restore();
}

QPainterPath OverlayPainter::pathOf(const ShownMeasurement& shown) const {
    QPainterPath path;
    for (const std::vector<glm::dvec3>& line : linesOf(shown.measurement)) {
        if (line.empty()) continue;
        path.moveTo(placeOf(line.front()));
        for (const glm::dvec3& mm : line) path.lineTo(placeOf(mm));
    }
    if (const auto* arrow = std::get_if<slices::Arrow>(&shown.measurement.shape))
        addHead(path, placeOf(arrow->tipMm), placeOf(arrow->tailMm));
    return path;
}

void OverlayPainter::measurements() const {
    for (const ShownMeasurement& shown : overlay_.measurements) {
        drawHaloed(painter_, pathOf(shown), inkOf(shown), 1.5);
        if (!shown.hasHandles) continue;
        for (const glm::dvec3& mm : handlesOf(shown.measurement)) {
            QPainterPath handle;
            handle.addEllipse(placeOf(mm), kHandlePx, kHandlePx);
            drawHaloed(painter_, handle, inkOf(shown), 1.0);
        }
    }
}

// Beside each measurement if there is room, never outside the pane, and over other texts only if unavoidable.
void OverlayPainter::placeMeasurementTexts() {
    const QFontMetricsF metrics(font_);
    const double lineHeight = metrics.height();
    std::vector<PlacedText> others = layout_.texts;
    for (const ShownMeasurement& shown : overlay_.measurements) {
        if (shown.text.isEmpty()) continue;
        const QRectF around = pathOf(shown).boundingRect();
        const QStringList lines =
            wrapped({shown.text}, font_, std::max(size_.width() - 2.0 * kMarginPx, 0.0));
        QRectF block(0.0, 0.0, 0.0, double(lines.size()) * lineHeight);
        for (const QString& text : lines)
            block.setWidth(std::max(block.width(), metrics.horizontalAdvance(text)));
        const double rightmost = std::max(size_.width() - kMarginPx - block.width(), kMarginPx);
        const double lowest = std::max(size_.height() - kMarginPx - block.height(), 0.0);
        QPointF beside(around.right() + kMarginPx, around.bottom());
        if (const auto* arrow = std::get_if<slices::Arrow>(&shown.measurement.shape)) {
            // Its words are at its tail, on the far side of the tip.
            const QPointF tail = placeOf(arrow->tailMm);
            const bool isRightOfTip = tail.x() >= placeOf(arrow->tipMm).x();
            beside = {isRightOfTip ? tail.x() + kMarginPx : tail.x() - kMarginPx - block.width(),
                      tail.y() - 0.5 * block.height()};
        }
        block.moveTo(std::clamp(beside.x(), kMarginPx, rightmost), std::clamp(beside.y(), 0.0, lowest));
        QPointF at = freePlace(block, size_, lineHeight, others);
        for (const QString& text : lines) {
            measured_.push_back({.at = {at.x(), at.y() + metrics.ascent()},
                                 .text = text,
                                 .ink = inkOf(shown),
                                 .font = font_});
            others.push_back(measured_.back());
            at.ry() += lineHeight;
        }
    }
}

void OverlayPainter::scale() const {
    if (!layout_.scaleBar) return;
    const QRectF& bar = *layout_.scaleBar;
    QPainterPath path(bar.topLeft());
    path.lineTo(bar.bottomLeft());
    path.lineTo(bar.bottomRight());
    path.lineTo(bar.topRight());
    drawHaloed(painter_, path, kInk, 1.5);
}

void OverlayPainter::texts() const {
    for (const auto* texts : {&measured_, &layout_.texts}) {
        for (const PlacedText& each : *texts) {
            painter_.setFont(each.font);
            drawHaloedText(painter_, each.at, each.text, each.ink);
        }
    }
}

}  // namespace

void paintOverlay(QPainter& painter, const QSize& size, const SliceOverlay& overlay) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const OverlayPainter paint(painter, size, overlay);
    paint.interpolatedEdges();
    paint.crosshair();
    paint.measurements();
    paint.scale();
    paint.texts();
    painter.restore();
}

}  // namespace macula::viewer
