// The class that shaders/lib/splat_*.glsl becomes in C++. Included twice, with MACULA_HOST its name and
// MACULA_REAL float or double. An included file instead of a template, because `float` in the shaders must
// mean MACULA_REAL.
//
// No include guard and no namespace: the including file has both.

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE

struct MACULA_HOST : GlslInCpp<MACULA_REAL> {
    using Real = MACULA_REAL;

    struct SplatView {
        vec3 right, down, forward, eyeMm;
        vec2 focalPx, principalPx;
        ivec2 sizePx;
        vec2 lowestSlope, highestSlope;
        Real nearMm, lowPassPx2, lowPassLeastPx2;
        int compensated, parallel;
        Real maxAlpha, minAlpha, fringe, minTransmittance;
    };
    // A field added to the shared block must be added above and below.
    static_assert(sizeof(shared::SplatView) == 4 * (4 * 3 + 2 * 2 + 2 + 2 * 2 + 3 + 2 + 4));

    MACULA_HOST(const RasterView& raster, const Blending& blending)
        : frame{glm::transpose(raster.cameraFromWorld)[0], glm::transpose(raster.cameraFromWorld)[1],
               glm::transpose(raster.cameraFromWorld)[2], raster.eyeMm,
               raster.focalPx,           raster.principalPx,
               raster.sizePx,            lowestSlope(raster),
               highestSlope(raster),     Real(raster.nearMm),
               Real(blending.lowPassPx2), Real(blending.lowPassLeastPx2),
               blending.compensated ? 1 : 0, raster.isParallel ? 1 : 0,
               Real(blending.maxAlpha),  Real(blending.minAlpha),
               Real(blending.fringe),    Real(blending.minTransmittance)} {}

    SplatView frame;

#define float MACULA_REAL
#include "lib/splat_lib.glsl"
#undef float
#undef MAX_LOG_SCALE
#undef MIN_QUATERNION
#undef SH_0
#undef SH_1
#undef HARD_EDGE
};

#undef OUT
#undef INOUT
#undef PRECISE
