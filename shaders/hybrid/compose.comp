// Blends a reprojected picture for the fovea, and a traced picture of all pixels, over splats, and displays
// the result: exposure, tone map, background and encoding come last.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/compose.glsl"
#include "lib/picture.glsl"
#include "shared/compose_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

// Constants, so that unused pictures are not fetched: lavapipe skips no branch.
layout(constant_id = 0) const bool kHasSplats = true;
layout(constant_id = 1) const bool kHasFovea = true;
layout(constant_id = 2) const bool kHasTraced = true;
layout(constant_id = 3) const bool kKeepsCoverage = false;
layout(constant_id = 4) const bool kHasTrusts = false;

layout(binding = 0) uniform samplerBuffer splats;
layout(binding = 1) uniform samplerBuffer fovea;
layout(binding = 2) uniform samplerBuffer weights;
layout(binding = 3, scalar) readonly buffer Traced {
    vec4 traced[];
};
layout(binding = 4, scalar) readonly buffer Counts {
    uint counts[];
};
layout(binding = 5) uniform samplerBuffer trusts;
layout(binding = 6, rgba8) uniform writeonly image2D picture;
layout(push_constant, scalar) uniform Push {
    ComposePush push;
};

// Premultiplies in linear light after the tone map, so that the result can be laid over another picture:
// matter that covers half of a pixel is half as bright as where it covers all of it.
vec4 displayCovering(vec4 light, float exposure, bool keepsHue) {
    float coverage = clamp(light.w, 0.0, 1.0);
    if (!(coverage > 0.0)) return vec4(0.0);
    vec3 shown = displayColour(vec4(light.xyz / coverage, 1.0), vec3(0.0), exposure, keepsHue);
    return vec4(encodeSrgb(decodeSrgb(shown.x) * coverage), encodeSrgb(decodeSrgb(shown.y) * coverage),
                encodeSrgb(decodeSrgb(shown.z) * coverage), coverage);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (any(greaterThanEqual(pixel, size))) return;
    int index = pixel.y * size.x + pixel.x;
    vec4 light = vec4(0.0);
    if (kHasSplats) light = texelFetch(splats, index) * vec4(vec3(push.splatGain), 1.0);
    vec4 bare = light;
    if (kHasFovea) light = composed(light, texelFetch(fovea, index), texelFetch(weights, index).x);
    if (kHasTraced) {
        vec4 ofTracer = traced[index] / (push.tracedAreMeans == 1 ? 1.0 : float(max(counts[index], 1u)));
        if (kHasTrusts) ofTracer = composed(bare, ofTracer, texelFetch(trusts, index).x);
        light = composed(light, ofTracer, push.tracedShare);
    }
    imageStore(picture, pixel,
               kKeepsCoverage
                   ? displayCovering(light, push.exposure, push.keepsHue == 1)
                   : vec4(displayColour(light, push.background, push.exposure, push.keepsHue == 1), 1.0));
}
