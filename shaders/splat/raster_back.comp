// The derivative of a loss with respect to the projected splats: for each pair of a tile and a splat in it,
// the sum over the tile's pixels, in a separate place. No two threads add to the same number, so that the
// sums are the same each time.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_vote : require

#include "splat/frame.glsl"
#include "splat/screen.glsl"
#include "splat/tiles.glsl"

layout(constant_id = 3) const int kSlots = 1;  // subgroups of a tile
layout(constant_id = 4) const int kLanes = 8;  // threads of a tile in a subgroup: 8 to 64

layout(binding = 4) uniform samplerBuffer pictureTexels;   // the output of raster.comp
layout(binding = 5) uniform samplerBuffer gradientTexels;  // of the loss with respect to the picture
layout(binding = 6, scalar) writeonly buffer Pairs {
    float pairs[];
};

// Sums eight values over all lanes: lane j of every eight gets the sum of value j.
float sumsOfEight(float v[8]) {
    uint lane = gl_SubgroupInvocationID;
    bool high4 = (lane & 4u) != 0u;
    bool high2 = (lane & 2u) != 0u;
    bool high1 = (lane & 1u) != 0u;
    float four[4];
    [[unroll]] for (int i = 0; i < 4; ++i) four[i] =
        (high4 ? v[i + 4] : v[i]) + subgroupShuffleXor(high4 ? v[i] : v[i + 4], 4u);
    float two[2];
    [[unroll]] for (int i = 0; i < 2; ++i) two[i] =
        (high2 ? four[i + 2] : four[i]) + subgroupShuffleXor(high2 ? four[i] : four[i + 2], 2u);
    float sum = (high1 ? two[1] : two[0]) + subgroupShuffleXor(high1 ? two[0] : two[1], 1u);
    if (kLanes > 8) sum += subgroupShuffleXor(sum, 8u);
    if (kLanes > 16) sum += subgroupShuffleXor(sum, 16u);
    if (kLanes > 32) sum += subgroupShuffleXor(sum, 32u);
    return sum;
}

// The index of a pair's sums for the thread's subgroup.
uint placeOf(uint pair) {
    return (pair * uint(kSlots) + gl_SubgroupID) * uint(kPairValues);
}

// The values of the lane whose number differs in the bits of `mask`.
vec3 ofLane(vec3 v, uint mask) {
    return vec3(subgroupShuffleXor(v.x, mask), subgroupShuffleXor(v.y, mask), subgroupShuffleXor(v.z, mask));
}
vec3 sumsOfThree(vec3 v) {
    v += ofLane(v, 1u);
    v += ofLane(v, 2u);
    v += ofLane(v, 4u);
    if (kLanes > 8) v += ofLane(v, 8u);
    if (kLanes > 16) v += ofLane(v, 16u);
    if (kLanes > 32) v += ofLane(v, 32u);
    return v;
}

void main() {
    SplatView view = frame.view;
    ivec2 first = firstPixel();
    vec2 centre = vec2(first) + vec2(0.5);
    PixelGradient gradient[kRows];
    float transmittance[kRows];
    float remaining[kRows];
    [[unroll]] for (int row = 0; row < kRows; ++row) {
        bool inside = first.x < view.sizePx.x && first.y + row < view.sizePx.y;
        int pixel = inside ? (first.y + row) * view.sizePx.x + first.x : 0;
        vec4 g = texelFetch(gradientTexels, pixel) * (inside ? 1.0 : 0.0);
        gradient[row] = PixelGradient(g, 0.0);
        transmittance[row] = inside ? 1.0 : 0.0;
        remaining[row] = dot(texelFetch(pictureTexels, pixel), g);
    }
    uvec2 range = entriesOfTile();
    uint at = range.x;
    // Stops when all pixels are below minTransmittance. All lanes of a subgroup continue together, because
    // they share sums.
    for (float most = 1.0; at < range.y && subgroupAny(most >= view.minTransmittance); ++at) {
        uvec2 entry = texelFetch(entryTexels, int(at)).xy;
        Shown shown = fetchShown(int(entry.x));
        ScreenGradient sum = noGradient();
        float weight = 0.0;
        float pull = 0.0;
        most = 0.0;
        [[unroll]] for (int row = 0; row < kRows; ++row) {
            weight += transmittance[row];
            vec2 before = sum.mean;
            addPixelGradient(shown.screen, shown.colour, centre + vec2(0.0, float(row)), gradient[row], view,
                             transmittance[row], remaining[row], sum);
            weight -= transmittance[row];
            pull += abs(sum.mean.x - before.x) + abs(sum.mean.y - before.y);
            most = max(most, transmittance[row]);
        }
        float values[8] = float[8](sum.mean.x, sum.mean.y, sum.conic.x, sum.conic.y, sum.conic.z, sum.opacity,
                                   sum.colour.x, sum.colour.y);
        float eight = sumsOfEight(values);
        vec3 three = sumsOfThree(vec3(sum.colour.z, weight, pull));
        uint place = placeOf(entry.y);
        if (gl_SubgroupInvocationID < 8u) pairs[place + gl_SubgroupInvocationID] = eight;
        if (gl_SubgroupInvocationID < 3u)
            pairs[place + 8u + gl_SubgroupInvocationID] = three[gl_SubgroupInvocationID];
    }
    for (; at < range.y; ++at) {
        uint place = placeOf(texelFetch(entryTexels, int(at)).y);
        for (uint v = gl_SubgroupInvocationID; v < uint(kPairValues); v += uint(kLanes))
            pairs[place + v] = 0.0;
    }
}
