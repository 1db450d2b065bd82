#include "viewer/slices/slice_overlay.h"

#include <QFontMetricsF>
#include <algorithm>

#include "viewer/slices/haloed_drawing.h"
#include "viewer/slices/measurement_handles.h"
#include "viewer/slices/scale_bar.h"
#include "viewer/slices/slice_texts.h"

namespace macula::viewer {

namespace {

constexpr double kMarginPx = 8.0;  // logical, as all below
constexpr int kFontPx = 13;
constexpr int kLetterPx = 16;
constexpr double kCrosshairGapPx = 14.0;  // to each side: what lies under the cross is seen
constexpr double kHandlePx = 3.5;
constexpr double kLongestBarPx = 120.0;
constexpr double kLongestBarOfPane = 0.3;
const QColor kInk(235, 235, 235);
const QColor kNoteInk(255, 190, 90);
const QColor kMeasureInk(120, 210, 255);
const QColor kSelectedInk(255, 225, 90);

// Paints one overlay; knows how much room its blocks of lines take.
class OverlayPainter {
  public:
    OverlayPainter(QPainter& painter, const QSize& size, const SliceOverlay& overlay)
        : painter_(painter), size_(size), overlay_(overlay), font_(painter.font()) {
        font_.setPixelSize(kFontPx);
        painter_.setFont(font_);
    }

    void crosshair() const;
    void measurements() const;
    void names();
    void notes();
    void facts();
    void scale() const;
    void letters();

  private:
    QPointF placeOf(const glm::dvec3& mm) const {
        const glm::dvec2 px = overlay_.frame.pictureFromWorld(mm) / overlay_.pixelRatio;
        return {px.x, px.y};
    }
    QString elided(const QString& line, double roomPx) const {
        return QFontMetricsF(font_).elidedText(line, Qt::ElideRight, roomPx);
    }
    double roomPx() const { return std::max(size_.width() - 2.0 * kMarginPx, 0.0); }
    // Lines that are longer come upon the letters in the middle.
    double reachPx() const { return 0.5 * size_.width() - kMarginPx - 2.0 * kLetterPx; }
    double lineHeight() const { return QFontMetricsF(font_).height(); }
    double widest(const QStringList& lines) const;
    void line(const QPointF& from, const QPointF& to, const QColor& ink) const;
    void measurement(const ShownMeasurement& shown) const;

