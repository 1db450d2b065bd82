// Declarations that all kernels of the loss share: the parameters, and the comparison of two pixels.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "lib/splat_loss.glsl"
#include "lib/splat_ssim.glsl"
#include "shared/splat_loss_params.h"

layout(binding = 0, scalar) readonly buffer Params {
    SplatLossParams params;
};

struct LossPair {
    vec4 sum;  // of the two pictures, as they are compared
    vec4 difference;
};

// A pixel that is not finite counts as equal in both; as black in both if it is the target's (not `known`).
LossPair pairOf(vec4 render, vec4 truth, bool known, bool display) {
    if (!known) return LossPair(vec4(0.0), vec4(0.0));
    render = isFinite(render) ? render : truth;
    ComparedPixel ours = comparedPixel(render, params.background, params.exposure, display);
    ComparedPixel theirs = comparedPixel(truth, params.background, params.exposure, display);
    vec4 x = ours.value;
    vec4 y = theirs.value;
    vec4 difference = x - y;
    if (params.squareScale > 0.0)
        difference.xyz = comparedChange(ours.over, ours.over - theirs.over, display);
    if (params.coverageOnly != 0u) {
        y.xyz = x.xyz;
        difference.xyz = vec3(0.0);
    }
    return LossPair(x + y, difference);
}

// The gradient of the loss with respect to a finite premultiplied pixel whose target is known; `ofSimilarity`
// is the gradient of 1 - SSIM with respect to the compared pixel.
vec4 gradientOf(vec4 render, vec4 difference, vec4 ofSimilarity, bool display) {
    vec4 back = params.l1Scale * sign(difference) + 2.0 * params.squareScale * difference +
                params.dssimScale * ofSimilarity;
    vec3 over = comparedPixel(render, params.background, params.exposure, display).over;
    return comparedPixelBack(over, back, params.background, params.exposure, display);
}

// A pixel's terms of the sums of the loss: |difference|, its square; 1 if the render is not finite; 0.
vec4 lossPartOf(vec4 render, vec4 difference) {
    return vec4(dot(abs(difference), vec4(1.0)), dot(difference, difference), isFinite(render) ? 0.0 : 1.0,
                0.0);
}
