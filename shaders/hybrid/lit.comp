// A picture whose matter is lit from the radiance cache: on the device what reference_lit_view.h does.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shared/light_params.h"
#include "shared/pixel_layers.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Layers {
    PixelLayers layers[];
};
layout(binding = 1, scalar) readonly buffer Slots {
    LightSlot slots[];
};
layout(binding = 2) uniform samplerBuffer cells;
layout(binding = 3, scalar) writeonly buffer Pixels {
    vec4 pixels[];
};
layout(push_constant, scalar) uniform Push {
    LitPush push;
};

#include "lib/light_cells.glsl"

vec4 notKnown() {
    return vec4(uintBitsToFloat(0x7fc00000u));
}

// The light of a ray: the sum over its layers, each weighted by its opacity.
vec4 litRay(ivec2 ray, ivec2 rays) {
    PixelLayers found = layers[ray.y * rays.x + ray.x];
    if (found.coverage <= 0.0) return vec4(0.0);
    vec2 place = (2.0 * vec2(ray) + vec2(1.0)) / vec2(rays) - vec2(1.0);
    vec3 direction = normalize(push.forward + place.x * push.right - place.y * push.up);
    const float kLayer = 1.0 / float(kPixelLayers);
    vec3 sum = vec3(0.0);
    float known = 0.0;
    float atMm = found.meanMm;
    for (int i = 0; i < kPixelLayers; ++i) {
        if (float(i) * kLayer >= found.coverage) break;
        float middleMm = i < 4 ? found.nearMm[i] : found.farMm[i - 4];
        // The last layer may end before its middle: then the depth of the previous layer stands for it.
        if (middleMm >= 0.0) atMm = middleMm;
        if (!(atMm >= 0.0)) break;
        float hides = min(found.coverage - float(i) * kLayer, kLayer);
        vec4 light = lightAt(direction * (atMm * push.cellsPerMm), direction);
        sum += hides * light.w * light.rgb;
        known += hides * light.w;
    }
    if (known < 0.5 * found.coverage) return notKnown();
    return vec4(sum * (found.coverage / known), found.coverage);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, push.firstRow);
    if (any(greaterThanEqual(pixel, push.size))) return;
    ivec2 rays = push.raysAside * push.size;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < push.raysAside; ++y)
        for (int x = 0; x < push.raysAside; ++x) sum += litRay(push.raysAside * pixel + ivec2(x, y), rays);
    pixels[pixel.y * push.size.x + pixel.x] = sum / float(push.raysAside * push.raysAside);
}
