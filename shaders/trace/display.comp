// From sums to what is shown: mean, background, exposure, tone map, display encoding. The last thing that happens to a
// pixel.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "shared/trace_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Sums {
    vec4 sums[];
};
layout(binding = 1, scalar) readonly buffer Counts {
    uint counts[];
};
layout(binding = 2, rgba8) uniform writeonly image2D picture;
layout(push_constant, scalar) uniform Push {
    DisplayPush push;
};

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (any(greaterThanEqual(pixel, size))) return;
    int index = pixel.y * size.x + pixel.x;
    vec4 mean = sums[index] / float(max(counts[index], 1u));
    imageStore(picture, pixel, vec4(displayColour(mean, push.background, push.exposure), 1.0));
}
