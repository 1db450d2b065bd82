// Adds the same samples to a picture as path.comp, and tells where each has met matter, and what light left there towards the
// eye.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"
#include "shared/primary_vertex.h"

layout(binding = 15, scalar) writeonly buffer Primaries {
    PrimaryVertex primaries[];  // of kPrimarySamples samples, picture after picture; what is not written was cleared before
};

vec3 metMm;  // by the sample under way, from the eye

bool extendSample(inout Path path, inout Rng rng) {
    bool flew = path.vertices == 0 && !path.shadow;
    bool goesOn = extendPath(path, rng);
    if (flew && path.shadow) {
        metMm = inverse(mat3(params.voxelFromWorldX, params.voxelFromWorldY, params.voxelFromWorldZ)) *
                (path.origin - params.originVoxel);
    } else if (flew && !goesOn) {
        metMm = path.direction * path.walk.endMm;  // counts where a face of a clip is there
    }
    return goesOn;
}

void tellSample(Path path, uint sampleIndex, int pixelIndex) {
    uint pixels = uint(params.imageSize.x * params.imageSize.y);
    bool met = path.coverage > 0.0;
    primaries[sampleIndex % kPrimarySamples * pixels + uint(pixelIndex)] = PrimaryVertex(met ? metMm : vec3(0.0), path.radiance);
}

#define EXTEND_SAMPLE(path, rng) extendSample(path, rng)
#define TELL_SAMPLE(path, sampleIndex, pixelIndex) tellSample(path, sampleIndex, pixelIndex)
#include "trace/path_samples.glsl"
