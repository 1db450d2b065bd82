#include "viewer/slices/clip_on_slice.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "scene/clip/eye_cut.h"
#include "viewer/overlay/haloed_drawing.h"

namespace macula::viewer {

namespace {

constexpr double kHandlePx = 5.0;  // logical, as all below: half the side of a square
constexpr double kLinePx = 1.5;
const QColor kDim(0, 0, 0, 150);
const QColor kClipInk(255, 150, 60);
const QColor kHeldInk(255, 225, 90);

// Converts device pixels to logical pixels of the painter.
class Places {
  public:
    explicit Places(double pixelRatio) : ratio_(pixelRatio) {}
    QPointF operator()(const glm::dvec2& px) const { return {px.x / ratio_, px.y / ratio_}; }

    void add(QPainterPath& path, const scene::Contour& contour) const {
        QPolygonF polygon;
        for (const glm::dvec2& px : contour) polygon << (*this)(px);
        path.addPolygon(polygon);
        path.closeSubpath();
    }

  private:
    double ratio_;
};

QImage imageOf(const QSize& size, double pixelRatio) {
    QImage image(size * pixelRatio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(pixelRatio);
    return image;
}

// Dims the whole picture except what the path encloses.
void dimAround(QPainter& painter, const QSize& size, double pixelRatio, const QPainterPath& path) {
    QImage around = imageOf(size, pixelRatio);
    if (around.isNull()) return;  // no memory for the image: the outline is still drawn
    around.fill(kDim);
    QPainter cut(&around);
    cut.setRenderHint(QPainter::Antialiasing);
    cut.setCompositionMode(QPainter::CompositionMode_Clear);
    cut.fillPath(path, Qt::black);
    cut.end();
    painter.drawImage(QPointF(0.0, 0.0), around);
}

void dim(QPainter& painter, const QSize& size, double pixelRatio, const ClipOnSlice& clip) {
    const Places at(pixelRatio);
    QPainterPath removed;
    removed.setFillRule(Qt::WindingFill);
    for (const scene::Contour& contour : clip.removed) at.add(removed, contour);
    painter.fillPath(removed, kDim);
    for (const ClipOnSlice::Scissors& scissors : clip.scissors) {
        QPainterPath behind;
        behind.setFillRule(Qt::WindingFill);
        for (const scene::Contour& contour : scissors.behind) at.add(behind, contour);
        if (scissors.removesOutside) {
            dimAround(painter, size, pixelRatio, behind);
        } else {
            painter.fillPath(behind, kDim);
        }
    }
}

void drawLine(QPainter& painter, const scene::Contour& line, const Places& at) {
    QPainterPath path;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i == 0) {
            path.moveTo(at(line[i]));
        } else {
            path.lineTo(at(line[i]));
        }
    }
    drawHaloed(painter, path, kClipInk, kLinePx);
}

}  // namespace

ClipOnSlice clipOnSlice(const scene::StudyState& state, const Volume& volume, const slices::SliceFrame& frame,
                        bool withHandles) {
    ClipOnSlice shown;
    if (state.clip || state.cuts.eye) {
        shown.removed = scene::removedContours(scene::clipFor(state.clip, state.cuts, volume), frame);
        shown.lines = scene::clipLines(state.clip, state.cuts, volume, frame);
    }
    for (const scene::ScissorCut& cut : state.cuts.scissors) {
        std::vector<scene::Contour> behind = scene::behindOutline(cut, frame);
        if (behind.empty() && !cut.removesOutside) continue;
        for (const scene::Contour& contour : behind) {
            shown.lines.push_back(contour);
            shown.lines.back().push_back(contour.front());
        }
        shown.scissors.push_back({.behind = std::move(behind), .removesOutside = cut.removesOutside});
    }
    if (withHandles) shown.handles = scene::handlesOn(frame, state.clip, state.cuts, volume);
    return shown;
}

const QImage& ClipDimming::imageFor(const ClipOnSlice& clip, const QSize& size, double pixelRatio) {
    if (clip.removed == removed_ && clip.scissors == scissors_ && size == size_ && pixelRatio == pixelRatio_)
        return image_;
    removed_ = clip.removed;
    scissors_ = clip.scissors;
    size_ = size;
    pixelRatio_ = pixelRatio;
    image_ = {};
    if (removed_.empty() && scissors_.empty()) return image_;
    image_ = imageOf(size, pixelRatio);
    if (image_.isNull()) return image_;
    image_.fill(Qt::transparent);
    QPainter painter(&image_);
    painter.setRenderHint(QPainter::Antialiasing);
    dim(painter, size, pixelRatio, clip);
    return image_;
}

void paintClip(QPainter& painter, const QSize& size, const ClipOnSlice& clip, const slices::SliceFrame& frame,
               double pixelRatio, ClipDimming& dimming) {
    if (clip.isNothing()) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const Places at(pixelRatio);
    if (const QImage& dimmed = dimming.imageFor(clip, size, pixelRatio); !dimmed.isNull())
        painter.drawImage(QPointF(0.0, 0.0), dimmed);
    for (const scene::Contour& line : clip.lines) drawLine(painter, line, at);
    for (const scene::PlacedHandle& handle : clip.handles) {
        const QPointF middle = at(frame.pictureFromWorld(handle.atMm));
        QPainterPath square;
        if (handle.along == glm::dvec3(0.0)) {
            square.addEllipse(middle, kHandlePx, kHandlePx);
        } else {
            square.addRect(
                QRectF(middle.x() - kHandlePx, middle.y() - kHandlePx, 2.0 * kHandlePx, 2.0 * kHandlePx));
        }
        const QColor ink = clip.held == handle.handle ? kHeldInk : kClipInk;
        drawHaloed(painter, square, ink, kLinePx);
        if (clip.held == handle.handle) painter.fillPath(square, ink);
    }
    painter.restore();
}

std::optional<scene::PlacedHandle> handleAt(const std::vector<scene::PlacedHandle>& handles,
                                            const slices::SliceFrame& frame, const glm::dvec2& px,
                                            double radiusPx) {
    std::optional<scene::PlacedHandle> nearest;
    double least = radiusPx;
    for (const scene::PlacedHandle& handle : handles) {
        const double away = glm::distance(frame.pictureFromWorld(handle.atMm), px);
        if (!(away <= least)) continue;
        least = away;
        nearest = handle;
    }
    return nearest;
}

Qt::CursorShape cursorAlong(const glm::dvec2& along) {
    if (!(glm::length(along) > 0.0)) return Qt::SizeAllCursor;
    constexpr double kDiagonal = 0.4142;  // the tangent of 22.5 degrees
    const glm::dvec2 size = glm::abs(along);
    if (size.y < kDiagonal * size.x) return Qt::SizeHorCursor;
    if (size.x < kDiagonal * size.y) return Qt::SizeVerCursor;
    return (along.x > 0.0) == (along.y > 0.0) ? Qt::SizeFDiagCursor : Qt::SizeBDiagCursor;
}

Qt::CursorShape cursorOf(const scene::PlacedHandle& handle, const slices::SlicePlane& plane) {
    return cursorAlong({glm::dot(handle.along, plane.right), glm::dot(handle.along, plane.down)});
}

}  // namespace macula::viewer
