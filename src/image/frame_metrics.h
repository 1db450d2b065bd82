// What an eye notices in frames with a fovea: its border, and that pixels change from frame to frame.
// Pictures are as in metrics.h, and so are the errors. Luminance is that of display-encoded values (Rec. 709
// weights), which are about as even as the eye's steps.
#pragma once

#include <optional>
#include <span>

#include "base/result.h"
#include "image/image.h"
#include "image/masked_metrics.h"

namespace macula::image {

// Says how fast luminance, from 0 to 1, changes from pixel to pixel across the border of the fovea.
struct SeamVisibility {
    double frame = 0.0;
    double reference = 0.0;  // the same place in a picture without a border

    // 1: the border is not seen. Both count as one step of an 8-bit display per pixel or more: below that
    // they are its rounding, and a flat reference has nothing to divide by.
    static constexpr double kLeast = 1.0 / 255.0;
    double ratio() const;
};

// The mean of |derivative of luminance along the weight's gradient| over the border: pixels whose weight is
// strictly between kOuterWeight and kInnerWeight, and both sides of a border without such pixels. `weights`
// are the fovea's in each pixel, clamped to 0 to 1. Nothing where there is no border. usage besides: not a
// number of weight for each pixel.
inline constexpr double kOuterWeight = 0.02;
inline constexpr double kInnerWeight = 0.98;
Result<std::optional<SeamVisibility>> seamVisibility(const Image& reference, const Image& frame,
                                                     std::span<const float> weights);

// The mean of |difference of luminance| between a frame and the frame before as the eye sees it now, over
// pixels where that is known. Nothing where none is. What the warp does not know is a number all the same;
// usage besides: a mask of another size.
Result<std::optional<double>> flicker(const Image& warpedBefore, const Image& frame, const Mask& known);

}  // namespace macula::image
