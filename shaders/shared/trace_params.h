// The parameters of a traced picture: one block of them, and the push constants of dispatches.
#ifndef MACULA_SHARED_TRACE_PARAMS_H
#define MACULA_SHARED_TRACE_PARAMS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST int kMaxClipPlanes = 15;  // six of a box, six free ones, three of a corner
// What a clip does with a shape that is not made of planes.
MACULA_SHARED_CONST int kClipWithout = 0;  // there is none
MACULA_SHARED_CONST int kClipKeeps = 1;
MACULA_SHARED_CONST int kClipCuts = 2;

MACULA_SHARED_CONST int kCoatSteps = 32;
MACULA_SHARED_CONST int kCoatPlaces = kCoatSteps + 1;

// The modes of ray casting: matter, or a projection of values.
MACULA_SHARED_CONST int kCastMatter = 0;
MACULA_SHARED_CONST int kCastMaximum = 1;
MACULA_SHARED_CONST int kCastMinimum = 2;
MACULA_SHARED_CONST int kCastMean = 3;

// The one list of fields, from which both the struct below and that of the C++ reference tracer
// (src/pipeline/trace/shader_host.inl), in its own precision, are generated. Voxel coordinates here have
// integers at voxel faces: the volume fills [0, volumeSize].
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
    FIELD(float, surfaceGradient)         /* entries per mm at which half the weight applies */             \
    FIELD(float, surfaceAlpha)            /* width of the distribution of facets */                         \
    FIELD(float, surfaceReflectance)      /* of a facet, at normal incidence */                             \
    ARRAY(float, coatAlbedo, kCoatPlaces) /* by the root of the cosine: shaders/lib/scattering.glsl */      \
    FIELD(float, coatMean)                /* coatAlbedo for light from all sides */                         \
    /* The clip, see shaders/lib/clip.glsl. A plane keeps dot(xyz, p) + w >= 0, p in voxel                  \
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
    FIELD(int, clipBall)    /* kClipWithout, kClipKeeps or kClipCuts */                                     \
    FIELD(int, clipShadows) /* 1: removed matter is hidden from the eye, but casts shadow */                \
    FIELD(int, greyFaces)   /* 1: clip faces show grey values; 2: and are black, not clear, below the       \
                               window */                                                                    \
    FIELD(float, greyLow)   /* table entry that is black there */                                           \
    FIELD(float, greyHigh)  /* table entry that is white there */                                           \
    FIELD(float, exposure)  /* of the display: grey faces are divided by it */                              \
    FIELD(int, keepsHue)    /* the tone map of the display, as in DisplayPush */                            \
    /* The fovea, stored larger: see shaders/lib/fovea.glsl; magnification 1: none. */                      \
    FIELD(vec2, planeHalfSize)                                                                              \
    FIELD(vec2, gaze)                                                                                       \
    FIELD(float, foveaRadius)                                                                               \
    FIELD(float, foveaMagnification)                                                                        \
    FIELD(float, parallelMm) /* above 0: rays are parallel, and the picture shows as much as that of an eye \
                                at this distance */                                                         \
    FIELD(float, lensRadiusMm)  /* 0: all is sharp */                                                       \
    FIELD(float, lensFocusMm)   /* along the view, from the eye to the plane in focus */                    \
    FIELD(float, lightStrength) /* multiplies the environment's light */                                    \
    /* The cache of indirect light, see shaders/lib/indirect.glsl. */                                       \
    FIELD(vec3, indirectCellsPerVoxel) /* of the smallest cells */                                          \
    FIELD(float, indirectWidth) /* of a cell, in smallest cells: everywhere in a parallel view, else at a   \
                                   distance of one smallest cell */                                         \
    FIELD(float, indirectUnit)  /* radiance of one unit of its sums */                                      \
    FIELD(float, indirectLeast) /* least probability that a path continues where the cache is a control     \
                                   variate; 0: the cache's light is final */                                \
    FIELD(int, indirectStride)  /* one in so many rows and columns of pixels records its light */           \
    /* Gradient opacity, see shaders/lib/gradient.glsl. */                                                  \
    FIELD(float, gradientScale) /* steps of its table per (entry per mm) */                                 \
    FIELD(int, gradientLast)    /* index of its last step; 0: none */                                       \
    FIELD(float, unitDepthMm)   /* unit distance of the opacities, divided by the density */                \
    /* Curves of steep matter, see shaders/lib/gradient.glsl. */                                            \
    FIELD(float, steepGradient) /* entries per mm at which half of the matter is steep */                   \
    FIELD(int, steepFirst)      /* where its extinctions begin in the table of extinctions */               \
    /* Ray casting, see shaders/lib/cast.glsl. */                                                           \
    FIELD(int, entryCount)      /* of the tables */                                                         \
    FIELD(float, windowLow)     /* entry that is black */                                                   \
    FIELD(float, windowHigh)    /* entry that is white */                                                   \
    FIELD(float, paddingEntry)  /* entry of padding; -1: there is none */                                   \
    FIELD(float, stepsPerEntry) /* integration steps for a change of the value by one entry */              \
    FIELD(float, ambient)       /* coefficients of the headlight */                                         \
    FIELD(float, diffuse)                                                                                   \
    /* The second volume and segments, see shaders/lib/mixture.glsl. */                                     \
    FIELD(vec3, secondOrigin)     /* origin of voxel coordinates, in those of the second volume */          \
    FIELD(vec3, secondFromVoxelX) /* columns: its voxels per voxel */                                       \
    FIELD(vec3, secondFromVoxelY)                                                                           \
    FIELD(vec3, secondFromVoxelZ)                                                                           \
    FIELD(ivec3, secondSize) /* voxels */                                                                   \
    FIELD(ivec3, secondGrid) /* bricks */                                                                   \
    FIELD(int,                                                                                              \
          secondEntryCount) /* of its table; the colours of segments come after it, from the first on */    \
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

// So many successive samples of a pixel, the first with an index that is a multiple of this number, form a
// net: their mean is less noisy than that of independent samples (shaders/lib/net.glsl). A power of two.
MACULA_SHARED_CONST uint kNetSamples = 4u;

// The work of one work group in a dispatch, see src/pipeline/trace/sampling_plan.h. Blocks are numbered row
// by row.
struct PlannedBlock {
    uint block;
    uint firstSample;  // index of its first sample, for the random sequence
    uint sampleCount;
};

// The samples of a dispatch of path_side.comp, which traces them side by side.
struct SidePush {
    uint blockCount;   // of the plan
    uint mostSamples;  // of any block
};

// How noisy a block is as displayed, see shaders/lib/noise.glsl.
struct BlockNoise {
    float squaredError;  // mean over its pixels
    uint isSeen;         // 1: some of its samples met matter or light
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
    vec3 background;  // linear light, neither exposed nor tone-mapped
    float exposure;
    int smoothing;  // radius in pixels of the binomial filter over the means
    int denoised;   // 1: the sums are means, and counts are ignored
    int keepsHue;   // 1: toneMapHue, else toneMapNeutral (shaders/lib/picture.glsl)
};

MACULA_SHARED_END
#endif
