// Sums each splat's gradients over its tiles, and turns them into gradients with respect to its parameters.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/frame.glsl"
#include "splat/screen.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 0) const int kDegree = 0;
layout(constant_id = 3) const int kSlots = 1;

#include "splat/parameters.glsl"

layout(binding = 3) uniform usamplerBuffer pairRangeTexels;  // of a splat: first pair, and how many
layout(binding = 4) uniform samplerBuffer pairTexels;
layout(binding = 5, scalar) writeonly buffer Gradients {
    float gradients[];
};
layout(binding = 6, scalar) writeonly buffer Visible {
    uint visible[];
};
layout(binding = 7, scalar) buffer Statistics {
    SplatStatistics statistics[];
};

void write(int component, int splat, float value) {
    gradients[component * int(frame.capacity) + splat] = value;
}
void write(int component, int splat, vec3 value) {
    write(component, splat, value.x);
    write(component + 1, splat, value.y);
    write(component + 2, splat, value.z);
}

void main() {
    if (gl_GlobalInvocationID.x >= frame.count) return;
    int index = int(gl_GlobalInvocationID.x);
    uvec2 range = texelFetch(pairRangeTexels, index).xy;
    float sums[kPairValues];
    [[unroll]] for (int v = 0; v < kPairValues; ++v) sums[v] = 0.0;
    int end = int(range.x + range.y) * kSlots;
    for (int pair = int(range.x) * kSlots; pair < end; ++pair) {
        [[unroll]] for (int v = 0; v < kPairValues; ++v) sums[v] +=
            texelFetch(pairTexels, pair * kPairValues + v).x;
    }
    bool shows = range.y > 0u && sums[9] > 0.0;
    ScreenGradient g = noGradient();
    g.mean = vec2(sums[0], sums[1]);
    g.conic = vec3(sums[2], sums[3], sums[4]);
    g.opacity = sums[5];
    g.colour = vec3(sums[6], sums[7], sums[8]);

    ParametersGradient by = parametersGradient(index, frame.view, fetchShown(index).screen, g);
    visible[index] = shows ? 1u : 0u;
    if (!shows) return;
    write(kSplatPosition, index, by.shape.position);
    write(kSplatLogScale, index, by.shape.logScale);
    write(kSplatRotation, index, by.shape.rotation.x);
    write(kSplatRotation + 1, index, by.shape.rotation.yzw);
    write(kSplatOpacity, index, by.shape.opacityLogit);
    write(kSplatDc, index, by.dc);
    if (kDegree == 1) {
        write(kSplatSh, index, by.sh.s1);
        write(kSplatSh + 3, index, by.sh.s2);
        write(kSplatSh + 6, index, by.sh.s3);
    }
    SplatStatistics known = statistics[index];
    known.views += 1.0;
    known.weight += sums[9];
    known.pull += sums[10];
    known.mostWeight = max(known.mostWeight, sums[9]);
    statistics[index] = known;
}
