#include "viewer/slices/slice_overlay.h"

#include <QFontMetricsF>
#include <QRegion>
#include <algorithm>
#include <cmath>

#include "viewer/slices/haloed_drawing.h"
#include "viewer/slices/measurement_handles.h"
#include "viewer/slices/scale_bar.h"
#include "viewer/slices/slice_texts.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr double kMarginPx = 8.0;  // logical, as all below
constexpr int kFontPx = 13;
constexpr int kLetterPx = 16;
constexpr double kCrosshairGapPx = 14.0;  // to each side: what lies under the cross is seen
constexpr double kHandlePx = 3.5;
constexpr double kLongestBarPx = 120.0;
constexpr double kLongestBarOfPane = 0.3;
constexpr double kBarTickPx = 5.0;
constexpr double kAroundTextPx = 2.0;  // that the cross-hair leaves free
constexpr qsizetype kMostLines = 4;    // of one text that must not be cut off
const QColor kInk(235, 235, 235);
const QColor kNoteInk(255, 190, 90);
const QColor kMeasureInk(120, 210, 255);
const QColor kSelectedInk(255, 225, 90);

QColor inkOf(const ShownMeasurement& shown) {
    return shown.isSelected ? kSelectedInk : kMeasureInk;
}

// A line of text and where it begins, on its base line.
struct PlacedText {
    QPointF at;
    QString text;
    QColor ink;
    QFont font;

    QRectF box() const {
        const QFontMetricsF metrics(font);
        const QRectF line(at.x(), at.y() - metrics.ascent(), metrics.horizontalAdvance(text),
                          metrics.height());
        return line.adjusted(-kAroundTextPx, 0.0, kAroundTextPx, 0.0);
    }
};

// Paints one overlay; knows how much room its blocks of lines take. Texts are placed first and painted last:
// the cross-hair leaves them free, so that an I on it is not taken for a part of it.
class OverlayPainter {
  public:
    OverlayPainter(QPainter& painter, const QSize& size, const SliceOverlay& overlay)
        : painter_(painter), size_(size), overlay_(overlay), font_(painter.font()) {
        font_.setPixelSize(int(std::lround(kFontPx * scale_)));
        names_ = wrapped(overlay.tags);
        for (const QString& name : overlay.names) names_ << elided(name, roomPx());
        notes_ = wrapped(overlay.notes);
        facts_ = wrapped(overlay.facts);
    }

    void placeTexts();
    void interpolatedEdges() const;
    void crosshair() const;
    void measurements() const;
    void texts() const;
    void scale() const;

  private:
    void names();
    void notes();
    void facts();
    void scaleText();
    void letters();
    void measurementTexts();
    QPointF placeOf(const glm::dvec3& mm) const {
        const glm::dvec2 px = overlay_.frame.pictureFromWorld(mm) / overlay_.pixelRatio;
        return {px.x, px.y};
    }
    QString elided(const QString& line, double roomPx) const {
        return QFontMetricsF(font_).elidedText(line, Qt::ElideRight, roomPx);
    }
    // In as many lines as it takes: half of a warning, of a date or of a number says something else.
    QStringList wrapped(const QStringList& texts) const;
    double roomPx() const { return std::max(size_.width() - 2.0 * kMarginPx, 0.0); }
    // Lines that are longer come upon the letters in the middle.
    double reachPx() const { return 0.5 * size_.width() - kMarginPx - 2.0 * kLetterPx * scale_; }
    double lineHeight() const { return QFontMetricsF(font_).height(); }
    double widest(const QStringList& lines) const;
    void line(const QPointF& from, const QPointF& to, const QColor& ink) const;
    void put(const QPointF& at, const QString& text, const QColor& ink) {
        texts_.push_back({.at = at, .text = text, .ink = ink, .font = font_});
    }
    QPainterPath pathOf(const ShownMeasurement& shown) const;
    std::optional<ScaleBar> bar() const;
    double barBottom(const ScaleBar& bar) const;

    QPainter& painter_;
    QSize size_;
    const SliceOverlay& overlay_;
    double scale_ = fontScaleOverPictures();
    QFont font_;
    QStringList names_;  // lines as they are painted, also below
    QStringList notes_;
    QStringList facts_;
    double topLines_ = 0.0;  // of those above that reach the middle
    double factsWidth_ = 0.0;
    std::vector<PlacedText> texts_;  // what comes later lies above
};

