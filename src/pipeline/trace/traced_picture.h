// What PathTracer gives of a picture.
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
    std::uint64_t samplesPerPixel = 0;  // the least that any pixel has: traceFor() gives some more
    double meanSamplesPerPixel = 0.0;   // what they have on average
    // Standard error of what is shown, display-encoded, 0 to 1, RMS over the parts of the picture that show
    // something; as of the last pass of traceFor() or estimateError(). +infinity before.
    double estimatedError = std::numeric_limits<double>::infinity();
    bool converged = false;              // it is below Settings::errorThreshold, and nowhere far above
    std::uint64_t nonFiniteSamples = 0;  // dropped from the picture, never hidden
    std::uint64_t abandonedSamples = 0;  // likewise: paths too long for the device
    // Collisions in matter that was denser than the bound that its brick was said to have: light passed where
    // it should not. There are none; one is a fault of Macula.
    std::uint64_t collisionsAboveBound = 0;
    bool denoised = false;         // whether display() and readback() give a filtered picture
    double deviceMs = 0.0;         // spent tracing since the last change
    std::uint32_t dispatches = 0;  // of samples, since then
    VoxelMemory voxels;
    std::vector<Message> messages;  // what a person has to know about what is shown
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
    std::vector<std::uint32_t> samples;  // of each pixel, finite ones
    bool denoised = false;               // then `radiance` is filtered, and may use what earlier views knew
};

// The picture so far, where it lies on the device: linear, premultiplied, row 0 on top.
struct TracedLight {
    const gpu::Buffer* values = nullptr;  // vec4 for each pixel: the mean, or the sum of its samples
    const gpu::Buffer* counts = nullptr;  // uint for each pixel: samples
    bool areMeans = false;                // then it is denoised, and counts do not count
    // Of noisyLight() alone: float for each pixel, the mean square error of the luminance (Rec. 709) of the
    // mean, as far as its samples tell; very large where there are none (shaders/lib/variance.glsl, of a
    // filtered picture denoise_variance.glsl).
    const gpu::Buffer* variances = nullptr;
};

// For previews of few samples that are not denoised: a binomial filter over the means of neighbouring pixels,
// before the tone map. It trades sharpness for noise and is never part of readback().
enum class Smoothing { none = 0, slight = 1, strong = 2 };  // radius in pixels

}  // namespace macula::trace
