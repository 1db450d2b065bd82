// What a picture is traced from: one block of parameters, and push constants per dispatch.
#ifndef MACULA_SHARED_TRACE_PARAMS_H
#define MACULA_SHARED_TRACE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

// Voxel coordinates here have integers at voxel faces: the volume fills [0, volumeSize].
struct TraceParams {
    vec3 originVoxel;           // the eye
    vec3 right;                 // world; half the width of the picture at distance 1
    vec3 up;                    // world; half its height
    vec3 forward;               // world, unit
    vec3 voxelFromWorldX;       // columns of the linear part: voxels per mm along world x, y, z
    vec3 voxelFromWorldY;
    vec3 voxelFromWorldZ;
    vec3 worldFromEnvironmentX;  // columns of a rotation
    vec3 worldFromEnvironmentY;
    vec3 worldFromEnvironmentZ;
    ivec3 volumeSize;           // voxels
    ivec3 gridSize;             // bricks
    ivec2 imageSize;            // pixels
    ivec2 environmentSize;      // texels
    int bounces;                // vertices of a path
    uint seed;
    float anisotropy;           // Henyey-Greenstein g
    float marchStepMm;          // of the deterministic march for depth
};

// The blocks of 8 x 8 pixels of a picture are visited in the order (i * blockStride) mod blockCount, blockStride coprime to
// blockCount: any run of them is spread over the whole picture.
struct PathPush {
    uint firstBlock;   // i of the first block of this dispatch
    uint blockCount;   // of the picture
    uint blockStride;
    uint firstSample;  // index of the first sample of this dispatch, for the random sequence
    uint sampleCount;
};

struct DisplayPush {
    vec3 background;  // linear
    float exposure;
    int smoothing;    // radius in pixels of the binomial filter over the means
};

MACULA_SHARED_END
#endif