double OverlayPainter::widest(const QStringList& lines) const {
    double width = 0.0;
    for (const QString& text : lines) width = std::max(width, QFontMetricsF(font_).horizontalAdvance(text));
    return width;
}

// At spaces; what is longer by itself, and what is left after the last line, ends in an ellipsis.
QStringList OverlayPainter::wrapped(const QStringList& texts) const {
    const QFontMetricsF metrics(font_);
    QStringList lines;
    for (const QString& text : texts) {
        QStringList ofThis;
        for (const QString& word : text.split(QLatin1Char(' '))) {
            const QString longer = ofThis.isEmpty() ? word : ofThis.constLast() + QLatin1Char(' ') + word;
            if (ofThis.isEmpty() ||
                (ofThis.size() < kMostLines && metrics.horizontalAdvance(longer) > roomPx())) {
                ofThis << word;
            } else {
                ofThis.last() = longer;
            }
        }
        for (const QString& line : ofThis) lines << elided(line, roomPx());
    }
    return lines;
}

void OverlayPainter::line(const QPointF& from, const QPointF& to, const QColor& ink) const {
    QPainterPath path(from);
    path.lineTo(to);
    drawHaloed(painter_, path, ink, 1.0);
}

void OverlayPainter::crosshair() const {
    if (!overlay_.crosshairMm) return;
    QRegion free(QRect(QPoint(0, 0), size_));
    for (const PlacedText& each : texts_) free -= each.box().toAlignedRect();
    painter_.save();
    painter_.setClipRegion(free, Qt::IntersectClip);
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
    painter_.restore();
}

// Dashed, so that nobody takes them for the cross-hair.
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
    for (const glm::dvec3& mm : outlineOf(shown.measurement)) {
        const QPointF at = placeOf(mm);
        if (path.elementCount() == 0) {
            path.moveTo(at);
        } else {
            path.lineTo(at);
        }
    }
    return path;
}

void OverlayPainter::measurements() const {
    for (const ShownMeasurement& shown : overlay_.measurements) {
        drawHaloed(painter_, pathOf(shown), inkOf(shown), 1.5);
        for (const glm::dvec3& mm : handlesOf(shown.measurement)) {
            QPainterPath handle;
            handle.addEllipse(placeOf(mm), kHandlePx, kHandlePx);
            drawHaloed(painter_, handle, inkOf(shown), 1.0);
        }
    }
}

// Beside each where there is room, and never outside of the pane.
void OverlayPainter::measurementTexts() {
    for (const ShownMeasurement& shown : overlay_.measurements) {
        const QRectF around = pathOf(shown).boundingRect();
        const QStringList lines = wrapped({shown.text});
        const double rightmost = std::max(size_.width() - kMarginPx - widest(lines), kMarginPx);
        const double left = std::clamp(around.right() + kMarginPx, kMarginPx, rightmost);
        const double lowest = size_.height() - kMarginPx - double(lines.size() - 1) * lineHeight();
        double base =
            std::clamp(around.bottom() + lineHeight(), lineHeight(), std::max(lowest, lineHeight()));
        for (const QString& text : lines) {
            put({left, base}, text, inkOf(shown));
            base += lineHeight();
        }
    }
}

void OverlayPainter::names() {
    if (widest(names_) > reachPx()) topLines_ = double(names_.size());
    double base = kMarginPx + QFontMetricsF(font_).ascent();
    for (const QString& text : names_) {
        put({kMarginPx, base}, text, kInk);
        base += lineHeight();
    }
}

// Below the names where both do not fit beside each other.
void OverlayPainter::notes() {
    const bool fits = widest(names_) + widest(notes_) + 2.0 * kMarginPx < roomPx();
    const double first = fits ? 0.0 : double(names_.size());
    if (widest(notes_) > reachPx()) topLines_ = std::max(topLines_, first + double(notes_.size()));
    double base = kMarginPx + QFontMetricsF(font_).ascent() + first * lineHeight();
    for (const QString& text : notes_) {
        const double width = QFontMetricsF(font_).horizontalAdvance(text);
        put({size_.width() - kMarginPx - width, base}, text, kNoteInk);
        base += lineHeight();
    }
}

