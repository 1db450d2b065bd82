// Icons drawn at the time of display: sharp at any size and scale, in the palette's colours.
#pragma once

#include <QIcon>

namespace macula::viewer {

enum class Glyph {
    crosshair,
    window,
    zoom,
    pan,
    distance,
    bidirectional,
    angle,
    cobb,
    ellipse,
    outline,
    line,
    arrow,
    probe,
    curve,
    segment,
    slabMean,
    slabMaximum,
    slabMinimum,
    invert,
    acquired,
    straight,
    fourPanes,
    volume,
    axial,
    coronal,
    sagittal,
    cine,  // the last
};

// In the text colour of buttons; in that of selected text while checked.
QIcon drawnIcon(Glyph glyph);

}  // namespace macula::viewer
