// The slow rasterizer against which all others are tested: the maths of shaders/lib/splat_*.glsl compiled as
// C++, in float and in double, in loops over splats and pixels. EWA splatting (Zwicker et al. 2001) as in
// 3DGS (Kerbl et al. 2023), with a compensated low-pass (Mip-Splatting, Yu et al. 2024); the shader files
// state the differences.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/splat/draw/raster_view.h"
#include "pipeline/splat/model/reference_splats.h"

namespace macula::splat {

enum class Precision { single, twofold };

// A picture, pixel by pixel, row 0 on top.
struct RasterImage {
    glm::ivec2 sizePx{0};
    std::vector<glm::dvec4> rgba;  // premultiplied, in the model's colour space; a is the coverage
    std::vector<double> depth;  // mm: sum of weight times depth of the centre; divided by a, the mean depth
};

// The derivative of a loss by a RasterImage, in the same order. For a picture that is laid over a background
// b, with g the derivative by the result, rgba is (g, -dot(b, g)), and the derivative by b is the sum of (1 -
// a) g.
struct RasterGradient {
    std::vector<glm::dvec4> rgba;
    std::vector<double> depth;  // empty: 0 everywhere
};

// One splat in the picture, see shaders/lib/splat_types.glsl. Opacity 0: it is not in the picture, and the
// other members mean nothing.
struct ProjectedSplat {
    glm::dvec2 mean{0.0};
    glm::dvec3 conic{0.0};
    double opacity = 0.0;
    double depthMm = 0.0;
    glm::dvec2 extent{0.0};
    glm::dvec3 colour{0.0};
};

// For all of these functions the view and the blending must be valid and the arrays of one size, but the
// splats may hold any numbers: a splat with one that is not finite is not drawn. Results do not depend on the
// number of cores.

std::vector<ProjectedSplat> projectSplats(const ReferenceSplats& splats, const RasterView& view,
                                          const Blending& blending, Precision precision);

// `order` lists splats front to back, for comparison with another sort; empty: by depth, then by index.
RasterImage rasterize(const ReferenceSplats& splats, const RasterView& view, const Blending& blending,
                      Precision precision, std::span<const std::uint32_t> order = {});

// The derivative by all parameters in `splats`, whose degree is 0 or 1. `image` is the result of rasterize
// for the same arguments.
ReferenceSplats rasterizeBackward(const ReferenceSplats& splats, const RasterView& view,
                                  const Blending& blending, const RasterImage& image,
                                  const RasterGradient& gradient, Precision precision,
                                  std::span<const std::uint32_t> order = {});

}  // namespace macula::splat