void OverlayPainter::facts() {
    factsWidth_ = widest(facts_);
    double base = size_.height() - kMarginPx - QFontMetricsF(font_).descent() -
                  double(facts_.size() - 1) * lineHeight();
    for (const QString& text : facts_) {
        put({kMarginPx, base}, text, kInk);
        base += lineHeight();
    }
}

std::optional<ScaleBar> OverlayPainter::bar() const {
    const double mostPx = std::min(kLongestBarPx, kLongestBarOfPane * size_.width());
    auto bar = scaleBar(overlay_.frame.mmPerPixel * overlay_.pixelRatio, mostPx, overlay_.isCalibrated);
    if (bar && !bar->isCalibrated) bar->text = elided(notCalibrated(bar->text), roomPx());
    return bar;
}

// Above the facts where they leave no room beside them.
double OverlayPainter::barBottom(const ScaleBar& bar) const {
    const double textWidth = QFontMetricsF(font_).horizontalAdvance(bar.text);
    const double needed = std::max(bar.lengthPx, textWidth) + 2.0 * kMarginPx;
    const double bottom = size_.height() - kMarginPx - 2.0;
    const bool fits = kMarginPx + factsWidth_ + needed <= size_.width();
    return fits ? bottom : bottom - double(facts_.size()) * lineHeight() - kMarginPx;
}

void OverlayPainter::scale() const {
    const auto shown = bar();
    if (!shown) return;
    const double right = size_.width() - kMarginPx;
    const double bottom = barBottom(*shown);
    QPainterPath path(QPointF(right - shown->lengthPx, bottom - kBarTickPx));
    path.lineTo(right - shown->lengthPx, bottom);
    path.lineTo(right, bottom);
    path.lineTo(right, bottom - kBarTickPx);
    drawHaloed(painter_, path, kInk, 1.5);
}

void OverlayPainter::scaleText() {
    const auto shown = bar();
    if (!shown) return;
    const double width = QFontMetricsF(font_).horizontalAdvance(shown->text);
    put({size_.width() - kMarginPx - width, barBottom(*shown) - kBarTickPx - 3.0}, shown->text, kInk);
}

// In the middle of each side; those above and below give way to lines that reach so far.
void OverlayPainter::letters() {
    const app::EdgeLetters sides = edgeLetters(overlay_.frame.plane);
    const QFont before = font_;
    font_.setPixelSize(int(std::lround(kLetterPx * scale_)));
    font_.setBold(true);
    const QFontMetricsF metrics(font_);
    const auto place = [&](const std::string& letters, const auto& leftOf, double base) {
        const QString text = QString::fromStdString(letters);
        put({leftOf(metrics.horizontalAdvance(text)), base}, text, kInk);
    };
    const double width = size_.width();
    const double middle = 0.5 * size_.height() + 0.5 * metrics.capHeight();
    const auto centred = [&](double letterWidth) { return 0.5 * (width - letterWidth); };
    const double lines = QFontMetricsF(before).height();
    const double top = kMarginPx + metrics.ascent() + topLines_ * lines;
    double bottom = size_.height() - kMarginPx - metrics.descent();
    if (factsWidth_ > reachPx()) bottom -= double(facts_.size()) * lines;
    place(
        sides.left, [](double) { return kMarginPx; }, middle);
    place(
        sides.right, [&](double letterWidth) { return width - kMarginPx - letterWidth; }, middle);
    place(sides.top, centred, top);
    place(sides.bottom, centred, bottom);
    font_ = before;
}

void OverlayPainter::placeTexts() {
    measurementTexts();
    names();
    notes();
    facts();
    scaleText();
    letters();
}

void OverlayPainter::texts() const {
    for (const PlacedText& each : texts_) {
        painter_.setFont(each.font);
        drawHaloedText(painter_, each.at, each.text, each.ink);
    }
}

}  // namespace

void paintOverlay(QPainter& painter, const QSize& size, const SliceOverlay& overlay) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    OverlayPainter paint(painter, size, overlay);
    paint.placeTexts();
    paint.interpolatedEdges();
    paint.crosshair();
    paint.measurements();
    paint.scale();
    paint.texts();
    painter.restore();
}

}  // namespace macula::viewer
