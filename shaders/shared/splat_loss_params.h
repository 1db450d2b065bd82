// Parameters and result of the kernels of the loss (shaders/splat/loss_*.comp, downsample.comp).
#ifndef MACULA_SHARED_SPLAT_LOSS_PARAMS_H
#define MACULA_SHARED_SPLAT_LOSS_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

// In a storage buffer, because it changes with every step: see ARCHITECTURE.md, GPU.
struct SplatLossParams {
    ivec2 imageSize;    // pixels
    vec3 background;    // in the pictures' colour space; not exposed
    float exposure;     // multiplies both pictures before they are compared
    float l1Scale;      // factor from a sum over pixels and channels to the loss
    float dssimScale;   // likewise
    float squareScale;  // likewise; above 0: squares are compared, and l1Scale and dssimScale are 0
    uint partCount;     // strips or tiles whose terms are summed
    uint coverageOnly;  // not 0: only coverage is compared
};

struct SplatLossResult {
    float loss;        // weighted sum of the terms, whose gradient is computed
    float l1;          // mean of |render - target| over pixels and channels, as compared
    float dssim;       // mean of 1 - SSIM likewise; 0 if it has no weight
    uint badRendered;  // pixels of the render that are not finite
};

struct SplatDownsamplePush {
    ivec2 fromSize;  // pixels
    ivec2 toSize;    // at most fromSize
};

MACULA_SHARED_END
#endif
