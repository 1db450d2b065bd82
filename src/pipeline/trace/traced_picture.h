// What PathTracer returns about a picture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "base/message.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/voxel_memory.h"

namespace macula::trace {

struct Statistics {
    std::uint64_t samplesPerPixel = 0;  // the fewest of any pixel: traceFor() gives some pixels more
    double meanSamplesPerPixel = 0.0;   // over all pixels
    // Standard error of the picture as displayed, display-encoded, 0 to 1: RMS over the blocks that show
    // something, from the last pass of traceFor() or from estimateError(). +infinity before.
    double estimatedError = std::numeric_limits<double>::infinity();
    bool converged = false;  // estimatedError is at most Settings::errorThreshold, and no part is far above
    std::uint64_t nonFiniteSamples = 0;  // dropped from the picture, never hidden
    std::uint64_t abandonedSamples = 0;  // likewise dropped: paths too long for the device
    // Collisions in matter denser than its brick's majorant, through which too much light passed. Always 0
    // unless Macula has a bug.
    std::uint64_t collisionsAboveBound = 0;
    bool denoised = false;         // whether display() and readback() give a filtered picture
    double deviceMs = 0.0;         // spent tracing since the last change
    std::uint32_t dispatches = 0;  // of samples, since the last change
    VoxelMemory voxels;
    std::vector<Message> messages;  // what a person has to know about the picture
};

// Row 0 on top. Linear, premultiplied; depth is the distance in mm from the camera to the point where
// transmittance falls to one half, +infinity where it does not, and everywhere for
// projections, which show no surface.
struct TracedImage {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> radiance;
    std::vector<float> depthMm;
    // The variance of the mean over the samples of this view, before any denoising: of its luminance (Rec.
    // 709) and of its coverage; +infinity for fewer than two samples.
    std::vector<glm::vec2> variance;
    std::vector<std::uint32_t> samples;  // finite samples of each pixel
    bool denoised = false;               // `radiance` is filtered, perhaps with samples of earlier views
};

// The picture so far, where it lies on the device: linear, premultiplied, row 0 on top.
struct TracedLight {
    const gpu::Buffer* values = nullptr;  // vec4 for each pixel: the mean, or the sum of its samples
    const gpu::Buffer* counts = nullptr;  // uint for each pixel: samples
    bool areMeans = false;                // the picture is denoised: ignore `counts`
    // From noisyLight() only: float for each pixel, the mean square error of its luminance (Rec. 709),
    // estimated from its samples; very large where there are none (shaders/lib/variance.glsl, or
    // denoise_variance.glsl for a filtered picture).
    const gpu::Buffer* variances = nullptr;
};

// For previews of few samples that are not denoised: a binomial filter over the means of neighbouring pixels,
// before the tone map. It trades sharpness for noise and is never part of readback().
enum class Smoothing { none = 0, slight = 1, strong = 2 };  // radius in pixels

}  // namespace macula::trace
