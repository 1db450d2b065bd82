// Lays out the texts over a slice, and omits those without room.
#pragma once

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "scene/camera/orbit_camera.h"
#include "viewer/overlay/slice_overlay.h"

namespace macula::viewer {

inline const QColor kNoteInk(255, 190, 90);  // of notes and warnings, and of what they refer to

// By importance. Notes and tags are always placed, side letters as in placeSides. If room is short, the
// legend, scale, names and facts are omitted, in that order.
enum class OverlayPart { side, note, tag, fact, name, scale, legend };

// A line of text, and the start of its base line.
struct PlacedText {
    QPointF at;
    QString text;
    QColor ink;
    QFont font;
    OverlayPart part = OverlayPart::fact;

    QRectF box() const;
};

// At the middle of each side. Opposite letters are omitted together in a pane too small for both: a P above
// an A would turn the patient round.
struct SideLetters {
    std::optional<PlacedText> left = {};
    std::optional<PlacedText> right = {};
    std::optional<PlacedText> top = {};
    std::optional<PlacedText> bottom = {};
};
SideLetters placeSides(const scene::EdgeLetters& sides, const QSize& size, const QFont& font, double scale);

struct OverlayLayout {
    std::vector<PlacedText> texts;        // later ones lie above; none overlaps a side letter
    std::optional<QRectF> scaleBar = {};  // its height is that of the ticks
};

// Does not place the texts of measurements, which are drawn beside their lines. `scale`: the person's font
// scale; letters shrink to their usual size before lines are omitted.
OverlayLayout layOut(const SliceOverlay& overlay, const QSize& size, const QFont& font, double scale);

// The font of text lines in a pane of that size.
QFont overlayFont(const QFont& font, const QSize& size, double scale);

// How many of `names` lines fit a picture of that size: up to a fifth of its height, at least one.
qsizetype namesIn(const QSize& size, const QFont& font, qsizetype names);

// The upper left corner of a block of text: the free place nearest to `wanted`, below or above it in steps of
// a line, in the pane and clear of `others`; `wanted` itself if there is none.
QPointF freePlace(const QRectF& wanted, const QSize& pane, double linePx,
                  const std::vector<PlacedText>& others);

// Wraps each text to up to four lines, since half a warning, date or number says something else. Lines break
// after commas if that is enough, else at spaces; a longer word, and the rest after line four, end in an
// ellipsis.
QStringList wrapped(const QStringList& texts, const QFont& font, double roomPx);

}  // namespace macula::viewer
