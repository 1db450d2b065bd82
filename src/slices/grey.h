// From values to grey (PS3.3 C.11.2.1.2 and C.11.2.1.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/volume.h"

namespace macula::slices {

// From 0 (black) to 1 (white). `window.function` is LINEAR when empty; a width that its function does not
// allow is taken as the smallest that it does. NaN is black.
double greyOf(double value, const DisplayWindow& window);

// 0 to 255, rounded to the nearest; black where there is no value, inverted or not.
std::vector<std::uint8_t> toGrey(std::span<const float> values, const DisplayWindow& window, bool inverted);

}  // namespace macula::slices
