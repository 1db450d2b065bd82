// Measures the light that leaves points of matter, and the matter around them. Several threads share a point.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OF_SURFACE_POINTS
#include "trace/host.glsl"
#include "shared/surface_params.h"

layout(local_size_x = 64) in;

// As in path_samples.glsl.
layout(constant_id = 1) const int kMaxRounds = 16000;

layout(binding = 16, scalar) readonly buffer Points {
    vec4 points[];  // voxel coordinates; radius of the surroundings in mm, negative: on a grey face
};
layout(binding = 17, scalar) writeonly buffer Sums {
    SurfaceSums sums[];
};
layout(push_constant, scalar) uniform Push {
    SurfacePush push;
};

void main() {
    uint index = push.first * kSurfaceLanes + gl_GlobalInvocationID.x;
    uint lane = index % kSurfaceLanes;
    vec4 point = points[index / kSurfaceLanes];
    float radius = abs(point.w);
    bool onFace = point.w < 0.0;
    // All paths of a point form one net.
    uint net = hashOf(push.base + index / kSurfaceLanes, params.seed ^ 0x2545f491u);
    uint before = (push.pass * kSurfaceLanes + lane) * kSurfacePaths;
    Rng rng = makeRng(push.base + index / kSurfaceLanes, lane, 8u + push.pass, params.seed ^ 0x5f0f1e5du);
    SurfaceSums found;
    found.radiance = vec3(0.0);
    found.coverage = 0.0;

    uint done = 0u;
    uint finite = 0u;
    int rounds = 0;  // of the paths done
    float weight;
    Path path;
    path.rounds = 0;
    bool complete = true;
    while (done < kSurfacePaths && rounds + path.rounds < kMaxRounds) {
        rounds += 1;
        while (complete) {  // a loop, because lavapipe does not skip an if
            rounds += path.rounds;
            path = startTowards(point.xyz, radius, onFace, Net(before + done, net), rng, rounds, weight);
            complete = false;
        }
        if (!extendPath(path, rng)) {
            vec4 value = vec4(path.radiance, path.coverage) * weight;
            if (isFinite(value)) {
                found.radiance += value.xyz;
                found.coverage += value.w;
                finite += 1u;
            }
            done += 1u;
            complete = true;
        }
    }
    found.lost = float(kSurfacePaths - finite);

    Surroundings around =
        surroundingsOf(point.xyz, radius, onFace, int(lane), int(kSurfaceLanes), int(kSurfaceTaps), rng);
    found.taps = float(kSurfaceTaps);
    found.mass = around.mass;
    found.first = around.first;
    found.diagonal = around.diagonal;
    found.offAxis = around.offAxis;
    sums[index] = found;
}
