// The map of structural similarity, which metrics average in their own ways. Internal to src/image.
#pragma once

#include <vector>

#include "image/planes.h"

namespace macula::image {

// Of a channel, a window around each pixel.
struct SsimTerms {
    Plane whole;              // luminance times contrast and structure
    Plane contrastStructure;  // what is left of that when means are equal
};
SsimTerms ssimTerms(const Plane& a, const Plane& b, Edge edge);

// Pixels from the middle of a window to its border.
inline constexpr int kSsimRadius = 5;

// The SSIM map of each channel: Wang et al. 2004, Gaussian window of 11 x 11 with sigma 1.5, K1 0.01, K2
// 0.03, range 1, a window around each pixel. Comparable pictures.
std::vector<Plane> ssimMaps(const Image& reference, const Image& test, Edge edge);

}  // namespace macula::image
