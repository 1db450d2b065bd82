// How far the luminance of a smooth surface is from smooth in a picture.
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
    double relative = 0.0;  // root mean square of the deviation from smooth, over the mean
    double least = 0.0;     // the value that noise alone causes: below it, ripple cannot be detected
    double mean = 0.0;
};

// Over the pixels whose `counts` is not 0, at least 64 of them. Smooth means the best-fitting polynomial of
// sixth degree in the pixel coordinates. The remainders of two pictures with different seeds are multiplied,
// because noise is independent in them, so that it does not count as ripple. Pictures without noise may be
// the same one twice.
Ripple rippleOf(const LuminancePicture& a, const LuminancePicture& b, std::span<const std::uint8_t> counts);

}  // namespace macula::evaluate
