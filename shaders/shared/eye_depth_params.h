// What shaders/hybrid/eye_depth.comp is told.
#ifndef MACULA_SHARED_EYE_DEPTH_PARAMS_H
#define MACULA_SHARED_EYE_DEPTH_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct EyeDepthPush {
    ivec2 size;        // pixels
    float unitsPerMm;  // of depths; near and far are in the same units
    float nearest;     // becomes 0
    float farthest;    // becomes 1, and so does what is farther, or nothing
};

MACULA_SHARED_END
#endif
