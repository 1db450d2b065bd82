// The parameters that splats are drawn with: eye, picture and blending. Made by
// src/pipeline/splat/draw/raster_view.h.
#ifndef MACULA_SHARED_SPLAT_VIEW_H
#define MACULA_SHARED_SPLAT_VIEW_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

// The camera has x to the right, y down, z forward; pixel (column, row) has its centre at (column + 0.5, row
// + 0.5), row 0 on top. A field added here must be added to the struct of the same name in
// src/pipeline/splat/draw/reference_host.inl.
struct SplatView {
    vec3 right;  // axes of the camera in the world: orthonormal
    vec3 down;
    vec3 forward;
    vec3 eyeMm;  // relative to the model's origin
    vec2 focalPx;
    vec2 principalPx;
    ivec2 sizePx;
    vec2 lowestSlope;        // x/z and y/z a little beyond the edges of the picture: splats farther out are
    vec2 highestSlope;       // projected with the shape that they would have there
    float nearMm;            // a splat whose centre is nearer along z is not drawn
    float lowPassPx2;        // low-pass added to the projected variance of thin splats, along x and y
    float lowPassLeastPx2;   // the same for splats that are not thin: at most lowPassPx2, see
                             // lib/splat_projection.glsl
    int compensated;         // 1: opacity is lowered by as much as the low-pass widens a splat; 0: it is not
    int parallel;            // 1: parallel rays along `forward`, and focalPx is per mm; 0: rays from the eye
    float maxAlpha;          // upper limit of a splat's alpha in a pixel
    float minAlpha;          // a splat with no more alpha in a pixel is skipped there
    float fringe;            // above 1: limits alpha to fringe * (alpha - minAlpha); very large: a hard edge
    float minTransmittance;  // a pixel is finished when its transmittance falls below this
};

MACULA_SHARED_END
#endif
