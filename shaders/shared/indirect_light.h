// The cache of indirect light: shaders/lib/indirect.glsl, src/pipeline/trace/indirect_cache.h.
#ifndef MACULA_SHARED_INDIRECT_LIGHT_H
#define MACULA_SHARED_INDIRECT_LIGHT_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST uint kIndirectBuckets = 65536u;  // a power of two
MACULA_SHARED_CONST uint kIndirectWays = 4u;         // cells that share a bucket: their tags are one texel
// A cell is as wide as half to all of so many pixels, but at least as kIndirectLeastVoxels of the smallest
// voxel spacing.
MACULA_SHARED_CONST float kIndirectCellPixels = 4.0f;
MACULA_SHARED_CONST float kIndirectLeastVoxels = 2.0f;

// Light is summed in integers, so that the order of threads does not matter. A unit is the environment's mean
// radiance over kIndirectUnitsOfMean.
MACULA_SHARED_CONST float kIndirectUnitsOfMean = 4096.0f;
MACULA_SHARED_CONST uint kIndirectMostUnits = 1u << 19u;  // of one sample
MACULA_SHARED_CONST uint kIndirectMostSamples = 4096u;    // of a cell: later ones are dropped
MACULA_SHARED_CONST uint kIndirectMostRecords = 65536u;   // of a picture

// The indirect light that a pixel's path found, for the cell of its first vertex.
struct IndirectRecord {
    uvec4 cells;  // bucket and tag, then those of the next wider cell; tag 0: nothing found
    vec3 light;   // radiance from other matter, averaged over all directions at the vertex
};

struct IndirectPush {
    uint recordCount;
    float unit;  // radiance of one unit
};

MACULA_SHARED_END
#endif
