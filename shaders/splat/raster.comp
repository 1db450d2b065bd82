// Draws a picture of splats: each tile blends the splats that show in it, front to back.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/frame.glsl"
#include "splat/screen.glsl"
#include "splat/tiles.glsl"

layout(binding = 4, scalar) writeonly buffer Picture {
    vec4 picture[];
};
layout(binding = 5, scalar) writeonly buffer Depths {
    float depths[];
};

void main() {
    SplatView view = frame.view;
    ivec2 first = firstPixel();
    vec2 centre = vec2(first) + vec2(0.5);
    float transmittance[kRows];
    vec3 colour[kRows];
    float depth[kRows];
    [[unroll]] for (int row = 0; row < kRows; ++row) {
        transmittance[row] = 1.0;
        colour[row] = vec3(0.0);
        depth[row] = 0.0;
    }
    uvec2 range = entriesOfTile();
    float most = 1.0;  // the largest transmittance of the thread's pixels
    for (uint at = range.x; at < range.y && most >= view.minTransmittance; ++at) {
        Shown shown = fetchShown(int(texelFetch(entryTexels, int(at)).x));
        most = 0.0;
        [[unroll]] for (int row = 0; row < kRows; ++row) {
            float raw = rawAlphaAt(shown.screen, centre + vec2(0.0, float(row)));
            float weight = takeWeight(transmittance[row], limitedAlpha(raw, view), view);
            colour[row] += shown.colour * weight;
            depth[row] += shown.screen.depthMm * weight;
            most = max(most, transmittance[row]);
        }
    }
    if (first.x >= view.sizePx.x) return;
    [[unroll]] for (int row = 0; row < kRows; ++row) {
        if (first.y + row < view.sizePx.y) {
            int pixel = (first.y + row) * view.sizePx.x + first.x;
            picture[pixel] = vec4(colour[row], 1.0 - transmittance[row]);
            depths[pixel] = depth[row];
        }
    }
}
