// Parameters and results of the kernels that find points on visible matter.
#ifndef MACULA_SHARED_SURFACE_PARAMS_H
#define MACULA_SHARED_SURFACE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

// Dispatches consist of whole groups of so many threads, so that no kernel branches on a push constant,
// for each value of which lavapipe would compile it again.
MACULA_SHARED_CONST uint kSurfaceGroup = 64u;

// The number of directions from which the visibility of a candidate is estimated.
MACULA_SHARED_CONST int kCandidateDirections = 8;

// The number of threads that share the work of one point.
MACULA_SHARED_CONST uint kSurfaceLanes = 8u;
// The number of light paths of each of these threads in a pass.
MACULA_SHARED_CONST uint kSurfacePaths = 4u;
// The number of its taps around the point in a pass.
MACULA_SHARED_CONST uint kSurfaceTaps = 8u;

// A box through which rays are sent, in voxel coordinates with integers at voxel faces.
struct SurfaceCell {
    vec3 low;
    vec3 high;
};

struct CandidatePush {
    uint first;  // index of this dispatch's first ray
    uint round;  // selects the random numbers
};

// See Candidate in shaders/lib/surface.glsl.
struct SurfaceCandidate {
    vec3 at;
    float weight;
    float density;
};

struct SurfacePush {
    uint first;  // index of this dispatch's first point
    uint base;   // added to a point's index for its random numbers
    uint pass;
};

// The result of one thread of a point in a pass: sums over its paths and its taps.
struct SurfaceSums {
    vec3 radiance;   // leaving in the directions from which the point is seen
    float coverage;  // of the same paths
    float lost;      // paths too long for the device, or not finite
    float taps;      // number of taps within the point's radius
    float mass;      // sum of extinction per mm
    vec3 first;      // extinction times the tap's position, in mm from the point
    vec3 diagonal;   // extinction times xx, yy, zz of that position
    vec3 offAxis;    // extinction times xy, yz, zx
};

MACULA_SHARED_END
#endif
