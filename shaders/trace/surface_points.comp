// The light that comes from points of matter, and how matter lies around them. Several threads share a point.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"
#include "shared/surface_params.h"

layout(local_size_x = 64) in;

// As in path.comp.
layout(constant_id = 1) const int kMaxRounds = 16000;

const int kTaps = 8;  // of a thread

layout(binding = 9, scalar) readonly buffer Points {
    vec4 points[];  // voxel coordinates; radius of what lies around, mm
};
layout(binding = 10, scalar) writeonly buffer Sums {
    SurfaceSums sums[];
};
layout(push_constant, scalar) uniform Push {
    SurfacePush push;
};

void main() {
    if (gl_GlobalInvocationID.x >= push.count * kSurfaceLanes) return;
    uint index = push.first * kSurfaceLanes + gl_GlobalInvocationID.x;
    uint lane = index % kSurfaceLanes;
    vec4 point = points[index / kSurfaceLanes];
    Rng rng = makeRng(index / kSurfaceLanes, lane, 1u, params.seed ^ 0x5f0f1e5du);
    SurfaceSums found;
    found.radiance = vec3(0.0);
    found.coverage = 0.0;

    uint done = 0u;
    int rounds = 0;  // of the paths done
    float weight;
    Path path = startTowards(point.xyz, point.w, rng, rounds, weight);
    while (done < push.paths && rounds + path.rounds < kMaxRounds) {
        rounds += 1;
        if (!extendPath(path, rng)) {
            vec4 value = vec4(path.radiance, path.coverage) * weight;
            if (isFinite(value)) {
                found.radiance += value.xyz;
                found.coverage += value.w;
            }
            done += 1u;
            rounds += path.rounds;
            path = startTowards(point.xyz, point.w, rng, rounds, weight);
        }
    }

    // Evenly in the ball: shells of equal volume, directions a golden angle apart.
    const int all = kTaps * int(kSurfaceLanes);
    found.taps = float(kTaps);
    found.mass = 0.0;
    found.first = vec3(0.0);
    found.diagonal = vec3(0.0);
    found.offAxis = vec3(0.0);
    for (int i = 0; i < kTaps; ++i) {
        int tap = i * int(kSurfaceLanes) + int(lane);
        float shell = fract((float(tap) + 0.5) * 0.754877666);
        vec3 offset = directionOnSphere(1.0 - (2.0 * float(tap) + 1.0) / float(all), float(tap) * 0.61803398875);
        offset *= point.w * pow(shell, 1.0 / 3.0);
        float extinction = shownExtinctionAt(point.xyz + voxelsPerMm(offset));
        found.mass += extinction;
        found.first += extinction * offset;
        found.diagonal += extinction * offset * offset;
        found.offAxis += extinction * offset * offset.yzx;
    }
    sums[index] = found;
}
