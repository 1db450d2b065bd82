// Push constants of shaders/hybrid/eye_depth.comp.
#ifndef MACULA_SHARED_EYE_DEPTH_PARAMS_H
#define MACULA_SHARED_EYE_DEPTH_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct EyeDepthPush {
    ivec2 size;        // pixels
    float unitsPerMm;  // of depths; nearest and farthest are in the same units
    float nearest;     // becomes 0
    float farthest;    // becomes 1, as do pixels that are farther or empty
};

MACULA_SHARED_END
#endif
