// What there is to say of a picture in which nothing is seen.
#pragma once

#include <string>

#include "base/volume.h"

namespace macula::app {

// The range of the values, and built-in presets that would show something of them. The volume must be
// stored16.
std::string whyNothingIsVisible(const Volume& volume);
// Of a projection, which knows no preset: the range, and the window that it is seen through.
std::string whyNothingIsVisible(const Volume& volume, const DisplayWindow& window);

}  // namespace macula::app
