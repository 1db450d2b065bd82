// Push constants of the kernels in shaders/denoise.
#ifndef MACULA_SHARED_DENOISE_PARAMS_H
#define MACULA_SHARED_DENOISE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct DenoisePush {
    ivec2 imageSize;       // pixels
    int stride;            // pixels between the taps of this pass
    int last;              // 1: the last pass of the filter
    float pixelAngle;      // width of a stored pixel at distance 1
    float historySamples;  // the history counts as at most so many samples; 0: no history
    int firstRow;          // of this dispatch
    // The fovea, stored larger: see shaders/lib/fovea.glsl; magnification up to 1: none.
    vec2 planeHalfSize;
    vec2 gaze;
    float foveaRadius;
    float foveaMagnification;
    float parallelMm;  // as in TraceParams
    int doubts;        // 1: the variance that few samples show is inflated (doubtOf)
};

MACULA_SHARED_END
#endif
