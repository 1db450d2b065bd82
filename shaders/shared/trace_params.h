// What a picture is traced from: one block of parameters, and push constants per dispatch.
#ifndef MACULA_SHARED_TRACE_PARAMS_H
#define MACULA_SHARED_TRACE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST int kMaxClipPlanes = 15;  // six of a box, six given, three of a corner
MACULA_SHARED_CONST int kClipNoBall = 0;
MACULA_SHARED_CONST int kClipKeepBall = 1;
MACULA_SHARED_CONST int kClipCutBall = 2;

// What is cast: matter, or a projection of values.
MACULA_SHARED_CONST int kCastMatter = 0;
MACULA_SHARED_CONST int kCastMaximum = 1;
MACULA_SHARED_CONST int kCastMinimum = 2;
MACULA_SHARED_CONST int kCastMean = 3;

// Voxel coordinates here have integers at voxel faces: the volume fills [0, volumeSize].
struct TraceParams {
    vec3 originVoxel;      // the eye
    vec3 right;            // world; half the width of the picture at distance 1
    vec3 up;               // world; half its height
    vec3 forward;          // world, unit
    vec3 voxelFromWorldX;  // columns of the linear part: voxels per mm along world x, y, z
    vec3 voxelFromWorldY;
    vec3 voxelFromWorldZ;
    vec3 worldFromEnvironmentX;  // columns of a rotation
    vec3 worldFromEnvironmentY;
    vec3 worldFromEnvironmentZ;
    ivec3 volumeSize;       // voxels
    ivec3 gridSize;         // bricks
    ivec2 imageSize;        // pixels
    ivec2 environmentSize;  // texels
    int bounces;            // vertices of a path
    uint seed;
    float anisotropy;  // Henyey-Greenstein g

    // What is clipped, see shaders/lib/clip.glsl. A plane keeps dot(xyz, p) + w >= 0, p in voxel coordinates.
    vec4 clipPlanes[kMaxClipPlanes];  // of the region that is kept, of a box that is cut out, of a corner
    vec3 clipBallCentre;              // voxel coordinates
    vec3 clipBallX;                   // columns of the map from voxels to radii of the ball
    vec3 clipBallY;
    vec3 clipBallZ;
    int clipKeepCount;  // planes
    int clipBoxCount;
    int clipCornerCount;
    int clipBall;     // one of the three above
    int clipShadows;  // 1: what is removed is hidden from the eye only, and still casts shadow
    int greyFaces;  // 1: the faces of the clip show the values themselves; 2: and are black, not clear, below
                    // the window
    float greyLow;  // table entry that is black there
    float greyHigh;  // table entry that is white there
    float exposure;  // that will be applied: grey is divided by it

    // Where the picture is stored larger, see shaders/lib/fovea.glsl; magnification 1: nowhere.
    vec2 planeHalfSize;
    vec2 gaze;
    float foveaRadius;
    float foveaMagnification;
    float parallelMm;  // above 0: rays are parallel, and the picture shows what an eye would at this distance

    float lightStrength;  // multiplies what the environment sends
    // Gradient opacity, see shaders/lib/gradient.glsl.
    float gradientScale;  // steps of its table per (entry per mm)
    int gradientLast;     // index of its last step; 0: none
    float unitDepthMm;    // unit distance of the opacities, divided by the density
    // Ray casting, see shaders/lib/cast.glsl.
    int entryCount;       // of the tables
    float windowLow;      // entry that is black
    float windowHigh;     // entry that is white
    float paddingEntry;   // what padding became; -1: there is none
    float stepsPerEntry;  // integration steps for a change of the value by one entry
    float ambient;        // of a headlight
    float diffuse;
    // What is beside the volume, see shaders/lib/mixture.glsl.
    vec3 secondOrigin;      // of voxel coordinates, in those of the second volume
    vec3 secondFromVoxelX;  // columns: its voxels per voxel
    vec3 secondFromVoxelY;
    vec3 secondFromVoxelZ;
    ivec3 secondSize;           // voxels
    ivec3 secondGrid;           // bricks
    int secondEntryCount;       // of its table; after it come the colours of segments, from the first on
    float secondStepsPerEntry;  // as stepsPerEntry
    ivec3 tintLow;              // the box that holds all voxels of segments
    ivec3 tintSize;
};

MACULA_SHARED_CONST int kBlockEdge = 8;  // pixels; a work group traces such a square of the picture

// So many samples of a pixel, from a multiple of that number on, are one net: together they are less noisy
// than so many independent ones, see shaders/lib/net.glsl. A power of two.
MACULA_SHARED_CONST uint kNetSamples = 4u;

// What a work group does in a dispatch, see src/pipeline/trace/sampling_plan.h. Blocks are numbered row by
// row.
struct PlannedBlock {
    uint block;
    uint firstSample;  // index of its first sample, for the random sequence
    uint sampleCount;
};

// How noisy a block is as it is shown, see shaders/lib/noise.glsl.
struct BlockNoise {
    float squaredError;  // mean over its pixels
    uint isSeen;         // 1: some sample of it met matter or light
};

struct NoisePush {
    ivec2 imageSize;
    uint firstBlock;
    float exposure;
    float backdrop;  // see noise.glsl
};

struct DisplayPush {
    vec3 background;  // linear
    float exposure;
    int smoothing;  // radius in pixels of the binomial filter over the means
    int denoised;   // 1: the sums are means, and the counts do not count
};

MACULA_SHARED_END
#endif
