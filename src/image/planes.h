// Planes of doubles and separable filters over them, for the metrics. Internal to src/image.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace macula::image {

struct Plane {
    int width = 0;
    int height = 0;
    std::vector<double> values;

    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
    double& at(int x, int y) { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    double at(int x, int y) const { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

// How a filter continues a picture beyond its edge.
enum class Edge {
    repeat,  // the outermost pixel is repeated
    cut,     // pixels beyond are left out, and the other weights scaled to the same sum
    zero,    // pixels beyond are black
};

// Weights for offsets -r to r, r = size / 2, along x and along y.
Plane filter(const Plane& plane, const std::vector<double>& alongX, const std::vector<double>& alongY,
             Edge edge);

// Weights of red, green and blue in luminance (Rec. 709).
inline constexpr std::array kRec709{0.2126, 0.7152, 0.0722};

// The channels that are compared, clamped to 0 to 1.
std::vector<Plane> colourPlanes(const Image& image);

// The luminance of the channels that are compared.
Plane luminanceOf(const Image& image);

// Whether two pictures can be compared: see metrics.h.
Result<void> comparable(const Image& reference, const Image& test);

}  // namespace macula::image
