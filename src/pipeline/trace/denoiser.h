// Takes noise out of a traced picture without losing light: shaders/lib/denoise.glsl on the device.
//
// In space an a-trous filter (Dammertz et al. 2010), over time a mean along the motion (Schied et al. 2017),
// both steered by variance and by the guides. Light and coverage each keep their sum over the picture, except
// where alpha is clamped to 0 to 1. The noisier a pixel, the farther the filter reaches; as samples come in,
// its result approaches the plain mean. A single pixel that stands out, by no more than its noise explains,
// is limited to its neighbours; if it is many times as bright, before the filter too, which would not mix it
// with them. Denoising::little has no such limits: over many pictures noise averages out, and the bias of a
// limit does not.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/film.h"
#include "pipeline/trace/guides.h"
#include "pipeline/trace/scene.h"
#include "pipeline/trace/settings.h"

namespace macula::trace {

// The kernels, for pictures of any size.
struct DenoiseKernels {
    gpu::Kernel gather;
    gpu::Kernel prepare;
    gpu::Kernel filter;
    gpu::Kernel specks;

    static Result<std::shared_ptr<const DenoiseKernels>> create(const std::shared_ptr<gpu::Device>& device);
};

// A denoiser for one size of picture. Used by one thread at a time, the one that uses the device.
class Denoiser {
  public:
    // outOfMemory when the device cannot hold 136 bytes for each pixel.
    static Result<Denoiser> create(const std::shared_ptr<gpu::Device>& device,
                                   std::shared_ptr<const DenoiseKernels> kernels, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    // The history of earlier views counts as at most so many samples: more would blur, because it is
    // resampled from view to view.
    static constexpr float kHistorySamples = 32.0f;

    // Filters a picture; true when it is finished. `pixelAngle` is the width of a stored pixel at distance 1;
    // `fovea` says where a foveated pixel shows less than that. `before` are the guides of the previous view,
    // of the run that advance() kept, or null. All pictures have one size; `how` is not off. Calls
    // `keepGoing` between dispatches of some 40 ms, and waits for each; once it returns false, the next run
    // of the same picture continues there, unless giveUp() came first. With an empty `keepGoing` it waits for
    // nothing.
    Result<bool> run(const Film& film, const Guides& now, const Guides* before, float pixelAngle,
                     Denoising how, const std::function<bool()>& keepGoing = {},
                     const FoveaInPlane& fovea = {}, float historySamples = kHistorySamples);
    // Drops a run that was not finished.
    void giveUp() { stage_ = row_ = 0; }

    // Makes what the last run gathered the history of the next view. If no run has finished since the last
    // call, the history is empty.
    void advance();
    // Drops the history: the next picture shows other matter or other light, or comes from a quite different
    // view.
    void forget();
    bool remembers() const { return remembers_; }

    // The picture of the last run. vec4 for each pixel: linear premultiplied radiance and alpha, row 0 on
    // top.
    const gpu::Buffer& result() const { return result_; }
    // How noisy result() still is (shaders/lib/denoise_variance.glsl): float for each pixel, valid until the
    // next call. `now` as in the last run. outOfMemory.
    Result<const gpu::Buffer*> variances(const Guides& now);

  private:
    struct Record {
        gpu::TexelBuffer means;    // vec4: premultiplied radiance and coverage
        gpu::TexelBuffer moments;  // vec2: mean square of luminance, samples
    };
    Denoiser(int width, int height, std::shared_ptr<const DenoiseKernels> kernels,
             std::array<Record, 2> records, gpu::TexelBuffer masses, std::array<gpu::TexelBuffer, 2> noises,
             std::array<gpu::TexelBuffer, 2> colours, gpu::Buffer result);

    int width_;
    int height_;
    std::shared_ptr<const DenoiseKernels> kernels_;
    std::array<Record, 2> records_;  // of this view, at current_, and of the one before
    std::size_t current_ = 0;
    bool ran_ = false;
    bool doubts_ = true;  // of the last run: see DenoisePush
    int stage_ = 0;       // next stage of the run: gather, prepare, specks, filter passes, specks
    int row_ = 0;         // first row of that stage that is still to do
    bool remembers_ = false;
    gpu::TexelBuffer masses_;
    std::array<gpu::TexelBuffer, 2> noises_;
    std::array<gpu::TexelBuffer, 2> colours_;
    gpu::Buffer result_;
    std::optional<gpu::Buffer> variances_;  // made on the first call of variances()
};

}  // namespace macula::trace
