// Finds candidates for surface points: where rays from all sides meet visible matter, with the area that each
// stands for. A thread for each ray.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OF_SURFACE_POINTS
#include "trace/host.glsl"
#include "shared/surface_params.h"

layout(local_size_x = 64) in;

layout(binding = 16, scalar) readonly buffer Cells {
    SurfaceCell cells[];
};
layout(binding = 17, scalar) readonly buffer Rays {
    uint cellOfRay[];
};
layout(binding = 18, scalar) writeonly buffer Candidates {
    SurfaceCandidate candidates[];
};
layout(push_constant, scalar) uniform Push {
    CandidatePush push;
};

void main() {
    uint ray = push.first + gl_GlobalInvocationID.x;
    SurfaceCell cell = cells[cellOfRay[ray]];
    Rng rng = makeRng(ray, push.round, 2u, params.seed ^ 0x3c6ef372u);
    Candidate found = findCandidate(cell.low, cell.high, kCandidateDirections, rng);
    candidates[ray] = SurfaceCandidate(found.at, found.weight, found.density);
}
