// Converts a clip shape in mm, as made in the headset, to a clip that a study can store.
#pragma once

#include "scene/clip/kept_box.h"

namespace macula::scene {

// The clip with this shape, shadows and cut faces; from `before` it keeps the window of the cut faces if that
// follows the series. Ignores the mask. Nothing if there is no shape. A plane beyond the volume's box moves
// to its border, where it removes the same. Fails with usage for a turned box, or numbers, that a study
// cannot store.
Result<OptionalClip> clipOfShape(const Clip& shapeMm, const OptionalClip& before, const Volume& volume);

}  // namespace macula::scene
