// Splats and a traced picture of the same view, mixed and shown: background, exposure, tone map and encoding come last.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/compose.glsl"
#include "lib/picture.glsl"
#include "shared/compose_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Splats {
    vec4 splats[];
};
layout(binding = 1, scalar) readonly buffer Traced {
    vec4 traced[];
};
layout(binding = 2, scalar) readonly buffer Counts {
    uint counts[];
};
layout(binding = 3, scalar) readonly buffer Weights {
    float weights[];
};
layout(binding = 4, rgba8) uniform writeonly image2D picture;
layout(push_constant, scalar) uniform Push {
    ComposePush push;
};

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (any(greaterThanEqual(pixel, size))) return;
    int index = pixel.y * size.x + pixel.x;
    vec4 ofSplats = vec4(0.0);
    vec4 ofTracer = vec4(0.0);
    float share = push.tracedShare;
    if (push.tracedIsWeighted == 1) share *= weights[index];
    if (share < 1.0) ofSplats = splats[index] * vec4(vec3(push.splatGain), 1.0);
    if (share > 0.0)
        ofTracer = traced[index] / (push.tracedAreMeans == 1 ? 1.0 : float(max(counts[index], 1u)));
    vec4 light = composed(ofSplats, ofTracer, share);
    imageStore(picture, pixel, vec4(displayColour(light, push.background, push.exposure), 1.0));
}
