// What a traced picture is made with.
#pragma once

#include <cstdint>

#include <optional>

#include "base/camera.h"
#include "base/result.h"

namespace macula::trace {

// How a value between voxels is found.
enum class Filter {
    trilinear,   // eight voxels, then the transfer function: the value a radiologist expects at an edge
    stochastic,  // one voxel drawn with the trilinear weights: faster; blends optics instead of values
};

// Whether what is shown and read is filtered, see denoiser.h. It never changes what is traced.
enum class Denoising { off, on };

inline constexpr int kMaxBounces = 1024;
inline constexpr int kMaxPictureSide = 16384;

struct Settings {
    int bounces = 4;  // vertices per path, 1 to kMaxBounces
    std::uint32_t seed = 0;
    Filter filter = Filter::trilinear;
    double exposure = 1.0;
    Denoising denoising = Denoising::off;
};

// A picture that is stored larger where the eye looks: see shaders/lib/fovea.glsl.
struct Foveation {
    glm::dvec2 gaze{0.0};        // in the picture: -1 to 1, right and up are positive
    double fieldDeg = 15.0;      // of view, of what is magnified; smaller where there is no room for it
    double magnification = 2.5;  // 1 to 16: how many times more pixels along each side
};

// What one picture shows.
struct View {
    Camera camera;
    int width = 512;  // pixels, 1 to kMaxPictureSide
    int height = 512;
    std::optional<Foveation> foveation = {};
};

// A plain picture of what lies around a point of another view's picture: `gaze` as in Foveation, `fieldDeg`
// the field of view of a square of `pixels` on each side. Same eye, same up. The point is of the picture as
// seen.
Result<View> fovealWindow(const View& view, const glm::dvec2& gaze, double fieldDeg = 20.0, int pixels = 512);

}  // namespace macula::trace
