// What shaders/lib needs from its host, for devices: tables in texel buffers, by far the fastest read-only
// arrays on CPU devices, and as fast as any on others. The C++ counterpart is
// src/pipeline/trace/shader_host.inl.
#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise

#include "shared/indirect_light.h"
#include "shared/trace_params.h"

layout(constant_id = 0) const bool kTrilinear = true;
layout(constant_id = 15) const bool kSmooth = false;
layout(constant_id = 19) const bool kSharp = false;
layout(constant_id = 16) const bool kSurfaces = false;
layout(constant_id = 2) const bool kClip = false;
layout(constant_id = 3) const bool kMask = false;
layout(constant_id = 4) const bool kGradientOpacity = false;
layout(constant_id = 17) const bool kSteep = false;
layout(constant_id = 18) const bool kSteepDensity = false;
layout(constant_id = 5) const bool kShading = false;
layout(constant_id = 6) const int kCast = 0;
layout(constant_id = 8) const bool kCoarse = true;  // some blocks of voxels are kept coarsely
layout(constant_id = 9) const bool kSecond = false;
layout(constant_id = 10) const bool kTints = false;
layout(constant_id = 11) const int kPoolViews = 1;      // 1 to 4
layout(constant_id = 12) const int kPoolViewShift = 0;  // log2 of the values in each view but the last
#ifdef OF_SURFACE_POINTS
layout(constant_id = 7) const bool kGreyFaces = false;
#else
const bool kGreyFaces = false;  // only kernels of surface points ask for it
#endif

// Not a uniform block: lavapipe (Mesa 22.3) compiles a uniform that decides a branch into the shader, and so
// would compile it again, for a tenth of a second, whenever the camera moves.
layout(binding = 0, scalar) readonly buffer Params {
    TraceParams params;
};
layout(binding = 1) uniform usamplerBuffer poolTexels;  // the pool: voxels of blocks, as table entries
layout(binding = 2) uniform samplerBuffer
    extinctionTexels;  // per mm, by entry; then gradient opacities; then extinctions of steep matter
layout(binding = 3) uniform samplerBuffer
    albedoTexels;  // by entry, extinction per mm in w; then the same of steep matter
layout(binding = 4) uniform samplerBuffer boundTexels;        // by brick
layout(binding = 5) uniform samplerBuffer environmentTexels;  // radiance and pdf per steradian, by texel
layout(binding = 6) uniform samplerBuffer cumulativeTexels;   // see environment.glsl
layout(binding = 7) uniform usamplerBuffer
    blockTexels;  // by brick, words of four blocks: level and place in the pool
layout(binding = 8) uniform usamplerBuffer maskTexels;  // a bit for each voxel: whether the mask shows it
layout(binding = 9) uniform usamplerBuffer secondPoolTexels;  // of a second volume, as poolTexels
layout(binding = 10) uniform usamplerBuffer secondBlockTexels;
layout(binding = 11) uniform samplerBuffer
    additionTexels;  // albedo and extinction of the second volume by entry; then colours of segments
layout(binding = 12) uniform usamplerBuffer
    tintTexels;  // four voxels of segments in a word: which colour, 0: none
layout(binding = 13) uniform usamplerBuffer poolTexels1;  // more views of the pool, if it needs them
layout(binding = 14) uniform usamplerBuffer poolTexels2;
layout(binding = 15) uniform usamplerBuffer poolTexels3;

uint poolValue(int index) {
    if (kPoolViews == 1) return texelFetch(poolTexels, index).x;
    int view = index >> kPoolViewShift;
    int at = index & ((1 << kPoolViewShift) - 1);
    uint value = 0u;
    if (view == 0) value = texelFetch(poolTexels, at).x;
    if (view == 1) value = texelFetch(poolTexels1, at).x;
    if (kPoolViews > 2 && view == 2) value = texelFetch(poolTexels2, at).x;
    if (kPoolViews > 3 && view == 3) value = texelFetch(poolTexels3, at).x;
    return value;
}

// Voxels are kept in blocks of 8 x 8 x 8. The word of a block has its level, 0 to 3 halvings of its edge
// (bits 30 and 31), and its place in the pool, in units of 8 values; or, at level 3, its single value. A
// block that no visible brick touches also has a single value, one of its own, so that even a point that
// rounding carries across a face meets no matter there (src/pipeline/volume/voxel_blocks.h).
const uint kOneValue = 3u;  // the level of a block with a single value

