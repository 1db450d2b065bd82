// What a traced picture is made with.
#pragma once

#include <cstdint>

#include "base/camera.h"

namespace macula::trace {

// How a value between voxels is found.
enum class Filter {
    trilinear,   // eight voxels, then the transfer function: the value a radiologist expects at an edge
    stochastic,  // one voxel drawn with the trilinear weights: faster; blends optics instead of values
};

inline constexpr int kMaxBounces = 1024;
inline constexpr int kMaxPictureSide = 16384;

struct Settings {
    int bounces = 4;  // vertices per path, 1 to kMaxBounces
    std::uint32_t seed = 0;
    Filter filter = Filter::trilinear;
    double exposure = 1.0;
};

// What one picture shows.
struct View {
    Camera camera;
    int width = 512;  // pixels, 1 to kMaxPictureSide
    int height = 512;
};

}  // namespace macula::trace
