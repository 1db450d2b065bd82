#include "viewer/overlay/overlay_layout.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/overlay/cube_and_scale.h"
#include "viewer/overlay/slice_texts.h"

namespace macula::viewer {

namespace {

constexpr double kMarginPx = 8.0;  // logical, as all below
constexpr int kFontPx = 13;
constexpr int kLetterPx = 16;
constexpr double kAroundTextPx = 2.0;  // which the cross-hair leaves free
constexpr double kGapPx = 4.0;
constexpr double kLongestBarPx = 120.0;
constexpr double kLongestBarOfPane = 0.3;
constexpr double kBarTickPx = 5.0;
constexpr qsizetype kMostLines = 4;           // a text wraps to at most this many
constexpr double kNamesOfHeight = 0.2;        // share of the pane's height
constexpr QSizeF kPaneOfUsualFont{200, 160};  // smaller panes have no font larger than usual
const QColor kInk(235, 235, 235);

double widthOf(const QFont& font, const QString& text) {
    return QFontMetricsF(font).horizontalAdvance(text);
}

double widest(const QFont& font, const QStringList& lines) {
    double width = 0.0;
    for (const QString& line : lines) width = std::max(width, widthOf(font, line));
    return width;
}

double fittingScale(const QSize& size, double scale) {
    const double room =
        std::min(size.width() / kPaneOfUsualFont.width(), size.height() / kPaneOfUsualFont.height());
    return std::min(scale, std::max(room, 1.0));
}

// The pieces between which a line may break: phrases up to a comma if all fit, otherwise words.
QStringList piecesOf(const QString& text, const QFont& font, double roomPx) {
    const auto splitAfter = [&](const QString& mark) {
        QStringList pieces = text.split(mark + QLatin1Char(' '));
        for (qsizetype i = 0; i + 1 < pieces.size(); ++i) pieces[i] += mark;
        return pieces;
    };
    QStringList phrases = splitAfter(QStringLiteral(","));
    return widest(font, phrases) <= roomPx ? phrases : splitAfter({});
}

// One attempt to place all texts, with a given number of names and facts.
class Attempt {
  public:
    Attempt(const SliceOverlay& overlay, const QSize& size, const QFont& font, double scale)
        : overlay_(overlay),
          width_(size.width()),
          height_(size.height()),
          font_(font),
          lineHeight_(QFontMetricsF(font).height()),
          sides_(placeSides(edgeLetters(overlay.frame.plane), size, font, scale)) {}

    // Places the texts. Returns whether those from above and from below do not overlap, and the names do not
    // reach the letters.
    bool place(qsizetype names, qsizetype facts);
    OverlayLayout take();

  private:
    struct Row {
        double left;
        double right;
    };
    double placeFromAbove(const QStringList& lines, OverlayPart part, double top, bool atRight);
    double placeFromBelow(const QStringList& lines);
    void placeLegend(double top, double most);
    void placeScale(double factsTop);
    double roomPx() const { return std::max(width_ - 2.0 * kMarginPx, 0.0); }
    Row roomAt(double top) const;
    double clearOfLetters(double top, double textPx, bool down) const;
    void put(const QString& text, double top, const Row& room, OverlayPart part, bool atRight);

