// What a picture is traced from: one block of parameters, and push constants per dispatch.
#ifndef MACULA_SHARED_TRACE_PARAMS_H
#define MACULA_SHARED_TRACE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST int kMaxClipPlanes = 15;  // six of a box, six given, three of a corner
MACULA_SHARED_CONST int kClipNoBall = 0;
MACULA_SHARED_CONST int kClipKeepBall = 1;
MACULA_SHARED_CONST int kClipCutBall = 2;

MACULA_SHARED_CONST int kCoatSteps = 32;
MACULA_SHARED_CONST int kCoatPlaces = kCoatSteps + 1;

// What is cast: matter, or a projection of values.
MACULA_SHARED_CONST int kCastMatter = 0;
MACULA_SHARED_CONST int kCastMaximum = 1;
MACULA_SHARED_CONST int kCastMinimum = 2;
MACULA_SHARED_CONST int kCastMean = 3;

// All that a picture is traced from, once: the struct below is made of it, and so is that of the tracer in
// C++ that the device is held to (src/pipeline/trace/reference_host.inl), in its precision. Voxel coordinates
// here have integers at voxel faces: the volume fills [0, volumeSize].
#define MACULA_TRACE_PARAMS(FIELD, ARRAY)                                                                   \
    FIELD(vec3, originVoxel)     /* the eye */                                                              \
    FIELD(vec3, right)           /* world; half the width of the picture at distance 1 */                   \
    FIELD(vec3, up)              /* world; half its height */                                               \
    FIELD(vec3, forward)         /* world, unit */                                                          \
    FIELD(vec3, voxelFromWorldX) /* columns of the linear part: voxels per mm along world x, y, z */        \
    FIELD(vec3, voxelFromWorldY)                                                                            \
    FIELD(vec3, voxelFromWorldZ)                                                                            \
    FIELD(vec3, worldFromEnvironmentX) /* columns of a rotation */                                          \
    FIELD(vec3, worldFromEnvironmentY)                                                                      \
    FIELD(vec3, worldFromEnvironmentZ)                                                                      \
    FIELD(ivec3, volumeSize)      /* voxels */                                                              \
    FIELD(ivec3, gridSize)        /* bricks */                                                              \
    FIELD(ivec2, imageSize)       /* pixels */                                                              \
    FIELD(ivec2, environmentSize) /* texels */                                                              \
    FIELD(int, bounces)           /* vertices of a path */                                                  \
    FIELD(uint, seed)                                                                                       \
    FIELD(float, anisotropy) /* Henyey-Greenstein g */                                                      \
    /* Surfaces, see shaders/lib/material.glsl. */                                                          \
    FIELD(float, surfaceWeight)           /* 0: there are none */                                           \
    FIELD(float, surfaceGradient)         /* entries per mm, at which half of that is surface */            \
    FIELD(float, surfaceAlpha)            /* width of the distribution of facets */                         \
    FIELD(float, surfaceReflectance)      /* of a facet, of light that falls on it straight */              \
    ARRAY(float, coatAlbedo, kCoatPlaces) /* by the root of the cosine, see shaders/lib/scattering.glsl */  \
    FIELD(float, coatMean)                /* of light from all sides */                                     \
    /* What is clipped, see shaders/lib/clip.glsl. A plane keeps dot(xyz, p) + w >= 0, p in voxel           \
     * coordinates. */                                                                                      \
    ARRAY(vec4, clipPlanes,                                                                                 \
          kMaxClipPlanes)       /* of the region that is kept, of a box that is cut out, of a corner */     \
    FIELD(vec3, clipBallCentre) /* voxel coordinates */                                                     \
    FIELD(vec3, clipBallX)      /* columns of the map from voxels to radii of the ball */                   \
    FIELD(vec3, clipBallY)                                                                                  \
    FIELD(vec3, clipBallZ)                                                                                  \
    FIELD(int, clipKeepCount) /* planes */                                                                  \
    FIELD(int, clipBoxCount)                                                                                \
    FIELD(int, clipCornerCount)                                                                             \
    FIELD(int, clipBall)    /* one of the three above */                                                    \
    FIELD(int, clipShadows) /* 1: what is removed is hidden from the eye only, and still casts shadow */    \
    FIELD(int, greyFaces)   /* 1: the faces of the clip show the values themselves; 2: and are black, not   \
                               clear, below the window */                                                   \
    FIELD(float, greyLow)   /* table entry that is black there */                                           \
    FIELD(float, greyHigh)  /* table entry that is white there */                                           \
    FIELD(float, exposure)  /* that will be applied: grey is divided by it */                               \
    FIELD(int, keepsHue)    /* the tone map that will be applied, as in DisplayPush */                      \
    /* Where the picture is stored larger, see shaders/lib/fovea.glsl; magnification 1: nowhere. */         \
    FIELD(vec2, planeHalfSize)                                                                              \
    FIELD(vec2, gaze)                                                                                       \
    FIELD(float, foveaRadius)                                                                               \
    FIELD(float, foveaMagnification)                                                                        \
    FIELD(float, parallelMm) /* above 0: rays are parallel, and the picture shows what an eye would at this \
                                distance */                                                                 \
    FIELD(float, lensRadiusMm)  /* 0: all is sharp */                                                       \
    FIELD(float, lensFocusMm)   /* along the view, from the eye to what is sharp */                         \
    FIELD(float, lightStrength) /* multiplies what the environment sends */                                 \
    /* The cache of indirect light, see shaders/lib/indirect.glsl. */                                       \
    FIELD(vec3, indirectCellsPerVoxel) /* of the smallest cells */                                          \
    FIELD(float, indirectWidth) /* of a cell, in smallest cells: of a parallel view; else at a distance of  \
                                   one of them */                                                           \
    FIELD(float, indirectUnit)  /* radiance of one unit of its sums */                                      \
    FIELD(float, indirectLeast) /* the least chance of a path to go on where the cache is a control         \
                                   variate; 0: its light is taken for true */                               \
    FIELD(int, indirectStride)  /* of rows and columns of pixels one in so many tells what it finds */      \
    /* Gradient opacity, see shaders/lib/gradient.glsl. */                                                  \
    FIELD(float, gradientScale) /* steps of its table per (entry per mm) */                                 \
    FIELD(int, gradientLast)    /* index of its last step; 0: none */                                       \
    FIELD(float, unitDepthMm)   /* unit distance of the opacities, divided by the density */                \
    /* Curves of steep matter, see shaders/lib/gradient.glsl. */                                            \
    FIELD(float, steepGradient) /* entries per mm, at which half of the matter is steep */                  \
    FIELD(int, steepFirst)      /* where its extinctions begin in the table of extinctions */               \
    /* Ray casting, see shaders/lib/cast.glsl. */                                                           \
    FIELD(int, entryCount)      /* of the tables */                                                         \
    FIELD(float, windowLow)     /* entry that is black */                                                   \
    FIELD(float, windowHigh)    /* entry that is white */                                                   \
    FIELD(float, paddingEntry)  /* what padding became; -1: there is none */                                \
    FIELD(float, stepsPerEntry) /* integration steps for a change of the value by one entry */              \
    FIELD(float, ambient)       /* of a headlight */                                                        \
    FIELD(float, diffuse)                                                                                   \
    /* What is beside the volume, see shaders/lib/mixture.glsl. */                                          \
    FIELD(vec3, secondOrigin)     /* of voxel coordinates, in those of the second volume */                 \
    FIELD(vec3, secondFromVoxelX) /* columns: its voxels per voxel */                                       \
    FIELD(vec3, secondFromVoxelY)                                                                           \
    FIELD(vec3, secondFromVoxelZ)                                                                           \
    FIELD(ivec3, secondSize) /* voxels */                                                                   \
    FIELD(ivec3, secondGrid) /* bricks */                                                                   \
    FIELD(int,                                                                                              \
          secondEntryCount) /* of its table; after it come the colours of segments, from the first on */    \
    FIELD(float, secondStepsPerEntry) /* as stepsPerEntry */                                                \
    FIELD(ivec3, tintLow)             /* the box that holds all voxels of segments */                       \
    FIELD(ivec3, tintSize)

#define MACULA_MEMBER(type, name) type name;
#define MACULA_ARRAY_MEMBER(type, name, count) type name[count];
struct TraceParams {
    MACULA_TRACE_PARAMS(MACULA_MEMBER, MACULA_ARRAY_MEMBER)
};
#undef MACULA_MEMBER
#undef MACULA_ARRAY_MEMBER

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

// Samples that are traced side by side: what path_side.comp takes from.
struct SidePush {
    uint blockCount;   // of the plan
    uint mostSamples;  // that a block of it has
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
    int keepsHue;    // as in DisplayPush
};

struct VariancePush {
    ivec2 imageSize;
};

struct DisplayPush {
    vec3 background;  // in linear light, displayed as it is
    float exposure;
    int smoothing;  // radius in pixels of the binomial filter over the means
    int denoised;   // 1: the sums are means, and the counts do not count
    int keepsHue;   // 1: toneMapHue, else toneMapNeutral (shaders/lib/picture.glsl)
};

MACULA_SHARED_END
#endif
