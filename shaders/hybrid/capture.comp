// Keeps a traced picture for reprojection to other eyes: the light and depth of each pixel, with their
// uncertainties.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shared/reproject_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Traced {
    vec4 traced[];
};
layout(binding = 1, scalar) readonly buffer Counts {
    uint counts[];
};
layout(binding = 2) uniform samplerBuffer surfaces;  // of the guides: normal, depth
layout(binding = 3) uniform samplerBuffer motions;   // confidence in z
layout(binding = 4, scalar) readonly buffer TracedVariances {
    float tracedVariances[];
};
layout(binding = 5, scalar) writeonly buffer Lights {
    vec4 lights[];
};
layout(binding = 6, scalar) writeonly buffer Depths {
    vec2 depths[];  // mm, negative where there is none; uncertainty, mm
};
layout(binding = 7, scalar) writeonly buffer Variances {
    float variances[];
};
layout(binding = 8, scalar) writeonly buffer Trusts {
    float trusts[];  // 1, until trust.comp compares it with splats
};
layout(push_constant, scalar) uniform Push {
    CapturePush push;
};

// An empty pixel is certainly empty only if no pixel of a ring around it shows matter too thin to have a
// depth: noise moves the border of thin matter by a few pixels.
#define RING_PX 3
const ivec2 kRing[8] = ivec2[8](ivec2(-1, -1), ivec2(0, -1), ivec2(1, -1), ivec2(-1, 0), ivec2(1, 0),
                                ivec2(-1, 1), ivec2(0, 1), ivec2(1, 1));

vec4 lightAt(int index) {
    return traced[index] / (push.areMeans == 1 ? 1.0 : float(max(counts[index], 1u)));
}

bool isThin(int index) {
    return texelFetch(surfaces, index).w < 0.0 && lightAt(index).w > 0.02;
}

bool isBesideThin(ivec2 pixel) {
    bool any = false;
    for (int i = 0; i < 8; ++i) {
        ivec2 there = clamp(pixel + RING_PX * kRing[i], ivec2(0), push.tracedSize - ivec2(1));
        any = any || isThin(there.y * push.tracedSize.x + there.x);
    }
    return any;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, push.size))) return;
    int kept = pixel.y * push.size.x + pixel.x;
    ivec2 there = pixel + push.firstPx;
    int index = there.y * push.tracedSize.x + there.x;
    lights[kept] = lightAt(index);
    variances[kept] = tracedVariances[index];
    trusts[kept] = 1.0;
    float depthMm = texelFetch(surfaces, index).w;
    float confidence = texelFetch(motions, index).z;
    // The inverse of the formula for confidence in guides.glsl.
    float spreadMm = 4.0 * push.pixelAngle * depthMm * (1.0 / max(confidence, 0.02) - 1.0);
    depths[kept] = depthMm >= 0.0 ? vec2(depthMm, spreadMm)
                                  : vec2(-1.0, isThin(index) || isBesideThin(there) ? push.thinMm : 0.0);
}
