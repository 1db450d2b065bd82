// What the kernels that find points on visible matter are told, and what they answer.
#ifndef MACULA_SHARED_SURFACE_PARAMS_H
#define MACULA_SHARED_SURFACE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

// Dispatches are of whole groups of so many threads: what a kernel does depends on no push constant, for each
// value of which lavapipe would compile it again.
MACULA_SHARED_CONST uint kSurfaceGroup = 64u;

// The number of threads that share the work of one point.
MACULA_SHARED_CONST uint kSurfaceLanes = 8u;
// The number of light paths of each of these threads in a pass.
MACULA_SHARED_CONST uint kSurfacePaths = 4u;

// A box that rays are sent through, voxel coordinates with integers at voxel faces.
struct SurfaceCell {
    vec3 low;
    vec3 high;
};

struct CandidatePush {
    uint first;  // ray of this dispatch
    uint round;  // of random numbers
};

// See Candidate in shaders/lib/surface.glsl.
struct SurfaceCandidate {
    vec3 at;
    float weight;
    float density;
};

struct SurfacePush {
    uint first;  // point of this dispatch
    uint base;   // number of point 0, for its random numbers
    uint pass;
};

// What one of the threads of a point has found in a pass: sums over its paths and its taps.
struct SurfaceSums {
    vec3 radiance;   // that leaves towards where it is seen from
    float coverage;  // of the same paths
    float lost;      // paths too long for the device, or not finite
    float taps;      // around the point, within its radius
    float mass;      // of extinction per mm
    vec3 first;      // extinction times the place, in mm from the point
    vec3 diagonal;   // extinction times xx, yy, zz of the place
    vec3 offAxis;    // extinction times xy, yz, zx
};

MACULA_SHARED_END
#endif