    const SliceOverlay& overlay_;
    double width_;
    double height_;
    QFont font_;
    double lineHeight_;
    SideLetters sides_;
    OverlayLayout layout_;
};

// The room between the letters at both sides, where the row meets them.
Attempt::Row Attempt::roomAt(double top) const {
    Row room{kMarginPx, width_ - kMarginPx};
    const auto meets = [&](const std::optional<PlacedText>& letter) {
        return letter && letter->box().top() < top + lineHeight_ && letter->box().bottom() > top;
    };
    if (meets(sides_.left)) room.left = sides_.left->box().right() + kGapPx;
    if (meets(sides_.right)) room.right = sides_.right->box().left() - kGapPx;
    return room;
}

// Where a row of text that begins at a side has its top: moved past each letter that it would overlap.
double Attempt::clearOfLetters(double top, double textPx, bool down) const {
    const auto pass = [&](const std::optional<PlacedText>& letter, double roomPx) {
        if (!letter || textPx <= roomPx) return;
        const QRectF box = letter->box();
        if (box.top() < top + lineHeight_ && box.bottom() > top)
            top = down ? box.bottom() : box.top() - lineHeight_;
    };
    const auto besidePx = [&](const std::optional<PlacedText>& letter) {
        return letter ? 0.5 * (width_ - letter->box().width()) - kMarginPx - kGapPx : width_;
    };
    pass(down ? sides_.top : sides_.bottom, besidePx(down ? sides_.top : sides_.bottom));
    if (sides_.left && sides_.right) {
        const double betweenPx = sides_.right->box().left() - sides_.left->box().right() - 2.0 * kGapPx;
        pass(sides_.left, betweenPx);
    }
    return top;
}

void Attempt::put(const QString& text, double top, const Row& room, OverlayPart part, bool atRight) {
    // The end of a number or name identifies it as often as the beginning.
    const auto elide = part == OverlayPart::name ? Qt::ElideMiddle : Qt::ElideRight;
    const QFontMetricsF metrics(font_);
    const QString shown = metrics.elidedText(text, elide, std::max(room.right - room.left, 0.0));
    const double x = atRight ? room.right - metrics.horizontalAdvance(shown) : room.left;
    layout_.texts.push_back({.at = {x, top + metrics.ascent()},
                             .text = shown,
                             .ink = part == OverlayPart::note ? kNoteInk : kInk,
                             .font = font_,
                             .part = part});
}

double Attempt::placeFromAbove(const QStringList& lines, OverlayPart part, double top, bool atRight) {
    for (const QString& line : lines) {
        top = clearOfLetters(top, std::min(widthOf(font_, line), roomPx()), true);
        put(line, top, roomAt(top), part, atRight);
        top += lineHeight_;
    }
    return top;
}

// Places the last line lowest. Returns the top of the block.
double Attempt::placeFromBelow(const QStringList& lines) {
    double top = height_ - kMarginPx;
    for (auto line = lines.crbegin(); line != lines.crend(); ++line) {
        top = clearOfLetters(top - lineHeight_, std::min(widthOf(font_, *line), roomPx()), false);
        put(*line, top, roomAt(top), OverlayPart::fact, false);
    }
    return top;
}

// Downwards from `top`. Half a legend would say less than none: omitted if it would reach `most`.
void Attempt::placeLegend(double top, double most) {
    if (top + double(overlay_.legend.size()) * lineHeight_ > most) return;
    for (const LegendLine& line : overlay_.legend) {
        put(line.text, top, roomAt(top), OverlayPart::legend, true);
        if (line.ink.isValid()) layout_.texts.back().ink = line.ink;
        top += lineHeight_;
    }
}

// Above the facts if they leave no room beside them. Omitted if it would overlap another text.
void Attempt::placeScale(double factsTop) {
    const double mostPx = std::min(kLongestBarPx, kLongestBarOfPane * width_);
    auto bar = scaleBar(overlay_.frame.mmPerPixel * overlay_.pixelRatio, mostPx, overlay_.isCalibrated);
    if (!bar) return;
    const QFontMetricsF metrics(font_);
    const double right = width_ - kMarginPx;
    const QString text = metrics.elidedText(bar->isCalibrated ? bar->text : notCalibrated(bar->text),
                                            Qt::ElideRight, std::max(right - kMarginPx, 0.0));
    const double textPx = metrics.horizontalAdvance(text);
    const double wide = std::max(bar->lengthPx, textPx);
    const double high = lineHeight_ + kBarTickPx + 3.0;
    const auto isFree = [&](const QRectF& box) {
        return box.top() >= 0.0 && std::ranges::none_of(layout_.texts, [&](const PlacedText& each) {
                   return each.box().intersects(box);
               });
    };
    QRectF box(right - wide, height_ - kMarginPx - 2.0 - high, wide, high);
    for (const double lower :
         {sides_.bottom ? sides_.bottom->box().top() - kGapPx : height_, factsTop - kGapPx}) {
        if (isFree(box.adjusted(-kMarginPx, 0.0, 0.0, 0.0))) break;
        box.moveBottom(std::min(box.bottom(), lower));
    }
    if (!isFree(box)) return;
    layout_.scaleBar = QRectF(right - bar->lengthPx, box.bottom() - kBarTickPx, bar->lengthPx, kBarTickPx);
    layout_.texts.push_back({.at = {right - textPx, box.bottom() - kBarTickPx - 3.0 - metrics.descent()},
                             .text = text,
                             .ink = kInk,
                             .font = font_,
                             .part = OverlayPart::scale});
}

bool Attempt::place(qsizetype names, qsizetype facts) {
    layout_ = {};
    const QStringList tags = wrapped(overlay_.tags, font_, roomPx());
    const QStringList notes = wrapped(overlay_.notes, font_, roomPx());
    const QStringList shownNames = overlay_.names.first(names);
    for (const auto* letter : {&sides_.top, &sides_.bottom, &sides_.left, &sides_.right})
        if (*letter) layout_.texts.push_back(**letter);
    const double tagsEnd = placeFromAbove(tags, OverlayPart::tag, kMarginPx, false);
    const double namesEnd = placeFromAbove(shownNames, OverlayPart::name, tagsEnd, false);
    // Notes go below the names if both do not fit beside each other.
    const double besidePx = std::max(widest(font_, tags), widest(font_, shownNames)) + widest(font_, notes);
    const bool fitsBeside = besidePx + 2.0 * kMarginPx < roomPx();
    const double notesEnd = placeFromAbove(notes, OverlayPart::note, fitsBeside ? kMarginPx : namesEnd, true);
    const double end = std::max(namesEnd, notesEnd);
    const double factsTop = placeFromBelow(wrapped(overlay_.facts.first(facts), font_, roomPx()));
    placeLegend((fitsBeside ? notesEnd : end) + kGapPx, factsTop);
    placeScale(factsTop);
    const double namesMost = sides_.left ? sides_.left->box().top() : height_;
    return end <= factsTop && (names == 0 || namesEnd <= namesMost);
}

OverlayLayout Attempt::take() {
    // The side letters are drawn last, above everything else.
    std::ranges::stable_partition(layout_.texts,
                                  [](const PlacedText& each) { return each.part != OverlayPart::side; });
    return std::move(layout_);
}

}  // namespace

QRectF PlacedText::box() const {
    const QFontMetricsF metrics(font);
    const bool isLetter = part == OverlayPart::side;
    const double above = isLetter ? metrics.capHeight() : metrics.ascent();
    const QRectF line(at.x(), at.y() - above, metrics.horizontalAdvance(text),
                      isLetter ? above : metrics.height());
    const double around = isLetter ? kAroundTextPx : 0.0;
    return line.adjusted(-kAroundTextPx, -around, kAroundTextPx, around);
}

SideLetters placeSides(const scene::EdgeLetters& sides, const QSize& size, const QFont& font, double scale) {
    QFont bold = font;
    bold.setPixelSize(int(std::lround(kLetterPx * fittingScale(size, scale))));
    bold.setBold(true);
    const QFontMetricsF metrics(bold);
    const double high = metrics.capHeight();
    const double width = size.width();
    const double height = size.height();
    const auto letter = [&](const std::string& text, double x, double base) {
        return PlacedText{{x, base}, QString::fromStdString(text), kInk, bold, OverlayPart::side};
    };
    const auto wide = [&](const std::string& text) { return widthOf(bold, QString::fromStdString(text)); };
    SideLetters placed;
    if (height - 2.0 * kMarginPx >= 3.0 * metrics.height()) {
        placed.top = letter(sides.top, 0.5 * (width - wide(sides.top)), kMarginPx + metrics.ascent());
        placed.bottom =
            letter(sides.bottom, 0.5 * (width - wide(sides.bottom)), height - kMarginPx - metrics.descent());
    }
    const double inARow =
        wide(sides.left) + wide(sides.right) + std::max(wide(sides.top), wide(sides.bottom));
    if (width - 2.0 * kMarginPx >= inARow + 4.0 * kGapPx) {
        const double middle = 0.5 * (height + high);
        placed.left = letter(sides.left, kMarginPx, middle);
        placed.right = letter(sides.right, width - kMarginPx - wide(sides.right), middle);
    }
    return placed;
}

QFont overlayFont(const QFont& font, const QSize& size, double scale) {
    QFont fitting = font;
    fitting.setPixelSize(int(std::lround(kFontPx * fittingScale(size, scale))));
    return fitting;
}

qsizetype namesIn(const QSize& size, const QFont& font, qsizetype names) {
    const double most = std::floor(kNamesOfHeight * size.height() / QFontMetricsF(font).height());
    return std::min(names, qsizetype(std::max(most, 1.0)));
}

QPointF freePlace(const QRectF& wanted, const QSize& pane, double linePx,
                  const std::vector<PlacedText>& others) {
    const auto isFree = [&](const QRectF& box) {
        return box.top() >= 0.0 && box.bottom() <= pane.height() &&
               std::ranges::none_of(others,
                                    [&](const PlacedText& each) { return each.box().intersects(box); });
    };
    for (int step = 0; step * linePx < pane.height(); ++step) {
        for (const double way : {1.0, -1.0}) {
            const QRectF box = wanted.translated(0.0, way * step * linePx);
            if (isFree(box)) return box.topLeft();
        }
    }
    return wanted.topLeft();
}

QStringList wrapped(const QStringList& texts, const QFont& font, double roomPx) {
    const QFontMetricsF metrics(font);
    QStringList lines;
    for (const QString& text : texts) {
        QStringList ofThis;
        for (const QString& piece : piecesOf(text, font, roomPx)) {
            const QString longer = ofThis.isEmpty() ? piece : ofThis.constLast() + QLatin1Char(' ') + piece;
            if (ofThis.isEmpty() ||
                (ofThis.size() < kMostLines && metrics.horizontalAdvance(longer) > roomPx)) {
                ofThis << piece;
            } else {
                ofThis.last() = longer;
            }
        }
        for (const QString& line : ofThis) lines << metrics.elidedText(line, Qt::ElideRight, roomPx);
    }
    return lines;
}

OverlayLayout layOut(const SliceOverlay& overlay, const QSize& size, const QFont& font, double scale) {
    const QFont lineFont = overlayFont(font, size, scale);
    Attempt attempt(overlay, size, lineFont, scale);
    qsizetype names = namesIn(size, lineFont, overlay.names.size());
    qsizetype facts = overlay.facts.size();
    while (!attempt.place(names, facts)) {
        if (names > 0) {
            --names;
        } else if (facts > 0) {
            --facts;
        } else {
            break;
        }
    }
    return attempt.take();
}

}  // namespace macula::viewer
