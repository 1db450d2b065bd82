// Push constants of shaders/hybrid/capture.comp, trust_rows.comp, trust.comp, reproject.comp and
// feather.comp.
#ifndef MACULA_SHARED_REPROJECT_PARAMS_H
#define MACULA_SHARED_REPROJECT_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct CapturePush {
    ivec2 size;        // pixels, of the part that is kept
    ivec2 firstPx;     // its corner in the traced picture
    ivec2 tracedSize;  // pixels, of the traced picture
    float pixelAngle;  // radians, of a pixel in the middle of the picture
    float thinMm;      // uncertainty of depth for matter too thin to have a depth
    int areMeans;      // 1: light is means, and counts are ignored; 0: light is sums of samples
};

struct TrustPush {
    ivec2 size;       // pixels, of the traced picture and of the splats'
    int areMeans;     // 1: traced light is means, and counts are ignored; 0: it is sums of samples
    float splatGain;  // multiplies the light of splats, not their coverage
};

// Two eyes: the present one, and the one from which the picture was traced. Axes as in TraceParams: right is
// half the width of a picture at distance 1, up half its height.
struct ReprojectPush {
    vec3 right;  // of the present eye
    vec3 up;
    vec3 forward;
    vec3 oursMm;  // the present eye, relative to the traced picture's
    vec3 beforeRight;
    vec3 beforeUp;
    vec3 beforeForward;
    vec3 middleMm;   // of a ball around all visible matter, relative to the present eye
    float radiusMm;  // of that ball
    ivec2 size;      // pixels, of the reprojected picture
    ivec2 beforeSize;
    ivec2 firstPx;   // of this dispatch, in the reprojected picture
    float edgeFade;  // fraction of the picture's sides over which its weight falls to 0; 0: no fade
};

struct FeatherPush {
    ivec2 size;     // pixels, of the picture
    ivec2 firstPx;  // of this dispatch
};

MACULA_SHARED_END
#endif
