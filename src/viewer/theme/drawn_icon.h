// Icons that are drawn when they are shown: sharp at any size and scale, in the colours of the palette.
#pragma once

#include <QIcon>

namespace macula::viewer {

enum class Glyph {
    crosshair,
    window,
    zoom,
    pan,
    distance,
    angle,
    ellipse,
    probe,
    slabMean,
    slabMaximum,
    slabMinimum,
    invert,
    acquired,
    fourPanes,
    volume,
    axial,
    coronal,
    sagittal,
    cine,  // the last
};

// In the text colour of buttons; of chosen text while it is checked.
QIcon drawnIcon(Glyph glyph);

}  // namespace macula::viewer
