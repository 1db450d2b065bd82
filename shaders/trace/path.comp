// Adds light paths, as samples, to the pixels of some blocks of the picture.
#version 460
#extension GL_GOOGLE_include_directive : require

#define INDIRECT_BINDING 22
#include "trace/host.glsl"

#define EXTEND_SAMPLE(path, rng) extendPath(path, rng)
#define TELL_SAMPLE(path, sampleIndex)
#define TELL_PIXEL(pixelIndex)
#include "trace/path_samples.glsl"
