// The parameters with which a model of splats is drawn: the camera, with a pinhole or parallel rays, and the
// rules by which splats blend.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "base/result.h"
#include "pipeline/splat/model/splats.h"
#include "shared/splat_view.h"

namespace macula::splat {

inline constexpr int kMaxRasterSide = 16384;  // pixels

// In double, so that no precision is lost far from the world's origin.
struct RasterView {
    glm::dmat3 cameraFromWorld{1.0};  // a rotation; camera x to the right, y down, z forward (COLMAP)
    glm::dvec3 eyeMm{0.0};            // relative to the model's origin
    glm::dvec2 focalPx{1.0};          // per unit of x/z and y/z; with parallel rays per mm of x and y
    glm::dvec2 principalPx{0.0};      // the pixel where x = y = 0; the first pixel's centre is at (0.5, 0.5)
    glm::ivec2 sizePx{0};             // columns and rows, 1 to kMaxRasterSide; row 0 on top
    double nearMm = 2.0;              // along z; a splat whose centre is nearer is not drawn
    glm::ivec2 wholePx{0};            // size of the picture of which this is a part; 0: it is whole
    glm::ivec2 atPx{0};               // position of its first pixel in the whole picture
    bool isParallel = false;          // rays along z; the eye must stand in front of all of the model

    bool operator==(const RasterView&) const = default;
};

// The view of a part of a whole picture: shows the same pixels, except for rounding.
RasterView partOf(const RasterView& whole, const glm::ivec2& atPx, const glm::ivec2& sizePx);

// The least and the greatest x/z and y/z that splats are projected with: those of the edges of the whole
// picture, also for a part, moved outwards by 0.15 of its sides.
glm::dvec2 lowestSlope(const RasterView& view);
glm::dvec2 highestSlope(const RasterView& view);

// The view of a camera, with square pixels; the camera's vertical field of view, or its height in mm, spans
// the height of the picture. Fails with usage where basis(camera) does, and when the size or the near plane
// is not usable.
Result<RasterView> rasterView(const Camera& camera, const glm::ivec2& sizePx, const glm::dvec3& originMm,
                              double nearMm = 2.0);

// For views that do not come from rasterView. Fails with usage when a number is not finite or not usable, or
// the matrix is not a rotation (a mirrored camera would show left as right).
Result<void> validate(const RasterView& view);

// See shaders/lib/splat_blend.glsl and splat_projection.glsl.
struct Blending {
    bool compensated = true;  // opacity is lowered as the low-pass widens; not in LowPass::classic
    // The low-pass: the variance in the picture that is added to splats thinner than a pixel (with less, sums
    // depend on where in a pixel they lie), and the smaller one that is added to thick splats (that of a
    // pixel's area). If both are equal, all splats get it.
    double lowPassPx2 = 0.3;
    double lowPassLeastPx2 = 1.0 / 12.0;
    double maxAlpha = 0.99;          // of one splat in one pixel
    double minAlpha = 1.0 / 255.0;   // a splat that hides no more is not drawn there
    double fringe = 2.0;             // how steeply a splat fades out at minAlpha; 1000 or more: a step
    double minTransmittance = 1e-4;  // a pixel with less transmittance is finished
};

// The blending for a model's low-pass. All but ours (adaptive) have hard edges, as in 3DGS.
Blending blendingOf(LowPass lowPass);

// Fails with usage when a number is out of its range.
Result<void> validate(const Blending& blending);

// The view and the blending as kernels read them. Both must be valid.
shared::SplatView splatView(const RasterView& view, const Blending& blending);

}  // namespace macula::splat
