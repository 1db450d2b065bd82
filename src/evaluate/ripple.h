// How far the luminance of a surface that should be smooth is not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"

namespace macula::evaluate {

// Luminance of pixels, row 0 on top, in linear light.
struct LuminancePicture {
    int width = 0;
    int height = 0;
    std::vector<double> luminance;
};

struct Ripple {
    double relative = 0.0;  // root mean square of what is not smooth, over the mean
    double least = 0.0;     // what chance alone makes of it: less cannot be told from none
    double mean = 0.0;
};

// Of the pixels that `counts` says, at least 64 of them. Smooth is the polynomial of sixth degree of the
// place that fits best; what is left is compared between two pictures of other random numbers, so that noise,
// which they do not share, is no ripple. Pictures without chance may be the same one twice.
Ripple rippleOf(const LuminancePicture& a, const LuminancePicture& b, std::span<const std::uint8_t> counts);

}  // namespace macula::evaluate
