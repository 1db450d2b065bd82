// Noise out of a traced picture, without light being lost: what shaders/lib/denoise.glsl says, on the device.
//
// In space an a-trous filter (Dammertz et al. 2010), over time a mean along the motion (Schied et al. 2017),
// both steered by variance and by the guides. Light and coverage each keep their sum over the picture, but
// for what is clamped to 0 to 1 of alpha. The noisier a pixel, the farther the filter reaches; as samples
// come in it goes over into the plain mean. What stands out alone is limited to its neighbours, as far as its
// noise explains it; before the filter, too, what is many times as bright, as the filter would keep it apart.
// Neither is for Denoising::little, since of many pictures noise averages out and a limit does not.
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

    // The most samples that the history of earlier views counts for: more would blur what is resampled from
    // view to view.
    static constexpr float kHistorySamples = 32.0f;

    // Filters a picture; true when it is finished. `pixelAngle` is the width of a stored pixel at distance 1;
    // `fovea` says where a foveated pixel shows less than that. `before` are the guides of the previous view,
    // those of the run that advance() kept, or null. All pictures have one size; `how` is not off.
    // `keepGoing` is asked between dispatches of some 40 ms, each of which is waited for; after a no the next
    // run of the same picture continues, unless giveUp() came first. An empty `keepGoing` waits for nothing.
    Result<bool> run(const Film& film, const Guides& now, const Guides* before, float pixelAngle,
                     Denoising how, const std::function<bool()>& keepGoing = {},
                     const FoveaInPlane& fovea = {}, float historySamples = kHistorySamples);
    // Drops a run that was begun and not finished.
    void giveUp() { stage_ = row_ = 0; }

    // Makes what the last run gathered the history of the next view. When nothing ran since, the history is
    // empty.
    void advance();
    // Drops the history: the next picture shows other matter, other light, or is seen from elsewhere
    // altogether.
    void forget();
    bool remembers() const { return remembers_; }

    // vec4 for each pixel: linear premultiplied radiance and alpha, row 0 on top; of the last run.
    const gpu::Buffer& result() const { return result_; }
    // Of that: see shaders/lib/denoise_variance.glsl. float for each pixel, valid until the next call. `now`
    // as for that run. outOfMemory.
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
    std::array<Record, 2> records_;  // of this view and of the one before, which is which changes
    std::size_t current_ = 0;
    bool ran_ = false;
    bool doubts_ = true;  // that run: see DenoisePush
    int stage_ = 0;       // of the run under way: gather, prepare, specks, passes of the filter, specks
    int row_ = 0;         // the first row of that stage that is not done
    bool remembers_ = false;
    gpu::TexelBuffer masses_;
    std::array<gpu::TexelBuffer, 2> noises_;
    std::array<gpu::TexelBuffer, 2> colours_;
    gpu::Buffer result_;
    std::optional<gpu::Buffer> variances_;  // where somebody asked for them
};

}  // namespace macula::trace
