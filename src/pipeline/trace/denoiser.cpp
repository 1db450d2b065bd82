#include "pipeline/trace/denoiser.h"

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/trace/portions.h"
#include "shaders/trace.h"
#include "shared/denoise_params.h"

namespace macula::trace {

namespace {

// Strides of the passes. Two sweeps: where edges leave a pixel few neighbours, its own noise dominates after
// the first sweep, and the second spreads it.
constexpr std::array kStrides{1, 2, 4, 8, 16, 1, 2, 4, 8};
constexpr int kFirstSweep = 5;  // strides in the first sweep

// Gather, prepare, specks, the passes of the filter, specks; Denoising::little skips both stages of specks.
struct Stages {
    explicit Stages(Denoising how)
        : takesSpecks(how != Denoising::little),
          passes(takesSpecks ? static_cast<int>(kStrides.size()) : kFirstSweep),
          firstPass(takesSpecks ? 3 : 2),
          count(firstPass + passes + (takesSpecks ? 1 : 0)) {}

    bool takesSpecks;
    int passes;
    int firstPass;
    int count;
};

// The buffer of two in which the filter leaves the noise, after one sweep or both.
constexpr std::size_t kNoiseIsIn = 1;
static_assert(kFirstSweep % 2 == kNoiseIsIn && kStrides.size() % 2 == kNoiseIsIn);

Result<gpu::TexelBuffer> makeTexels(const std::shared_ptr<gpu::Device>& device, const char* label,
                                    std::uint64_t pixels, VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT) {
    return gpu::TexelBuffer::create(
        device, {.label = label,
                 .elements = pixels,
                 .format = format,
                 .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
}

// Push constants of the first pass from the first row.
shared::DenoisePush pushOf(const glm::ivec2& sizePx, float pixelAngle, float historySamples,
                           const FoveaInPlane& fovea, bool doubts) {
    return {.imageSize = sizePx,
            .stride = 1,
            .last = 0,
            .pixelAngle = pixelAngle,
            .historySamples = historySamples,
            .firstRow = 0,
            .planeHalfSize = fovea.halfSize,
            .gaze = fovea.gaze,
            .foveaRadius = static_cast<float>(fovea.radius),
            .foveaMagnification = static_cast<float>(fovea.magnification),
            .parallelMm = static_cast<float>(fovea.parallelMm),
            .doubts = doubts ? 1 : 0};
}

}  // namespace

Result<std::shared_ptr<const DenoiseKernels>> DenoiseKernels::create(
    const std::shared_ptr<gpu::Device>& device) {
    MACULA_TRY(gpu::Kernel gather, gpu::Kernel::create(device, shaders::denoise_gather_comp));
    MACULA_TRY(gpu::Kernel prepare, gpu::Kernel::create(device, shaders::denoise_prepare_comp));
    MACULA_TRY(gpu::Kernel filter, gpu::Kernel::create(device, shaders::denoise_filter_comp));
    MACULA_TRY(gpu::Kernel specks, gpu::Kernel::create(device, shaders::denoise_specks_comp));
    return std::make_shared<const DenoiseKernels>(
        DenoiseKernels{std::move(gather), std::move(prepare), std::move(filter), std::move(specks)});
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

Result<bool> Denoiser::run(const Film& film, const Guides& now, const Guides* before, float pixelAngle,
                           Denoising how, const std::function<bool()>& keepGoing, const FoveaInPlane& fovea,
                           float historySamples) {
    MACULA_CHECK(how != Denoising::off);
    MACULA_CHECK(film.width() == width_ && film.height() == height_);
    MACULA_CHECK(now.width() == width_ && now.height() == height_);
    const bool history = remembers_ && before != nullptr;
    const Guides& old = history ? *before : now;  // never read without a history
    const Record& record = records_[current_];
    const Record& memory = records_[1 - current_];
    const Stages stages(how);
    const std::shared_ptr<gpu::Device>& device = result_.device();
    const FilterPortion portion =
        filterPortion(device->isCpu(), static_cast<bool>(keepGoing), width_, height_);
    const shared::DenoisePush firstPush =
        pushOf({width_, height_}, pixelAngle, history ? historySamples : 0.0f, fovea, stages.takesSpecks);

    const auto recordSome = [&](gpu::Recorder& recorder) {
        const int rows = std::min(portion.rowsAtOnce, height_ - row_);
        const gpu::Threads threads{static_cast<std::uint32_t>(width_), static_cast<std::uint32_t>(rows)};
        shared::DenoisePush push = firstPush;
        push.firstRow = row_;
        if (stage_ == 0) {
            recorder.dispatch(kernels_->gather, threads, push,
                              {film.sums(), film.counts(), film.squares(), now.surfaces(), now.matters(),
                               now.motions(), memory.means, memory.moments, old.surfaces(), old.matters(),
                               record.means.buffer(), record.moments.buffer()});
        } else if (stage_ == 1) {
            recorder.dispatch(kernels_->prepare, threads, push,
                              {record.means, record.moments, now.surfaces(), now.matters(), now.motions(),
                               masses_.buffer(), noises_[0].buffer()});
        } else if (stage_ < stages.firstPass) {
            push.stride = 0;
            recorder.dispatch(
                kernels_->specks, threads, push,
                {record.means, noises_[0], masses_, now.surfaces(), record.moments, colours_[0].buffer()});
        } else if (stage_ < stages.firstPass + stages.passes) {
            const auto pass = static_cast<std::size_t>(stage_ - stages.firstPass);
            const std::size_t from = pass % 2;
            push.stride = kStrides.at(pass);
            push.last = stage_ + 1 == stages.firstPass + stages.passes ? 1 : 0;
            recorder.dispatch(
                kernels_->filter, threads, push,
                {pass == 0 && !stages.takesSpecks ? record.means : colours_[from], noises_[from], masses_,
                 now.surfaces(), stage_ + 1 == stages.count ? result_ : colours_[1 - from].buffer(),
                 noises_[1 - from].buffer()});
        } else {
            recorder.dispatch(kernels_->specks, threads, push,
                              {colours_[kNoiseIsIn], noises_[kNoiseIsIn], masses_, now.surfaces(),
                               record.moments, result_});
        }
        row_ += rows;
        if (row_ < height_) return;
        row_ = 0;
        ++stage_;
    };

    doubts_ = stages.takesSpecks;
    if (stage_ == 0 && row_ == 0) ran_ = false;
    for (bool goesOn = true; stage_ < stages.count && goesOn;) {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device, "denoise"));
        std::int64_t pixels = 0;  // summed over stages: the largest pictures exceed an int
        do {
            pixels += std::int64_t(std::min(portion.rowsAtOnce, height_ - row_)) * width_;
            recordSome(recorder);
        } while (stage_ < stages.count && pixels < portion.enoughPixels);
        const Result<gpu::Ticket> ticket = recorder.submit();
        if (!ticket) {
            giveUp();
            return ticket.error();
        }
        if (!keepGoing) continue;
        MACULA_TRY([[maybe_unused]] const bool done, device->waitFor(*ticket));
        goesOn = keepGoing();
    }
    if (stage_ < stages.count) return false;
    giveUp();
    ran_ = true;
    return true;
}

Result<const gpu::Buffer*> Denoiser::variances(const Guides& now) {
    const std::shared_ptr<gpu::Device>& device = result_.device();
    const std::uint64_t pixels = std::uint64_t(width_) * std::uint64_t(height_);
    if (!variances_) {
        MACULA_TRY(variances_, gpu::Buffer::create(device, {.label = "variances of filtered light",
                                                            .bytes = pixels * sizeof(float)}));
    }
    // Cheap: the device caches compiled kernels.
    MACULA_TRY(const gpu::Kernel kernel, gpu::Kernel::create(device, shaders::denoise_variance_comp));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "variances"));
    recorder.dispatch(kernel, {static_cast<std::uint32_t>(width_), static_cast<std::uint32_t>(height_)},
                      pushOf({width_, height_}, 0.0f, 0.0f, {}, doubts_),
                      {noises_[kNoiseIsIn], masses_, records_[current_].means, records_[current_].moments,
                       now.surfaces(), now.matters(), now.motions(), *variances_});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &*variances_;
}

void Denoiser::advance() {
    giveUp();
    remembers_ = ran_;
    if (ran_) current_ = 1 - current_;
    ran_ = false;
}

void Denoiser::forget() {
    giveUp();
    ran_ = false;
    remembers_ = false;
}

}  // namespace macula::trace
