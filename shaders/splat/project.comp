// Projects splats in space to splats in the picture. A thread for each splat.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/frame.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 0) const int kDegree = 0;

#include "splat/parameters.glsl"

layout(binding = 1, scalar) writeonly buffer Screen {
    vec4 screen[];
};

void main() {
    if (gl_GlobalInvocationID.x >= frame.count) return;
    int index = int(gl_GlobalInvocationID.x);
    ColouredSplat projected = projectColoured(index, frame.view);
    ScreenSplat s = projected.screen;
    int first = index * kScreenTexels;
    screen[first] = vec4(s.mean, s.conic.xy);
    screen[first + 1] = vec4(s.conic.z, s.opacity, s.depthMm, s.extent.x);
    screen[first + 2] = vec4(projected.colour, s.extent.y);
}