    QPainter& painter_;
    QSize size_;
    const SliceOverlay& overlay_;
    QFont font_;
    double topLines_ = 0.0;  // of those above that reach the middle
    double factsWidth_ = 0.0;
};

double OverlayPainter::widest(const QStringList& lines) const {
    double width = 0.0;
    for (const QString& text : lines)
        width = std::max(width, QFontMetricsF(font_).horizontalAdvance(elided(text, roomPx())));
    return width;
}

void OverlayPainter::line(const QPointF& from, const QPointF& to, const QColor& ink) const {
    QPainterPath path(from);
    path.lineTo(to);
    drawHaloed(painter_, path, ink, 1.0);
}

void OverlayPainter::crosshair() const {
    if (!overlay_.crosshairMm) return;
    const QPointF at = placeOf(*overlay_.crosshairMm);
    const double width = size_.width();
    const double height = size_.height();
    const QColor vertical = colourOf(verticalOf(overlay_.orientation));
    const QColor horizontal = colourOf(horizontalOf(overlay_.orientation));
    if (at.x() >= 0.0 && at.x() <= width) {
        if (at.y() > kCrosshairGapPx)
            line({at.x(), 0.0}, {at.x(), std::min(at.y() - kCrosshairGapPx, height)}, vertical);
        if (at.y() < height - kCrosshairGapPx)
            line({at.x(), std::max(at.y() + kCrosshairGapPx, 0.0)}, {at.x(), height}, vertical);
    }
    if (at.y() >= 0.0 && at.y() <= height) {
        if (at.x() > kCrosshairGapPx)
            line({0.0, at.y()}, {std::min(at.x() - kCrosshairGapPx, width), at.y()}, horizontal);
        if (at.x() < width - kCrosshairGapPx)
            line({std::max(at.x() + kCrosshairGapPx, 0.0), at.y()}, {width, at.y()}, horizontal);
    }
}

void OverlayPainter::measurement(const ShownMeasurement& shown) const {
    const QColor ink = shown.isSelected ? kSelectedInk : kMeasureInk;
    QPainterPath path;
    for (const glm::dvec3& mm : outlineOf(shown.measurement)) {
        const QPointF at = placeOf(mm);
        if (path.elementCount() == 0) {
            path.moveTo(at);
        } else {
            path.lineTo(at);
        }
    }
    const QRectF around = path.boundingRect();
    drawHaloed(painter_, path, ink, 1.5);
    for (const glm::dvec3& mm : handlesOf(shown.measurement)) {
        QPainterPath handle;
        handle.addEllipse(placeOf(mm), kHandlePx, kHandlePx);
        drawHaloed(painter_, handle, ink, 1.0);
    }
    // Beside it where there is room, and never outside of the pane.
    const QString text = elided(shown.text, roomPx());
    const double width = QFontMetricsF(font_).horizontalAdvance(text);
    const double rightmost = std::max(size_.width() - kMarginPx - width, kMarginPx);
    const QPointF at(std::clamp(around.right() + kMarginPx, kMarginPx, rightmost),
                     std::clamp(around.bottom() + lineHeight(), lineHeight(),
                                std::max(size_.height() - kMarginPx, lineHeight())));
    drawHaloedText(painter_, at, text, ink);
}

void OverlayPainter::measurements() const {
    for (const ShownMeasurement& shown : overlay_.measurements) measurement(shown);
}

void OverlayPainter::names() {
    if (widest(overlay_.names) > reachPx()) topLines_ = double(overlay_.names.size());
    double base = kMarginPx + QFontMetricsF(font_).ascent();
    for (const QString& text : overlay_.names) {
        drawHaloedText(painter_, {kMarginPx, base}, elided(text, roomPx()), kInk);
        base += lineHeight();
    }
}

// Below the names where both do not fit beside each other.
void OverlayPainter::notes() {
    const bool fits = widest(overlay_.names) + widest(overlay_.notes) + 2.0 * kMarginPx < roomPx();
    const double first = fits ? 0.0 : double(overlay_.names.size());
    if (widest(overlay_.notes) > reachPx())
        topLines_ = std::max(topLines_, first + double(overlay_.notes.size()));
    double base = kMarginPx + QFontMetricsF(font_).ascent() + first * lineHeight();
    for (const QString& text : overlay_.notes) {
        const QString shown = elided(text, roomPx());
        const double width = QFontMetricsF(font_).horizontalAdvance(shown);
        drawHaloedText(painter_, {size_.width() - kMarginPx - width, base}, shown, kNoteInk);
        base += lineHeight();
    }
}

void OverlayPainter::facts() {
    factsWidth_ = widest(overlay_.facts);
    double base = size_.height() - kMarginPx - QFontMetricsF(font_).descent() -
                  double(overlay_.facts.size() - 1) * lineHeight();
    for (const QString& text : overlay_.facts) {
        drawHaloedText(painter_, {kMarginPx, base}, elided(text, roomPx()), kInk);
        base += lineHeight();
    }
}

// Above the facts where they leave no room beside them.
void OverlayPainter::scale() const {
    const double mostPx = std::min(kLongestBarPx, kLongestBarOfPane * size_.width());
    const auto bar = scaleBar(overlay_.frame.mmPerPixel * overlay_.pixelRatio, mostPx);
    if (!bar) return;
    const double right = size_.width() - kMarginPx;
    const double textWidth = QFontMetricsF(font_).horizontalAdvance(bar->text);
    const double needed = std::max(bar->lengthPx, textWidth) + 2.0 * kMarginPx;
    double bottom = size_.height() - kMarginPx - 2.0;
    if (kMarginPx + factsWidth_ + needed > size_.width())
        bottom -= double(overlay_.facts.size()) * lineHeight() + kMarginPx;
    constexpr double kTick = 5.0;
    QPainterPath path(QPointF(right - bar->lengthPx, bottom - kTick));
    path.lineTo(right - bar->lengthPx, bottom);
    path.lineTo(right, bottom);
    path.lineTo(right, bottom - kTick);
    drawHaloed(painter_, path, kInk, 1.5);
    drawHaloedText(painter_, {right - textWidth, bottom - kTick - 3.0}, bar->text, kInk);
}

// In the middle of each side; those above and below give way to lines that reach so far.
void OverlayPainter::letters() {
    const app::EdgeLetters sides = edgeLetters(overlay_.frame.plane);
    QFont font = font_;
    font.setPixelSize(kLetterPx);
    font.setBold(true);
    painter_.setFont(font);
    const QFontMetricsF metrics(font);
    const auto draw = [&](const std::string& letters, const auto& leftOf, double base) {
        const QString text = QString::fromStdString(letters);
        drawHaloedText(painter_, {leftOf(metrics.horizontalAdvance(text)), base}, text, kInk);
    };
    const double width = size_.width();
    const double middle = 0.5 * size_.height() + 0.5 * metrics.capHeight();
    const auto centred = [&](double letterWidth) { return 0.5 * (width - letterWidth); };
    const double top = kMarginPx + metrics.ascent() + topLines_ * lineHeight();
    double bottom = size_.height() - kMarginPx - metrics.descent();
    if (factsWidth_ > reachPx()) bottom -= double(overlay_.facts.size()) * lineHeight();
    draw(
        sides.left, [](double) { return kMarginPx; }, middle);
    draw(
        sides.right, [&](double letterWidth) { return width - kMarginPx - letterWidth; }, middle);
    draw(sides.top, centred, top);
    draw(sides.bottom, centred, bottom);
    painter_.setFont(font_);
}

}  // namespace

void paintOverlay(QPainter& painter, const QSize& size, const SliceOverlay& overlay) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    OverlayPainter paint(painter, size, overlay);
    paint.crosshair();
    paint.measurements();
    paint.names();
    paint.notes();
    paint.facts();
    paint.scale();
    paint.letters();
    painter.restore();
}

}  // namespace macula::viewer
