// Computes the guides of a picture from the centre ray of each pixel, see lib/guides.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"
#include "shared/guide_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 16, scalar) writeonly buffer Surfaces {
    vec4 surfaces[];  // normal, depth
};
layout(binding = 17, scalar) writeonly buffer Matters {
    vec4 matters[];  // albedo, coverage
};
layout(binding = 18, scalar) writeonly buffer Motions {
    vec4 motions[];  // motion, confidence, distance from the previous eye
};
layout(push_constant, scalar) uniform Push {
    GuidePush push;
};

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, push.firstRow);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;
    Fovea fovea = Fovea(push.planeHalfSize, push.gaze, push.foveaRadius, push.foveaMagnification);
    Guide guide = guideOf(vec2(pixel) + vec2(0.5),
                          Eye(push.oursMm, push.right, push.up, push.forward, fovea, push.parallelMm));
    int index = pixel.y * params.imageSize.x + pixel.x;
    surfaces[index] = vec4(guide.normal, guide.depthMm);
    matters[index] = vec4(guide.albedo, guide.coverage);
    motions[index] = vec4(guide.motion, guide.confidence, guide.beforeMm);
}
