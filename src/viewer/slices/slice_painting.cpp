#include "viewer/slices/slice_painting.h"

#include <utility>

#include "viewer/language/harmless_text.h"
#include "viewer/slices/picture_texts.h"

namespace macula::viewer {

namespace {

constexpr int kFocusPx = 2;
constexpr int kSecondPx = 2;
const QColor kSecondInk(255, 190, 90);  // as notes over slices
const QColor kQuietInk(150, 150, 150);

void paintEdge(QPainter& painter, const QRect& pane, const QColor& ink, int widthPx, int insetPx) {
    painter.setPen(QPen(ink, widthPx, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(pane.adjusted(insetPx, insetPx, -insetPx, -insetPx));
}

}  // namespace

QString SlicePainting::noStudyText() {
    return tr("No study is open");
}

void SlicePainting::setLines(const QStringList& lines) {
    lines_.clear();
    for (const QString& line : lines) {
        const QString shown = harmless(line);
        if (!shown.isEmpty()) lines_.push_back(shown);
    }
}

void SlicePainting::paint(QPainter& painter, const QRect& pane, const QStringList& notes,
                          const std::optional<QPointF>& pointedAt) {
    painter.fillRect(pane, Qt::black);
    if (!parts_.content.hasStudy()) {
        painter.setPen(kQuietInk);
        painter.drawText(pane, Qt::AlignCenter | Qt::TextWordWrap, noStudyText());
        return;
    }
    if (parts_.picture.shown() == nullptr) return;
    const SlicePicture& shown = *parts_.picture.shown();
    const QRectF whole(QPointF(0.0, 0.0), QSizeF(shown.grey.size()) / shown.of.pixelRatio);
    painter.drawImage(whole, shown.grey);
    if (!shown.segments.isNull()) painter.drawImage(whole, shown.segments);
    if (!shown.colours.isNull()) painter.drawImage(whole, shown.colours);
    parts_.clip.paint(painter, pane.size(), shown.of, pointedAt);
    paintOverlay(painter, pane.size(), overlay(notes, pointedAt));
    // Marks the second volume, so that nobody mistakes it for the study at a glance.
    if (!shown.of.showsStudy()) paintEdge(painter, pane, kSecondInk, kSecondPx, kFocusPx + kSecondPx / 2);
}

void SlicePainting::paintRing(QPainter& painter, const QPointF& pointedAt, double radiusMm) const {
    const SliceRequest* shown = parts_.picture.shown() != nullptr ? parts_.picture.shownRequest() : nullptr;
    if (!(radiusMm > 0.0) || shown == nullptr || !shown->showsStudy()) return;
    const double radiusPx = radiusMm / (shown->frame.mmPerPixel * shown->pixelRatio);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& [ink, widthPx] :
         {std::pair(QColor(Qt::black), 3.0), std::pair(QColor(Qt::white), 1.2)}) {
        painter.setPen(QPen(ink, widthPx));
        painter.drawEllipse(pointedAt, radiusPx, radiusPx);
    }
    painter.restore();
}

void SlicePainting::paintFocus(QPainter& painter, const QRect& pane, const QColor& ink) {
    paintEdge(painter, pane, ink, kFocusPx, kFocusPx / 2);
}

SliceOverlay SlicePainting::overlay(const QStringList& notes, const std::optional<QPointF>& pointedAt) {
    const SliceRequest& shown = *parts_.picture.shownRequest();
    SliceOverlay overlay = overlayOf(shown, parts_.content.orientation(), pointedAt);
    overlay.notes = notes;
    overlay.measurements = parts_.measurements.seenOn(shown);
    if (namesShown_) overlay.names = shown.showsStudy() ? lines_ : shown.names;
    // Shows the session's cross-hair, unless its slice may not be on screen yet.
    const SliceRequest* wanted = parts_.picture.wanted();
    if (wanted != nullptr && wanted->frame == shown.frame) overlay.crosshairMm = parts_.content.crosshairMm();
    if (shown.shows == SliceShows::secondByHand) overlay.crosshairMm.reset();
    return overlay;
}

}  // namespace macula::viewer
