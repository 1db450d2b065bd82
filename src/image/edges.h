// What an eye notices along edges: lines and dots that are not there. Pictures are as in metrics.h, and so
// are the errors; masks as in masked_metrics.h. Luminance is that of display-encoded values (Rec. 709).
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

// The mask of pixels whose weight is neither kOuterWeight or less nor kInnerWeight or more
// (frame_metrics.h): two pictures are mixed there.
Mask mixedMask(std::span<const float> weights);

// The step of luminance (0 to 1) from a pixel to the most different of its four neighbours, over a mask.
struct LuminanceSteps {
    double mean = 0.0;
    double most = 0.0;  // the 99.9th percentile
};
struct EdgeVisibility {
    LuminanceSteps frame;
    LuminanceSteps reference;

    // 1: edges are as steep as in the reference. Steps below one of an 8-bit display count as one.
    double meanRatio() const;
    double mostRatio() const;
};
// Both numbers ignore where a step is: a line in the frame can hide behind a real edge elsewhere in the mask.
// Nothing where the mask is empty. usage besides: a mask of another size.
Result<std::optional<EdgeVisibility>> edgeVisibility(const Image& reference, const Image& frame,
                                                     const Mask& mask);

// The count of pixels of the mask that are darker, by more than `margin` of luminance, than the darkest of
// the 3 x 3 pixels around them in both sources: dots that come from mixing these. usage as edgeVisibility.
Result<std::size_t> darkerThanBoth(const Image& frame, const Image& a, const Image& b, const Mask& mask,
                                   double margin);

}  // namespace macula::image
