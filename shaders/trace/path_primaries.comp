// Adds the same samples to a picture as path.comp, and keeps where each met matter, and the light that left
// there towards the eye. Not for parallel views, which never need it: src/pipeline/hybrid/light/lit_view.cpp.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#define INDIRECT_BINDING 22
#include "trace/host.glsl"
#include "shared/primary_vertex.h"

layout(binding = 25, scalar) writeonly buffer Primaries {
    PrimaryVertex primaries[];  // a picture for each of kPrimarySamples samples; cleared before, so that
                                // unwritten ones are 0
};

vec3 metMm;  // where the current sample met matter, relative to the eye

// The primary vertices of complete samples, written after the loop: with a store inside it lavapipe takes two
// fifths longer.
PrimaryVertex found[kPrimarySamples];
uint isFound = 0u;  // a bit for each

// As extendPath, but keeps the primary vertex.
bool extendSample(inout Path path, inout Rng rng) {
    if (!follow(path, rng)) return true;
    bool isFirst = path.vertices == 0 && !path.shadow;
    // A ray that met no matter may have met a clip face, at the end of its walk.
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
