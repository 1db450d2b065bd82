// Where the texts over a slice stand, and which of them there is room for.
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

inline const QColor kNoteInk(255, 190, 90);  // of notes and warnings, and of what they are about

// By importance. Sides, notes and tags always stand, in however small a pane; of the others those go first
// that are named last here.
enum class OverlayPart { side, note, tag, fact, name, scale };

// A line of text and where it begins, on its base line.
struct PlacedText {
    QPointF at;
    QString text;
    QColor ink;
    QFont font;
    OverlayPart part = OverlayPart::fact;

    QRectF box() const;
};

// In the middle of each side of the picture. Where two would come upon each other, neither stands: a P above
// an A turns the patient round.
struct SideLetters {
    std::optional<PlacedText> left = {};
    std::optional<PlacedText> right = {};
    std::optional<PlacedText> top = {};
    std::optional<PlacedText> bottom = {};
};
SideLetters placeSides(const app::EdgeLetters& sides, const QSize& size, const QFont& font, double scale);

struct OverlayLayout {
    std::vector<PlacedText> texts;        // what comes later lies above; none overlaps a letter of a side
    std::optional<QRectF> scaleBar = {};  // its height is that of the ticks
};

// Of what measurements say nothing: they stand where they were taken. `scale`: of fonts, as a person has
// chosen it; letters shrink to their usual size before lines of text go.
OverlayLayout layOut(const SliceOverlay& overlay, const QSize& size, const QFont& font, double scale);

// The font of lines in a pane of that size.
QFont overlayFont(const QFont& font, const QSize& size, double scale);

// How many of so many names stand in a picture of that size: they leave the rest of it free.
qsizetype namesIn(const QSize& size, const QFont& font, qsizetype names);

// The upper left corner of a block of text that is wanted there: above or below it in steps of a line, as
// near as the pane has room that `others` leave free; where it is wanted if there is none.
QPointF freePlace(const QRectF& wanted, const QSize& pane, double linePx,
                  const std::vector<PlacedText>& others);

// In as many lines as it takes, up to four for each text: half of a warning, of a date or of a number says
// something else. They break after a comma where that is enough, else at spaces; what is longer by itself,
// and what is left after the last line, ends in an ellipsis.
QStringList wrapped(const QStringList& texts, const QFont& font, double roomPx);

}  // namespace macula::viewer
