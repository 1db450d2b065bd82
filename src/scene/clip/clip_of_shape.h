// From a clip shape in mm, as made in the headset, to a clip that a study can store.
#pragma once

#include "scene/clip/kept_box.h"

namespace macula::scene {

// The clip with this shape, shadows and cut faces; of `before` only a window that follows the series stays.
// Ignores the mask. Nothing for no shape. A plane beyond the volume's box moves to its border, where it
// removes the same. Fails with usage for a turned box, or numbers, that a study cannot store.
Result<OptionalClip> clipOfShape(const Clip& shapeMm, const OptionalClip& before, const Volume& volume);

}  // namespace macula::scene
