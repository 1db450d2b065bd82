// Adds the sums of strips or tiles up to sums over the picture, always in the same order. One work group.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/splat_loss_params.h"

layout(local_size_x = 256) in;

layout(constant_id = 0) const bool kSimilar = true;  // the loss includes SSIM

layout(binding = 0, scalar) readonly buffer Params {
    SplatLossParams params;
};
layout(binding = 1) uniform samplerBuffer ssimParts;
layout(binding = 2) uniform samplerBuffer differenceParts;
layout(binding = 3, scalar) writeonly buffer Result {
    SplatLossResult result;
};

shared vec4 lanes[256];

void main() {
    int lane = int(gl_LocalInvocationID.x);
    vec4 sum = vec4(0.0);
    for (int i = lane; i < int(params.partCount); i += 256) {
        sum += texelFetch(differenceParts, i);
        if (kSimilar) sum.w += texelFetch(ssimParts, i).x;
    }
    lanes[lane] = sum;
    for (int step = 128; step > 0; step /= 2) {
        barrier();
        if (lane < step) lanes[lane] += lanes[lane + step];
    }
    barrier();
    if (lane != 0) return;
    vec4 total = lanes[0];
    float values = 4.0 * float(params.imageSize.x) * float(params.imageSize.y);
    float loss = params.l1Scale * total.x + params.squareScale * total.y + params.dssimScale * total.w;
    result = SplatLossResult(loss, total.x / values, total.w / values, uint(total.z));
}
