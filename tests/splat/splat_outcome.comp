#version 460
#extension GL_GOOGLE_include_directive : require
#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "shared/splat_view.h"

#include "lib/splat_lib.glsl"
#include "splat_outcome.glsl"

layout(local_size_x = 8) in;

layout(binding = 0, scalar) readonly buffer View {
    SplatView view;
};
layout(binding = 1, scalar) readonly buffer Splats {
    Splat splats[];
};
layout(binding = 2, scalar) writeonly buffer Outcomes {
    Outcome outcomes[];
};
layout(push_constant) uniform Push {
    uint count;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < count) outcomes[i] = outcomeOf(splats[i], view);
}
