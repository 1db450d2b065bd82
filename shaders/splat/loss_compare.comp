// First step of the loss: sum and difference of the two pictures, as they are compared. What is not finite in either is
// taken to be equal, and black if it is in the target.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_setup.glsl"

layout(constant_id = 1) const bool kDisplay = false;

layout(binding = 1) uniform samplerBuffer rendered;
layout(binding = 2) uniform samplerBuffer targets;
layout(binding = 3) uniform samplerBuffer windows;  // 0 where the target is not finite
layout(binding = 4, scalar) writeonly buffer Pairs {
    vec4 pairs[];  // sum, difference
};

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;
    int index = pixel.y * params.imageSize.x + pixel.x;
    bool known = texelFetch(windows, index).x > 0.0;
    vec4 truth = known ? texelFetch(targets, index) : vec4(0.0);
    vec4 render = known ? texelFetch(rendered, index) : vec4(0.0);
    render = isFinite(render) ? render : truth;
    ComparedPixel ours = comparedPixel(render, params.background, params.exposure, kDisplay);
    ComparedPixel theirs = comparedPixel(truth, params.background, params.exposure, kDisplay);
    vec4 x = ours.value;
    vec4 y = theirs.value;
    vec4 difference = x - y;
    if (params.squareScale > 0.0) difference.xyz = comparedChange(ours.over, ours.over - theirs.over, kDisplay);
    if (params.coverageOnly != 0u) {
        y.xyz = x.xyz;
        difference.xyz = vec3(0.0);
    }
    pairs[2 * index] = known ? x + y : vec4(0.0);
    pairs[2 * index + 1] = known ? difference : vec4(0.0);
}
