// Points inside of bricks with matter, and how much of what can be seen is at each: what surface points are chosen from.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"
#include "shared/surface_params.h"

layout(local_size_x = 64) in;

layout(binding = 9, scalar) readonly buffer Bricks {
    uint bricks[];
};
layout(binding = 10, scalar) writeonly buffer Candidates {
    vec4 candidates[];  // voxel coordinates, and the weight
};
layout(push_constant, scalar) uniform Push {
    CandidatePush push;
};

void main() {
    if (gl_GlobalInvocationID.x >= push.count) return;
    uint candidate = push.first + gl_GlobalInvocationID.x;
    uint brick = bricks[candidate / push.perBrick];
    Rng rng = makeRng(candidate % push.perBrick, brick, push.round, params.seed);
    ivec3 size = params.gridSize;
    ivec3 cell = ivec3(int(brick) % size.x, int(brick) / size.x % size.y, int(brick) / (size.x * size.y));
    float x = random01(rng);
    float y = random01(rng);
    vec3 at = (vec3(cell) + vec3(x, y, random01(rng))) * float(BRICK) - vec3(BRICK_SHIFT);
    candidates[candidate] = vec4(at, weightOfPoint(at, push.directions, rng));
}