// The index in the pool of a voxel's value. A block with a single value has none there, and gets index 0,
// which can be read.
int placeIn(uint word, ivec3 within) {
    int level = int(word >> 30);
    int inside = (within.z << 6) | (within.y << 3) | within.x;
    if (kCoarse) {
        ivec3 cell = within >> level;
        inside = (((cell.z << (3 - level)) | cell.y) << (3 - level)) | cell.x;
    }
    return level == int(kOneValue) ? 0 : (int(word & 0x3fffffffu) << 3) + inside;
}
float valueOf(uint word, uint inPool) {
    return float(word >> 30 == kOneValue ? word & 0x3fffffffu : inPool);
}

float valueIn(uint word, ivec3 within) {
    return valueOf(word, poolValue(placeIn(word, within)));
}
// The same for the second volume.
float secondValueIn(uint word, ivec3 within) {
    return valueOf(word, texelFetch(secondPoolTexels, placeIn(word, within)).x);
}

// A texel of the table has four words, which costs little more to fetch than one: for brick (x, y) those of
// the blocks (x - 1, y - 1), (x, y - 1), (x - 1, y), (x, y), in layers of blocks along z.
int tableIndex(ivec2 brick, int layer) {
    return (layer * params.gridSize.y + brick.y) * params.gridSize.x + brick.x;
}

float fetchStored(ivec3 voxel) {
    ivec3 block = voxel >> 3;
    return valueIn(texelFetch(blockTexels, tableIndex(block.xy, block.z)).w, voxel & ivec3(7));
}

void fetchCorners(ivec3 low, ivec3 high, out vec4 near, out vec4 far) {
    ivec2 brick = (low.xy + ivec2(1)) >> 3;
    uvec4 nearWords = texelFetch(blockTexels, tableIndex(brick, low.z >> 3));
    uvec4 farWords = texelFetch(blockTexels, tableIndex(brick, high.z >> 3));
    // A low corner may lie in the previous block. A high one never does: at the end of the volume both words
    // are the same.
    ivec3 inLow = low & ivec3(7);
    ivec3 inHigh = high & ivec3(7);
    if (inLow.x < 7) {
        nearWords.xz = nearWords.yw;
        farWords.xz = farWords.yw;
    }
    if (inLow.y < 7) {
        nearWords.xy = nearWords.zw;
        farWords.xy = farWords.zw;
    }
    near = vec4(valueIn(nearWords.x, inLow), valueIn(nearWords.y, ivec3(inHigh.x, inLow.y, inLow.z)),
                valueIn(nearWords.z, ivec3(inLow.x, inHigh.y, inLow.z)),
                valueIn(nearWords.w, ivec3(inHigh.x, inHigh.y, inLow.z)));
    far = vec4(valueIn(farWords.x, ivec3(inLow.x, inLow.y, inHigh.z)),
               valueIn(farWords.y, ivec3(inHigh.x, inLow.y, inHigh.z)),
               valueIn(farWords.z, ivec3(inLow.x, inHigh.y, inHigh.z)), valueIn(farWords.w, inHigh));
}

// The words of the blocks in which a brick lies, as in the table: at the low end of z, and at the high end.
struct Blocks {
    uvec4 near;
    uvec4 far;
    ivec3 high;  // the first voxel of the high blocks
};
Blocks blocksOfBrick(ivec3 brick) {
    Blocks blocks;
    int last = (params.volumeSize.z - 1) >> 3;
    blocks.near = texelFetch(blockTexels, tableIndex(brick.xy, max(brick.z - 1, 0)));
    blocks.far = texelFetch(blockTexels, tableIndex(brick.xy, min(brick.z, last)));
    blocks.high = brick << 3;
    return blocks;
}
float fetchFrom(Blocks blocks, ivec3 voxel) {
    uvec4 layer = voxel.z >= blocks.high.z ? blocks.far : blocks.near;
    uvec2 row = voxel.y >= blocks.high.y ? layer.zw : layer.xy;
    return valueIn(voxel.x >= blocks.high.x ? row.y : row.x, voxel & ivec3(7));
}

