// Finds the layers of a picture: the depths from which each pixel's light comes, see lib/layers.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OF_LAYERS
#define MARCH_STEP layerStep
void layerStep(float before, float after, float fromMm, float perDepth);
#include "trace/host.glsl"
#include "shared/pixel_layers.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 16, scalar) writeonly buffer Pixels {
    PixelLayers pixels[];
};
layout(push_constant, scalar) uniform Push {
    LayersPush push;
};

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, push.firstRow);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;
    LayeredRay ray = layersOf(vec2(pixel) + vec2(0.5));
    PixelLayers found;
    found.nearMm = vec4(layerMm[0], layerMm[1], layerMm[2], layerMm[3]);
    found.farMm = vec4(layerMm[4], layerMm[5], layerMm[6], layerMm[7]);
    found.coverage = ray.coverage;
    found.meanMm = ray.meanMm;
    pixels[pixel.y * params.imageSize.x + pixel.x] = found;
}
