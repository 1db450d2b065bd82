// Distance in mm from the eye to the point where transmittance falls to one half, along the centre ray of each pixel;
// negative where it does not.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 8, scalar) writeonly buffer Distances {
    float distanceMm[];
};
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;
    vec3 direction = eyeDirection(vec2(pixel) + vec2(0.5));
    BrickWalk walk = startEyeWalk(params.originVoxel, voxelsPerMm(direction));
    distanceMm[pixel.y * params.imageSize.x + pixel.x] = halfTransmittanceDistance(walk, params.marchStepMm);
}
