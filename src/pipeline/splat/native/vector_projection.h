// shaders/lib/splat_projection.glsl, its derivative and the colours of splats as C++ for a vector of splats,
// for native kernels. Compiled once for each instruction set.
#if defined(MACULA_SPLAT_VECTOR_PROJECTION_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_SPLAT_VECTOR_PROJECTION_H
#undef MACULA_SPLAT_VECTOR_PROJECTION_H
#else
#define MACULA_SPLAT_VECTOR_PROJECTION_H
#endif

#include "pipeline/splat/native/neighbours.h"
#include "shared/splat_frame.h"
#include "shared/splat_layout.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {

// For the shaders below.
using shared::kSplatDc;
using shared::kSplatLogScale;
using shared::kSplatOpacity;
using shared::kSplatPosition;
using shared::kSplatRotation;
using shared::kSplatSh;

// Where the parameters of neighbouring splats are. The number of the first of them stands for `splat`.
struct NeighbouringParameters {
    int kDegree;
    const float* parameters;
    std::size_t capacity;
    Neighbours splats;

    HWY_INLINE Float fetchParameter(int component, int splat) const {
        return splats.load(parameters + std::size_t(component) * capacity + std::size_t(splat));
    }
};

#define float Float
#define bool Mask

struct VectorProjection : GlslInVectors {
    // What these functions need of shared::SplatView.
    struct SplatView {
        Vec3 right, down, forward, eyeMm;
        Vec2 focalPx, principalPx, sizePx, lowestSlope, highestSlope;
        Float nearMm, lowPassPx2, lowPassLeastPx2;
        int compensated, parallel;
        Float minAlpha;
    };

#include "lib/finite.glsl"

#include "lib/splat_types.glsl"

#include "lib/splat_shape.glsl"

#include "lib/splat_projection.glsl"

#include "lib/splat_projection_backward.glsl"

#include "lib/splat_colour.glsl"
};

struct VectorModel : VectorProjection, NeighbouringParameters {
    explicit VectorModel(const NeighbouringParameters& parameters_) : NeighbouringParameters(parameters_) {}

#include "lib/splat_parameters.glsl"
};

#undef float
#undef bool
#undef MAX_LOG_SCALE
#undef MIN_QUATERNION
#undef SH_0
#undef SH_1

inline VectorProjection::SplatView projectionOf(const shared::SplatView& view) {
    const auto two = [](const glm::vec2& v) { return Vec2(v.x, v.y); };
    const auto three = [](const glm::vec3& v) { return Vec3(v.x, v.y, v.z); };
    return {.right = three(view.right),
            .down = three(view.down),
            .forward = three(view.forward),
            .eyeMm = three(view.eyeMm),
            .focalPx = two(view.focalPx),
            .principalPx = two(view.principalPx),
            .sizePx = two(view.sizePx),
            .lowestSlope = two(view.lowestSlope),
            .highestSlope = two(view.highestSlope),
            .nearMm = view.nearMm,
            .lowPassPx2 = view.lowPassPx2,
            .lowPassLeastPx2 = view.lowPassLeastPx2,
            .compensated = view.compensated,
            .parallel = view.parallel,
            .minAlpha = view.minAlpha};
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
