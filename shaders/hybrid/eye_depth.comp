// The depth of splats in the format of a depth buffer: 0 at the near plane, 1 at the far plane and where
// splats show nothing.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shared/eye_depth_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform samplerBuffer splats;  // coverage in w
layout(binding = 1, scalar) readonly buffer DepthSums {
    float depthSums[];  // mm along the view's axis, times coverage
};
layout(binding = 2, scalar) writeonly buffer Depths {
    float depths[];
};
layout(push_constant, scalar) uniform Push {
    EyeDepthPush push;
};

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, push.size))) return;
    int index = pixel.y * push.size.x + pixel.x;
    float coverage = texelFetch(splats, index).w;
    float depth = 1.0;
    if (coverage > 0.5) {
        float along = max(depthSums[index] / coverage * push.unitsPerMm, push.nearest);
        depth = push.farthest / (push.farthest - push.nearest) * (1.0 - push.nearest / along);
    }
    depths[index] = clamp(depth, 0.0, 1.0);
}
