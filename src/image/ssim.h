// The map of structural similarity, which metrics average in their own ways. Internal to src/image.
#pragma once

#include <vector>

#include "image/planes.h"

namespace macula::image {

// The terms of SSIM for one channel, for a window around each pixel.
struct SsimTerms {
    Plane whole;              // luminance times contrast and structure
    Plane contrastStructure;  // the same without the luminance term
};
SsimTerms ssimTerms(const Plane& a, const Plane& b, Edge edge);

// Pixels from the middle of a window to its border.
inline constexpr int kSsimRadius = 5;

// The SSIM map of each channel: Wang et al. 2004, Gaussian window of 11 x 11 with sigma 1.5, K1 0.01, K2
// 0.03, range 1, a window around each pixel. The pictures are comparable (planes.h).
std::vector<Plane> ssimMaps(const Image& reference, const Image& test, Edge edge);

}  // namespace macula::image
