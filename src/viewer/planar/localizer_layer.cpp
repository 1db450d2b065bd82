#include "viewer/planar/localizer_layer.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include "study/open/found_volumes.h"
#include "viewer/overlay/haloed_drawing.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMostLines = 24;  // between the first and the last
const QColor kInk(120, 220, 140);
const QColor kLookedAtInk(255, 230, 90);

QPainterPath pathOf(const study::SliceOnLocalizer& slice, const QTransform& paneFromPicture) {
    QPainterPath path;
    for (std::size_t c = 0; c < slice.corners.size(); ++c) {
        const QPointF at = paneFromPicture.map(QPointF(slice.corners[c].x, slice.corners[c].y));
        if (c == 0)
            path.moveTo(at);
        else
            path.lineTo(at);
    }
    path.closeSubpath();
    return path;
}

}  // namespace

void LocalizerLayer::show(const dicom::Frame& frame, const study::OpenedStudy& open,
                          const std::optional<glm::dvec3>& crosshairMm) {
    hide();
    if (!frame.plane || !open.volume || !open.found || frame.frameOfReferenceUid.empty()) return;
    const dicom::Stack& stack = *open.found->volumes().at(open.volumeIndex).stack;
    if (study::frameOfReferenceOf(stack) != frame.frameOfReferenceUid) return;
    slices_ = study::slicesOn(*frame.plane, *open.volume);
    lookedAt_.reset();
    if (crosshairMm) lookedAt_ = study::sliceNearest(*crosshairMm, *open.volume);
}

// All lines of a thin stack; of many slices some, so that the localizer stays visible.
void LocalizerLayer::paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF&) {
    if (slices_.empty()) return;
    const std::size_t step = (slices_.size() + kMostLines - 1) / kMostLines;
    const auto draw = [&](const study::SliceOnLocalizer& slice, const QColor& ink, double width,
                          bool isNamed) {
        const QPainterPath path = pathOf(slice, paneFromPicture);
        drawHaloed(painter, path, ink, width);
        const QFontMetricsF metrics(painter.font());
        if (isNamed)
            drawHaloedText(painter, path.boundingRect().topRight() + QPointF(4.0, 0.5 * metrics.ascent()),
                           QString::number(slice.slice + 1), ink);
    };
    for (std::size_t i = 0; i < slices_.size(); i += step) draw(slices_[i], kInk, 0.75, false);
    draw(slices_.front(), kInk, 1.5, true);
    draw(slices_.back(), kInk, 1.5, true);
    if (lookedAt_ && std::size_t(*lookedAt_) < slices_.size())
        draw(slices_[std::size_t(*lookedAt_)], kLookedAtInk, 1.5, true);
}

}  // namespace macula::viewer
