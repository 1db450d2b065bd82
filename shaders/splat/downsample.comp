// Makes a smaller picture: see lib/splat_downsample.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "shared/splat_loss_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform samplerBuffer sources;
layout(binding = 1, scalar) writeonly buffer Pixels {
    vec4 pixels[];
};
layout(push_constant, scalar) uniform Push {
    SplatDownsamplePush push;
};

vec4 fetchSource(int index) {
    return texelFetch(sources, index);
}
#include "lib/splat_downsample.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, push.toSize))) return;
    pixels[pixel.y * push.toSize.x + pixel.x] = downsampledPixel(pixel, push.fromSize, push.toSize);
}
