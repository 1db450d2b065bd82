// Adds the same samples to a picture as path.comp, and tells where each has met matter, and what light left
// there towards the eye. Of parallel views nobody asks for them: src/pipeline/hybrid/light/lit_view.cpp.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#define INDIRECT_BINDING 22
#include "trace/host.glsl"
#include "shared/primary_vertex.h"

layout(binding = 25, scalar) writeonly buffer Primaries {
    PrimaryVertex primaries[];  // of kPrimarySamples samples, picture after picture; what is not written was
                                // cleared before
};

vec3 metMm;  // where the sample under way met matter, from the eye

// The primary vertices of complete samples. They are written when all samples are complete: with a store
// inside the loop lavapipe takes two fifths longer.
PrimaryVertex found[kPrimarySamples];
uint isFound = 0u;  // a bit for each

// As extendPath.
bool extendSample(inout Path path, inout Rng rng) {
    if (!follow(path, rng)) return true;
    bool isFirst = path.vertices == 0 && !path.shadow;
    // Where nothing has stopped it there may be a face of a clip, where the walk ends.
    float wayMm = path.transmittance > 0.0 ? path.walk.endMm : path.walk.distanceMm;
    metMm = isFirst ? path.direction * wayMm : metMm;
    return decide(path, rng);
}

void tellSample(Path path, uint sampleIndex) {
    uint place = sampleIndex % kPrimarySamples;
    vec3 fromEyeMm = path.coverage > 0.0 ? metMm : vec3(0.0);
    [[unroll]] for (uint k = 0u; k < kPrimarySamples; ++k) {
        found[k].fromEyeMm = k == place ? fromEyeMm : found[k].fromEyeMm;
        found[k].radiance = k == place ? lightOf(path) : found[k].radiance;
    }
    isFound |= 1u << place;
}

void tellPixel(int pixelIndex) {
    uint pixels = uint(params.imageSize.x * params.imageSize.y);
    [[unroll]] for (uint k = 0u; k < kPrimarySamples; ++k) {
        if ((isFound >> k & 1u) != 0u) primaries[k * pixels + uint(pixelIndex)] = found[k];
    }
}

#define EXTEND_SAMPLE(path, rng) extendSample(path, rng)
#define TELL_SAMPLE(path, sampleIndex) tellSample(path, sampleIndex)
#define TELL_PIXEL(pixelIndex) tellPixel(pixelIndex)
#include "trace/path_samples.glsl"
