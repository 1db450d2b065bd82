// What a dispatch of shaders/trace/guides.comp is told.
#ifndef MACULA_SHARED_GUIDE_PARAMS_H
#define MACULA_SHARED_GUIDE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct GuidePush {
    vec3 oursMm;  // the eye of the picture, relative to the eye before, world mm
    vec3 right;   // of the eye before, as in TraceParams
    vec3 up;
    vec3 forward;
    vec2 planeHalfSize;  // of its picture, and where that is stored larger, likewise
    vec2 gaze;
    float foveaRadius;
    float foveaMagnification;
    float parallelMm;  // likewise
    int firstRow;      // of this dispatch
};

MACULA_SHARED_END
#endif
