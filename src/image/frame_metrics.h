// Measures the visible faults of frames with a fovea: its border, and flicker from frame to frame. Pictures
// and errors are as in metrics.h. Luminance is that of display-encoded values (Rec. 709 weights), which are
// about perceptually uniform.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "base/result.h"
#include "image/image.h"
#include "image/masked_metrics.h"

namespace macula::image {

// How fast luminance, from 0 to 1, changes from pixel to pixel across the border of the fovea.
struct SeamVisibility {
    double frame = 0.0;
    double reference = 0.0;  // the same place in a picture without a border

    // 1 means that the border is not visible. Both values count as at least one step of an 8-bit display per
    // pixel: smaller ones are rounding, and a flat reference would divide by 0.
    static constexpr double kLeast = 1.0 / 255.0;
    double ratio() const;
};

// The mean of |derivative of luminance along the weight's gradient| over the border: pixels whose weight is
// strictly between kOuterWeight and kInnerWeight, and both sides of a border without such pixels. `weights`
// are the fovea's weight in each pixel, clamped to 0 to 1. Nothing if there is no border. Also fails with
// usage unless there is one finite weight for each pixel.
inline constexpr double kOuterWeight = 0.02;
inline constexpr double kInnerWeight = 0.98;
Result<std::optional<SeamVisibility>> seamVisibility(const Image& reference, const Image& frame,
                                                     std::span<const float> weights);

// The mean of |difference of luminance| between a frame and the previous frame, warped to the present view,
// over the `known` pixels. Nothing when there are none. Unknown pixels of the warp must be finite too. Also
// fails with usage when the mask has another size.
Result<std::optional<double>> flicker(const Image& warpedBefore, const Image& frame, const Mask& known);

// The fovea, which is the cone around the gaze that an eye sees sharply.
struct FoveaInPicture {
    glm::ivec2 sizePx{0};         // of the picture; its pixels are square
    double verticalFovDeg = 0.0;  // of the picture
    glm::dvec2 gaze{0.0};         // in the picture, -1 to 1, right and up are positive
    double fieldDeg = 0.0;        // of the fovea, from side to side
};

// The mask of pixels whose centre lies within half of `fieldDeg` of the gaze. The angle is measured at the
// eye, so away from the middle of the picture the mask is not a disc. Fails with usage when the size is
// empty, an angle is out of range (0.1 to 170 degrees, a field above 0 and at most 180), or the gaze is
// outside the picture.
Result<Mask> foveaMask(const FoveaInPicture& fovea);

}  // namespace macula::image
