// Sums over strips to sums over the picture, always in the same order. One group.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/splat_loss_params.h"

layout(local_size_x = 256) in;

layout(binding = 0, scalar) readonly buffer Params {
    SplatLossParams params;
};
layout(binding = 1) uniform samplerBuffer ssimParts;
layout(binding = 2) uniform samplerBuffer l1Parts;
layout(binding = 3, scalar) writeonly buffer Result {
    SplatLossResult result;
};

shared vec3 lanes[256];

void main() {
    int lane = int(gl_LocalInvocationID.x);
    vec3 sum = vec3(0.0);
    for (int i = lane; i < int(params.partCount); i += 256) sum += vec3(texelFetch(l1Parts, i).xy, texelFetch(ssimParts, i).x);
    lanes[lane] = sum;
    for (int step = 128; step > 0; step /= 2) {
        barrier();
        if (lane < step) lanes[lane] += lanes[lane + step];
    }
    barrier();
    if (lane != 0) return;
    vec3 total = lanes[0];
    float values = 4.0 * float(params.imageSize.x) * float(params.imageSize.y);
    result = SplatLossResult(params.l1Scale * total.x + params.dssimScale * total.z, total.x / values, total.z / values, uint(total.y));
}
