// Messages for a picture in which nothing is visible.
#pragma once

#include <string>

#include "base/text.h"
#include "base/volume.h"

namespace macula::scene {

// The range of the values, and up to six built-in presets that show some of them. The volume must be
// stored16.
Text whyNothingIsVisible(const Volume& volume);
// For a projection, which has no preset: the range of the values, and the window.
Text whyNothingIsVisible(const Volume& volume, const DisplayWindow& window);

}  // namespace macula::scene