float fetchExtinction(int entry) {
    return texelFetch(extinctionTexels, entry).x;
}
float fetchGradientOpacity(int step) {
    return texelFetch(extinctionTexels, params.entryCount + step).x;
}
vec3 fetchAlbedo(int entry) {
    return texelFetch(albedoTexels, entry).xyz;
}
vec4 fetchMatter(int entry) {
    return texelFetch(albedoTexels, entry);
}
bool useSteep() {
    return kSteep;
}
bool useSteepDensity() {
    return kSteepDensity;
}
float fetchSteepExtinction(int entry) {
    return texelFetch(extinctionTexels, params.steepFirst + entry).x;
}
vec4 fetchSteepMatter(int entry) {
    return texelFetch(albedoTexels, params.entryCount + entry);
}
float fetchBound(int brick) {
    return texelFetch(boundTexels, brick).x;
}
vec4 fetchEnvironment(int texel) {
    return texelFetch(environmentTexels, texel);
}
float fetchCumulative(int index) {
    return texelFetch(cumulativeTexels, index).x;
}
bool useTrilinear() {
    return kTrilinear;
}
bool useSmooth() {
    return kSmooth;
}
bool useSharp() {
    return kSharp;
}
bool useClip() {
    return kClip;
}
bool useMask() {
    return kMask;
}
float fetchMask(ivec3 voxel) {
    int n = (voxel.z * params.volumeSize.y + voxel.y) * params.volumeSize.x + voxel.x;
    return float((texelFetch(maskTexels, n >> 5).x >> (n & 31)) & 1u);
}
bool useSecond() {
    return kSecond;
}
float fetchSecond(ivec3 voxel) {
    ivec3 block = voxel >> 3;
    int brick = (block.z * params.secondGrid.y + block.y) * params.secondGrid.x + block.x;
    return secondValueIn(texelFetch(secondBlockTexels, brick).w, voxel & ivec3(7));
}
vec4 fetchSecondMatter(int entry) {
    return texelFetch(additionTexels, entry);
}
bool useTints() {
    return kTints;
}
int fetchTint(ivec3 voxel) {
    ivec3 at = voxel - params.tintLow;
    if (any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, params.tintSize))) return 0;
    int n = (at.z * params.tintSize.y + at.y) * params.tintSize.x + at.x;
    return int((texelFetch(tintTexels, n >> 2).x >> ((n & 3) << 3)) & 255u);
}
vec4 fetchTintColour(int tint) {
    return texelFetch(additionTexels, params.secondEntryCount + tint - 1);
}
bool useSurfaces() {
    return kSurfaces;
}
bool useGradientOpacity() {
    return kGradientOpacity;
}
bool useShading() {
    return kShading;
}
int castLook() {
    return kCast;
}
bool hasGreyFaces() {
    return kGreyFaces;
}

#ifdef INDIRECT_BINDING  // first of three bindings, in kernels that trace paths
layout(constant_id = 13) const bool kIndirect = false;
layout(binding = INDIRECT_BINDING) uniform usamplerBuffer indirectTags;       // tags of four cells, by bucket
layout(binding = INDIRECT_BINDING + 1) uniform usamplerBuffer indirectCells;  // sums of light, and samples
layout(binding = INDIRECT_BINDING + 2, scalar) writeonly buffer IndirectRecords {
    IndirectRecord indirectRecords[];
};
bool useIndirect() {
    return kIndirect;
}
uvec4 fetchIndirectTags(int bucket) {
    return texelFetch(indirectTags, bucket);
}
uvec4 fetchIndirectCell(int cell) {
    return texelFetch(indirectCells, cell);
}
#else
bool useIndirect() {
    return false;
}
uvec4 fetchIndirectTags(int bucket) {
    return uvec4(0u);
}
uvec4 fetchIndirectCell(int cell) {
    return uvec4(0u);
}
#endif

#include "lib/trace_lib.glsl"

#ifdef INDIRECT_BINDING
// Records the indirect light of the pixel's last path that continued from its first vertex; only for one
// pixel in each stride.
void tellIndirect(ivec2 pixel, IndirectRecord record) {
    ivec2 at = pixel + ivec2(params.seed % 61u, params.seed % 59u);
    if (record.cells.y == 0u || at.x % params.indirectStride != 0 || at.y % params.indirectStride != 0)
        return;
    ivec2 place = pixel / params.indirectStride;
    int columns = (params.imageSize.x + params.indirectStride - 1) / params.indirectStride;
    indirectRecords[place.y * columns + place.x] = record;
}
#endif
