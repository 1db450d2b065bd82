// Measures false lines and dots along edges, which are conspicuous. Pictures and errors are as in metrics.h,
// masks as in masked_metrics.h. Luminance is that of display-encoded values (Rec. 709).
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "base/result.h"
#include "image/image.h"
#include "image/masked_metrics.h"

namespace macula::image {

// The mask of pixels within one pixel of where coverage passes one half: the silhouette of what is shown.
// `coverage` holds width * height values from 0 to 1, row 0 on top; NaN counts as 0.
Mask silhouetteMask(std::span<const float> coverage, int width, int height);

// The mask of pixels that mix two pictures: their weight is above kOuterWeight and below kInnerWeight
// (frame_metrics.h).
Mask mixedMask(std::span<const float> weights);

// The largest luminance step (0 to 1) from a pixel to one of its four neighbours, over the pixels of a mask.
struct LuminanceSteps {
    double mean = 0.0;
    double most = 0.0;  // the 99.9th percentile
};
struct EdgeVisibility {
    LuminanceSteps frame;
    LuminanceSteps reference;

    // 1: as steep as in the reference. Values below one step of an 8-bit display count as one.
    double meanRatio() const;
    double mostRatio() const;
};
// Neither ratio says where a step is: a real edge elsewhere in the mask can hide a line in the frame. Nothing
// when the mask is empty. Also fails with usage when the mask has another size.
Result<std::optional<EdgeVisibility>> edgeVisibility(const Image& reference, const Image& frame,
                                                     const Mask& mask);

// Counts the mask's pixels that are darker, by more than `margin` of luminance, than the darkest of the 3 x 3
// pixels around them in both sources: dots that mixing the sources has made. Errors as edgeVisibility.
Result<std::size_t> darkerThanBoth(const Image& frame, const Image& a, const Image& b, const Mask& mask,
                                   double margin);

}  // namespace macula::image
