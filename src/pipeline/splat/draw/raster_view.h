// What a model of splats is drawn with: the picture of a pinhole or of parallel rays, and the rules by which
// splats blend.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "base/result.h"
#include "pipeline/splat/model/splats.h"
#include "shared/splat_view.h"

namespace macula::splat {

inline constexpr int kMaxRasterSide = 16384;  // pixels

// In double, so that a model far from the world's origin costs no precision.
struct RasterView {
    glm::dmat3 cameraFromWorld{1.0};  // a rotation; camera x to the right, y down, z forward (COLMAP)
    glm::dvec3 eyeMm{0.0};            // relative to the model's origin
    glm::dvec2 focalPx{1.0};          // per unit of x/z and y/z; with parallel rays per mm of x and y
    glm::dvec2 principalPx{0.0};      // where x = y = 0 is; the first pixel's centre is at (0.5, 0.5)
    glm::ivec2 sizePx{0};             // columns and rows, 1 to kMaxRasterSide; row 0 on top
    double nearMm = 2.0;              // along z; a splat whose centre is nearer is not drawn
    glm::ivec2 wholePx{0};            // of the picture of which this is a part; 0: it is whole
    glm::ivec2 atPx{0};               // where its first pixel lies in that
    bool isParallel = false;          // rays along z; who draws stands before all of the model

    bool operator==(const RasterView&) const = default;
};

// A part of a picture that is whole: the same pixels, but for rounding.
RasterView partOf(const RasterView& whole, const glm::ivec2& atPx, const glm::ivec2& sizePx);

// x/z and y/z of the picture's edges, 0.15 of its sides farther out. The whole one's, also of a part.
glm::dvec2 lowestSlope(const RasterView& view);
glm::dvec2 highestSlope(const RasterView& view);

// Square pixels, the camera's vertical field of view over the height, or its height in mm. Fails with usage
// where basis(camera) does, and when the size or the near plane is not usable.
Result<RasterView> rasterView(const Camera& camera, const glm::ivec2& sizePx, const glm::dvec3& originMm,
                              double nearMm = 2.0);

// Fails with usage when a number is not finite or not usable, or the rotation is none (its handedness
// included: a mirrored camera would show left as right). For views that do not come from rasterView.
Result<void> validate(const RasterView& view);

// See shaders/lib/splat_blend.glsl and splat_projection.glsl.
struct Blending {
    bool compensated = true;  // opacity falls as the low-pass widens; not in LowPass::classic
    // The low-pass: variance added in the picture to splats thinner than a pixel (with less, sums depend on
    // where in a pixel they lie), and to thick ones (that of a pixel's area). Equal numbers: always that.
    double lowPassPx2 = 0.3;
    double lowPassLeastPx2 = 1.0 / 12.0;
    double maxAlpha = 0.99;          // of one splat in one pixel
    double minAlpha = 1.0 / 255.0;   // what hides no more is not drawn
    double fringe = 2.0;             // how steeply a splat fades out at minAlpha; 1000 or more: a step
    double minTransmittance = 1e-4;  // a pixel that less shines through is finished
};

// For a model's way of being kept from falling between pixels. All but ours have hard edges, as in 3DGS.
Blending blendingOf(LowPass lowPass);

// Fails with usage when a number is out of its range.
Result<void> validate(const Blending& blending);

// The view and the blending as kernels read them. Both must be valid.
shared::SplatView splatView(const RasterView& view, const Blending& blending);

}  // namespace macula::splat
