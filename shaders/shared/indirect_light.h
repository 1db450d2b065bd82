// The cache of indirect light: shaders/lib/indirect.glsl, src/pipeline/trace/indirect_cache.h.
#ifndef MACULA_SHARED_INDIRECT_LIGHT_H
#define MACULA_SHARED_INDIRECT_LIGHT_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST uint kIndirectBuckets = 65536u;  // a power of two
MACULA_SHARED_CONST uint kIndirectWays = 4u;         // cells that share a bucket: their tags are one texel
// A cell is half to all as wide as so many pixels, but has at least kIndirectLeastVoxels along its shortest
// side.
MACULA_SHARED_CONST float kIndirectCellPixels = 4.0f;
MACULA_SHARED_CONST float kIndirectLeastVoxels = 2.0f;

// Light is summed in integers, whose sum is the same in any order: in units of the mean radiance of the
// environment over kIndirectUnitsOfMean.
MACULA_SHARED_CONST float kIndirectUnitsOfMean = 4096.0f;
MACULA_SHARED_CONST uint kIndirectMostUnits = 1u << 19u;  // of one sample
MACULA_SHARED_CONST uint kIndirectMostSamples = 4096u;    // of a cell: what comes later is left out
MACULA_SHARED_CONST uint kIndirectMostRecords = 65536u;   // of a picture

// What a pixel's path has found for the cell of its first vertex.
struct IndirectRecord {
    uvec4 cells;  // bucket and tag, and those of the wider cell; tag 0: nothing was found
    vec3 light;   // radiance over all directions around the vertex, on average, that comes from other matter
};

struct IndirectPush {
    uint recordCount;
    float unit;  // of radiance
};

MACULA_SHARED_END
#endif
