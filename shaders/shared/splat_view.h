// What splats are drawn with: the eye, the picture, and how they blend. Made by
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
    vec2 lowestSlope;   // x/z and y/z of the edges of the picture, and a little beyond: for what lies farther
    vec2 highestSlope;  // out, splats are projected as they would be there
    float nearMm;       // a splat whose centre is nearer along z is not drawn
    float lowPassPx2;   // added to the variance in the picture, along x and y, of what is thin
    float lowPassLeastPx2;   // of what is not thin: at most lowPassPx2, see lib/splat_projection.glsl
    int compensated;         // 1: opacity is lowered as the low-pass widens; 0: it is not
    int parallel;            // 1: parallel rays along `forward`, and focalPx is per mm; 0: rays from the eye
    float maxAlpha;          // no splat hides more of a pixel than this
    float minAlpha;          // what hides no more than this is not drawn
    float fringe;            // alpha is at most fringe * (alpha - minAlpha): above 1; very large: a hard edge
    float minTransmittance;  // a pixel that less shines through is finished
};

MACULA_SHARED_END
#endif
