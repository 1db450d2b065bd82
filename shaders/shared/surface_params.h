// What the kernels that find points on visible matter are told, and what they answer.
#ifndef MACULA_SHARED_SURFACE_PARAMS_H
#define MACULA_SHARED_SURFACE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

// So many threads share the work of one point.
MACULA_SHARED_CONST uint kSurfaceLanes = 8u;

// Of candidates.comp: a thread for each candidate, those of a brick one after the other.
struct CandidatePush {
    uint first;  // candidate of this dispatch
    uint count;  // and how many
    uint perBrick;
    uint round;  // of random numbers
    int directions;
};

struct SurfacePush {
    uint first;  // point of this dispatch
    uint count;
    uint paths;  // of each thread
};

// What one of the threads of a point has found: sums over its paths and its taps.
struct SurfaceSums {
    vec3 radiance;   // that leaves towards where it is seen from
    float coverage;  // of the same paths
    float taps;      // around the point, within its radius
    float mass;      // of extinction per mm
    vec3 first;      // times where, in mm from the point
    vec3 diagonal;   // times xx, yy, zz
    vec3 offAxis;    // times xy, yz, zx
};

MACULA_SHARED_END
#endif
