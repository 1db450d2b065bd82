#include "pipeline/trace/noise_map.h"

#include <algorithm>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/trace.h"

namespace macula::trace {

namespace {

// Blocks of one dispatch on a CPU device, where a block takes a few microseconds: short enough for a cancel.
constexpr std::uint32_t kBlocksPerDispatchCpu = 1 << 12;
// A work group has eight blocks: within 65535 groups, the most that some graphics cards allow.
constexpr std::uint32_t kBlocksPerDispatchGpu = 1 << 18;

// 18 % grey: a backdrop that may lie behind a picture with an alpha channel.
constexpr float kBackdrop = 0.18f;

}  // namespace

Result<NoiseMap> NoiseMap::create(const std::shared_ptr<gpu::Device>& device, int width, int height) {
    constexpr int kEdge = shared::kBlockEdge;
    const auto blocks = static_cast<std::uint32_t>((width + kEdge - 1) / kEdge) *
                        static_cast<std::uint32_t>((height + kEdge - 1) / kEdge);
    MACULA_TRY(gpu::Kernel kernel, gpu::Kernel::create(device, shaders::trace_noise_comp));
    MACULA_TRY(gpu::Buffer noises,
               gpu::Buffer::create(device, {.label = "noise of blocks",
                                            .bytes = std::uint64_t(blocks) * sizeof(shared::BlockNoise)}));
    return NoiseMap(width, height, blocks, std::move(kernel), std::move(noises));
}

Result<void> NoiseMap::measureSome(const Film& film, const Settings& settings) {
    MACULA_CHECK_EQ(film.width(), width_);
    MACULA_CHECK_EQ(film.height(), height_);
    const auto& device = noises_.device();
    std::uint32_t count = blocks_ - measured_;
    count = std::min(count, device->isCpu() ? kBlocksPerDispatchCpu : kBlocksPerDispatchGpu);
    // Only light paths have a random coverage of 0 or 1, whose noise shows against a backdrop.
    const shared::NoisePush push{.imageSize = {width_, height_},
                                 .firstBlock = measured_,
                                 .exposure = static_cast<float>(settings.exposure),
                                 .backdrop = isPathTraced(settings.look) ? kBackdrop : 0.0f,
                                 .keepsHue = settings.toneMap == ToneMap::hue ? 1 : 0};
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "noise"));
    recorder.dispatch(kernel_, {count}, push, {film.sums(), film.counts(), film.squares(), noises_});
    MACULA_TRY(const gpu::Ticket ticket, recorder.submit());
    MACULA_TRY([[maybe_unused]] const bool done, device->waitFor(ticket));
    measured_ += count;
    return {};
}

Result<std::vector<shared::BlockNoise>> NoiseMap::read() const {
    MACULA_CHECK(isWhole());
    return gpu::read<shared::BlockNoise>(noises_);
}

}  // namespace macula::trace
