// Push constants of shaders/trace/guides.comp.
#ifndef MACULA_SHARED_GUIDE_PARAMS_H
#define MACULA_SHARED_GUIDE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

struct GuidePush {
    vec3 oursMm;  // this picture's eye, relative to the previous eye, world mm
    vec3 right;   // axes of the previous eye, as in TraceParams
    vec3 up;
    vec3 forward;
    vec2 planeHalfSize;  // of its picture and its fovea, as in TraceParams
    vec2 gaze;
    float foveaRadius;
    float foveaMagnification;
    float parallelMm;  // as in TraceParams
    int firstRow;      // of this dispatch
};

MACULA_SHARED_END
#endif
