// Estimates how noisy each pixel of the film is: see lib/variance.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "lib/variance.glsl"
#include "shared/trace_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Sums {
    vec4 sums[];
};
layout(binding = 1, scalar) readonly buffer Counts {
    uint counts[];
};
layout(binding = 2, scalar) readonly buffer Squares {
    vec2 squares[];
};
layout(binding = 3, scalar) writeonly buffer Variances {
    float variances[];
};
layout(push_constant, scalar) uniform Push {
    VariancePush push;
};

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, push.imageSize))) return;
    int index = pixel.y * push.imageSize.x + pixel.x;
    variances[index] = varianceOfMean(sums[index], counts[index], squares[index].x);
}
