// From a shape in mm, as a hand has made it in space, to a clip that a study is kept with.
#pragma once

#include "scene/clip/kept_box.h"

namespace macula::app {

// What is seen through `before` with this shape instead: its window of cut faces and what else is of a clip
// stays, its mask is not looked at. Nothing where all of the volume is shown. A plane or a corner beyond the
// volume's box goes to its border, which removes the same. usage where a turned box, or numbers, cannot be
// kept.
Result<ClipChoice> clipOfShape(const Clip& shapeMm, const ClipChoice& before, const Volume& volume);

}  // namespace macula::app
