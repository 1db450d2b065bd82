// Maps values to grey by windows (PS3.3 C.11.2.1.2 and C.11.2.1.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/volume.h"

namespace macula::slices {

// The grey of a value, from 0 (black) to 1 (white): LINEAR (C.11.2.1.2.1), LINEAR_EXACT (C.11.2.1.3.2) or
// SIGMOID (C.11.2.1.3.1). An empty or unknown `window.function` is LINEAR. A width that its function does not
// allow is raised to the least allowed: 1 for LINEAR, the smallest normal double for the others. NaN is
// black, and so is every value in a window that is not finite.
double greyOf(double value, const DisplayWindow& window);

// 0 to 255, rounded to the nearest; black where there is no value, inverted or not.
std::vector<std::uint8_t> toGrey(std::span<const float> values, const DisplayWindow& window, bool inverted);

}  // namespace macula::slices
