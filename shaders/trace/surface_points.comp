// Measures the light that leaves points of matter, and the matter around them. Several threads share a point.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OF_SURFACE_POINTS
#include "trace/host.glsl"
#include "shared/surface_params.h"

layout(local_size_x = 64) in;

// As in path_samples.glsl.
layout(constant_id = 1) const int kMaxRounds = 16000;

const int kTaps = 8;            // taps of a thread
const float kFaceDepth = 20.0;  // optical depth behind a face over one radius: opaque

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

    // Taps fill the ball evenly: shells of equal volume, by the R2 sequence (Roberts 2018). Behind a grey
    // face everything counts as opaque.
    const int all = kTaps * int(kSurfaceLanes);
    found.taps = float(kTaps);
    found.mass = 0.0;
    found.first = vec3(0.0);
    found.diagonal = vec3(0.0);
    found.offAxis = vec3(0.0);
    for (int i = 0; i < kTaps; ++i) {
        int tap = i * int(kSurfaceLanes) + int(lane);
        float shell = fract((float(tap) + 0.5) * 0.754877666);
        vec3 offset =
            directionOnSphere(1.0 - (2.0 * float(tap) + 1.0) / float(all), float(tap) * 0.569840291);
        offset *= radius * pow(shell, 1.0 / 3.0);
        vec3 at = point.xyz + voxelsPerMm(offset);
        float entry = trilinearEntry(at);
        float steep = steepByChance(at, entry, rng);
        float extinction = onFace ? kFaceDepth / radius : totalOf(mixtureAt(at, entry, steep));
        if (!isShown(at)) extinction = 0.0;
        found.mass += extinction;
        found.first += extinction * offset;
        found.diagonal += extinction * offset * offset;
        found.offAxis += extinction * offset * offset.yzx;
    }
    sums[index] = found;
}
