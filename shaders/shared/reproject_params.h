// What shaders/hybrid/capture.comp, trust_rows.comp, trust.comp, reproject.comp and feather.comp are told.
#ifndef MACULA_SHARED_REPROJECT_PARAMS_H
#define MACULA_SHARED_REPROJECT_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct CapturePush {
    ivec2 size;        // pixels, of what is kept
    ivec2 firstPx;     // of it in the traced picture
    ivec2 tracedSize;  // pixels, of that
    float pixelAngle;  // radians, of a pixel in the middle of the picture
    float thinMm;      // uncertainty of the depth where matter shows, but is too thin to have one
    int areMeans;      // 1: light is means, and counts do not count; 0: it is sums of samples
};

struct TrustPush {
    ivec2 size;       // pixels, of the traced picture and of that of the splats
    int areMeans;     // 1: traced light is means, and counts do not count; 0: it is sums of samples
    float splatGain;  // multiplies the light of splats, not their coverage
};

// Two eyes: the one that sees now, and the one that the picture was traced from. Axes as in TraceParams:
// right is half the width of a picture at distance 1, up half its height.
struct ReprojectPush {
    vec3 right;  // of the eye that sees now
    vec3 up;
    vec3 forward;
    vec3 oursMm;  // where that eye is, relative to the eye before
    vec3 beforeRight;
    vec3 beforeUp;
    vec3 beforeForward;
    vec3 middleMm;   // of a ball around all that can be seen, relative to the eye that sees now
    float radiusMm;  // of that ball
    ivec2 size;      // pixels, of the picture that is made
    ivec2 beforeSize;
    ivec2 firstPx;   // of this dispatch, in the picture that is made
    float edgeFade;  // share of the picture's sides over which its weight falls to nothing; 0: no fade
};

struct FeatherPush {
    ivec2 size;     // pixels, of the picture
    ivec2 firstPx;  // of this dispatch
};

MACULA_SHARED_END
#endif
