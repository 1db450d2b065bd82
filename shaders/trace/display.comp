// Turns sums of samples into display colours: mean, exposure, tone map, background, display encoding. The
// last step of a pixel.
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

float binomial(int offset) {
    int far = abs(offset);
    if (push.smoothing == 0) return 1.0;
    if (push.smoothing == 1) return far == 0 ? 2.0 : 1.0;
    return far == 0 ? 6.0 : (far == 1 ? 4.0 : 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (any(greaterThanEqual(pixel, size))) return;
    // A binomial filter over premultiplied means: the weights of Pascal's triangle; none at radius 0.
    vec4 sum = vec4(0.0);
    float total = 0.0;
    for (int dy = -push.smoothing; dy <= push.smoothing; ++dy) {
        for (int dx = -push.smoothing; dx <= push.smoothing; ++dx) {
            ivec2 at = clamp(pixel + ivec2(dx, dy), ivec2(0), size - 1);
            int index = at.y * size.x + at.x;
            float weight = binomial(dx) * binomial(dy);
            sum += weight * sums[index] / (push.denoised == 1 ? 1.0 : float(max(counts[index], 1u)));
            total += weight;
        }
    }
    vec4 mean = sum / total;
    imageStore(picture, pixel,
               vec4(displayColour(mean, push.background, push.exposure, push.keepsHue == 1), 1.0));
}
