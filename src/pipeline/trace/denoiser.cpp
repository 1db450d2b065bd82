#include "pipeline/trace/denoiser.h"

#include <glm/glm.hpp>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "shaders/trace.h"
#include "shared/denoise_params.h"

namespace macula::trace {

namespace {

// Strides of the passes. Two sweeps: where edges left a pixel few neighbours, its own noise weighs most after
// the first, and the second spreads that.
constexpr std::array kStrides{1, 2, 4, 8, 16, 1, 2, 4, 8};
constexpr std::size_t kFirstSweep = 5;  // of these
// What the view before may count for: more would blur what is resampled from view to view.
constexpr float kHistorySamples = 32.0f;

Result<gpu::TexelBuffer> makeTexels(const std::shared_ptr<gpu::Device>& device, const char* label,
                                    std::uint64_t pixels, VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT) {
    return gpu::TexelBuffer::create(
        device, {.label = label,
                 .elements = pixels,
                 .format = format,
                 .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
}

}  // namespace

Result<std::shared_ptr<const DenoiseKernels>> DenoiseKernels::create(
    const std::shared_ptr<gpu::Device>& device) {
    MACULA_TRY(gpu::Kernel gather, gpu::Kernel::create(device, shaders::denoise_gather_comp));
    MACULA_TRY(gpu::Kernel prepare, gpu::Kernel::create(device, shaders::denoise_prepare_comp));
    MACULA_TRY(gpu::Kernel filter, gpu::Kernel::create(device, shaders::denoise_filter_comp));
    return std::make_shared<const DenoiseKernels>(
        DenoiseKernels{std::move(gather), std::move(prepare), std::move(filter)});
}

Denoiser::Denoiser(int width, int height, std::shared_ptr<const DenoiseKernels> kernels,
                   std::array<Record, 2> records, gpu::TexelBuffer masses,
                   std::array<gpu::TexelBuffer, 2> noises, std::array<gpu::TexelBuffer, 2> colours,
                   gpu::Buffer result)
    : width_(width),
      height_(height),
      kernels_(std::move(kernels)),
      records_(std::move(records)),
      masses_(std::move(masses)),
      noises_(std::move(noises)),
      colours_(std::move(colours)),
      result_(std::move(result)) {}

Result<Denoiser> Denoiser::create(const std::shared_ptr<gpu::Device>& device,
                                  std::shared_ptr<const DenoiseKernels> kernels, int width, int height) {
    const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
    const auto makeRecord = [&]() -> Result<Record> {
        MACULA_TRY(gpu::TexelBuffer means, makeTexels(device, "means", pixels));
        MACULA_TRY(gpu::TexelBuffer moments, makeTexels(device, "moments", pixels, VK_FORMAT_R32G32_SFLOAT));
        return Record{std::move(means), std::move(moments)};
    };
    MACULA_TRY(Record first, makeRecord());
    MACULA_TRY(Record second, makeRecord());
    MACULA_TRY(gpu::TexelBuffer masses, makeTexels(device, "masses", pixels));
    MACULA_TRY(gpu::TexelBuffer noise0, makeTexels(device, "noise", pixels));
    MACULA_TRY(gpu::TexelBuffer noise1, makeTexels(device, "noise", pixels));
    MACULA_TRY(gpu::TexelBuffer colour0, makeTexels(device, "filtered", pixels));
    MACULA_TRY(gpu::TexelBuffer colour1, makeTexels(device, "filtered", pixels));
    MACULA_TRY(gpu::Buffer result,
               gpu::Buffer::create(device, {.label = "denoised", .bytes = pixels * sizeof(glm::vec4)}));
    return Denoiser(width, height, std::move(kernels), {std::move(first), std::move(second)},
                    std::move(masses), {std::move(noise0), std::move(noise1)},
                    {std::move(colour0), std::move(colour1)}, std::move(result));
}

Result<void> Denoiser::run(const Film& film, const Guides& now, const Guides* before, float pixelAngle,
                           Denoising how) {
    MACULA_CHECK(how != Denoising::off);
    MACULA_CHECK_EQ(film.width(), width_);
    MACULA_CHECK_EQ(film.height(), height_);
    MACULA_CHECK_EQ(now.width(), width_);
    MACULA_CHECK_EQ(now.height(), height_);
    const bool history = remembers_ && before != nullptr;
    const Guides& old = history ? *before : now;  // never read without a history
    const Record& record = records_[current_];
    const Record& memory = records_[1 - current_];
    const gpu::Threads threads{static_cast<std::uint32_t>(width_), static_cast<std::uint32_t>(height_)};
    shared::DenoisePush push{.imageSize = {width_, height_},
                             .stride = 1,
                             .last = 0,
                             .pixelAngle = pixelAngle,
                             .historySamples = history ? kHistorySamples : 0.0f};

    MACULA_TRY(auto recorder, gpu::Recorder::create(result_.device(), "denoise"));
    recorder.dispatch(kernels_->gather, threads, push,
                      {film.sums(), film.counts(), film.squares(), now.surfaces(), now.matters(),
                       now.motions(), memory.means, memory.moments, old.surfaces(), old.matters(),
                       record.means.buffer(), record.moments.buffer()});
    recorder.dispatch(kernels_->prepare, threads, push,
                      {record.means, record.moments, now.surfaces(), now.matters(), now.motions(),
                       masses_.buffer(), noises_[0].buffer()});
    const std::size_t passes = how == Denoising::little ? kFirstSweep : kStrides.size();
    for (std::size_t pass = 0; pass < passes; ++pass) {
        const std::size_t from = pass % 2;
        push.stride = kStrides[pass];
        push.last = pass + 1 == passes ? 1 : 0;
        recorder.dispatch(
            kernels_->filter, threads, push,
            {pass == 0 ? record.means : colours_[from], noises_[from], masses_, now.surfaces(),
             push.last == 1 ? result_ : colours_[1 - from].buffer(), noises_[1 - from].buffer()});
    }
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    ran_ = true;
    return {};
}

void Denoiser::advance() {
    remembers_ = ran_;
    if (ran_) current_ = 1 - current_;
    ran_ = false;
}

void Denoiser::forget() {
    ran_ = false;
    remembers_ = false;
}

}  // namespace macula::trace
