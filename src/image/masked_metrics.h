// Compares pictures of an object over black only where the object is, as Kleinbeck et al. (IEEE VR 2026) do,
// so that a large black background improves no result. Pictures and errors are as in metrics.h; a mask has a
// byte for each pixel, 0 where it does not count.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace macula::image {

using Mask = std::vector<std::uint8_t>;

// The mask of pixels where any channel of either picture is above 0 once it is rounded to 8 bits.
Result<Mask> litMask(const Image& reference, const Image& test);

// The mask of pixels whose coverage is above 0 once it is rounded to 8 bits: one stray sample of a thousand
// does not count.
Mask coveredMask(std::span<const float> coverage);
// The union of both masks, which have one size.
Mask unionOf(const Mask& a, const Mask& b);

// For an empty mask, the functions that return an optional return nothing.

// The PSNR, as psnr, over masked pixels; +infinity if they are equal.
Result<std::optional<double>> maskedPsnr(const Image& reference, const Image& test, const Mask& mask);

// SSIM, averaged over masked pixels and channels of the map of the whole pictures, whose 11 x 11 windows are
// padded with black beyond the edge.
Result<std::optional<double>> maskedSsim(const Image& reference, const Image& test, const Mask& mask);

// The light that masked pixels emit on screen: the sum of the luminance (Rec. 709) of decoded values, white
// 1.
double lightOf(const Image& image, const Mask& mask);

// Mean of |test - reference| over masked pixels. All have one size.
std::optional<double> coverageError(std::span<const float> reference, std::span<const float> test,
                                    const Mask& mask);

// Mean of values over masked pixels. Fails with usage when the sizes differ, or a value is not finite.
Result<std::optional<double>> meanOf(std::span<const float> perPixel, const Mask& mask);

// The quantile `fraction` (0 to 1), interpolated linearly as by NumPy's default: at place (count - 1) *
// fraction in ascending order. Takes at least one value, none of them NaN.
double percentile(std::vector<double> values, double fraction);

}  // namespace macula::image
