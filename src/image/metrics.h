// Measures the difference between two pictures, numerically or perceptually. Pictures are display-encoded
// (sRGB), of one size; the first one or three channels count, alpha does not. Values outside 0 to 1 are
// clamped. All fail with usage when the pictures cannot be compared: other size, no pixel, linear light, or
// NaN.
#pragma once

#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace macula::image {

// Peak signal-to-noise ratio in dB, of the mean squared error over pixels and channels; +infinity when equal.
Result<double> psnr(const Image& reference, const Image& test);

// Structural similarity (Wang et al. 2004, "Image quality assessment: from error visibility to structural
// similarity"): Gaussian window of 11 x 11 with sigma 1.5, K1 0.01, K2 0.03; mean over pixels and channels.
// Windows that reach over the edge are cut, and their weights renormalised. 1 when equal.
Result<double> ssim(const Image& reference, const Image& test);

// SSIM at five scales (Wang et al. 2003, "Multiscale structural similarity for image quality assessment"),
// with the window of ssim, but only where it is wholly inside, so that numbers agree with published ones.
// Means below 0, where structures are opposite, count as 0: their powers would be NaN. Mean over channels; 1
// when equal. Also fails with usage when a side is below kMsSsimLeastPx: the last scale is halved four times
// and must hold a window.
inline constexpr int kMsSsimLeastPx = 11 * 16;
Result<double> msSsim(const Image& reference, const Image& test);

struct FlipOptions {
    // Pixels per degree of visual angle: a 0.7 m wide screen of 3840 pixels seen from 0.7 m, as in the paper.
    double pixelsPerDegree = 67.0206;
};
struct Flip {
    double mean = 0.0;            // 0 (equal) to 1
    std::vector<float> perPixel;  // row 0 on top
};
// FLIP for pictures of low dynamic range (Andersson et al. 2020, "FLIP: A difference evaluator for
// alternating images"): the visible difference when the two alternate in one place.
Result<Flip> flip(const Image& reference, const Image& test, const FlipOptions& options = {});

}  // namespace macula::image
