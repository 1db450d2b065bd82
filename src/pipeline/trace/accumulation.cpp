#include "pipeline/trace/accumulation.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "base/parallel.h"
#include "pipeline/gpu/transfer.h"

namespace macula::trace {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kMaxBlocks = 65535;  // of one dispatch: what every device allows
constexpr std::uint32_t kMinBlocksCpu = 4;   // of one dispatch, so that no thread of a CPU device is idle

// The same; a thread of a native kernel has 32 pixels under way, half a block.
std::uint32_t leastBlocks(const gpu::Device& device) {
    if (!device.isCpu()) return 1;
    if (!device.runsNatively()) return kMinBlocksCpu;
    return std::max(kMinBlocksCpu, static_cast<std::uint32_t>((coreCount() + 1) / 2));
}

}  // namespace

Result<void> Accumulation::begin(int width, int height) {
    plan_ = SamplingPlan(width, height);
    estimate_.reset();
    deviceMs_ = 0.0;
    dispatches_ = 0;
    if (!film_ || film_->width() != width || film_->height() != height) {
        film_.reset();  // first, so that only one is ever on the device
        noiseMap_.reset();
        planned_.reset();
        traced_.reset();
        primaries_.reset();
        MACULA_TRY(film_, Film::create(device_, width, height));
    }
    if (!planned_) {
        const std::uint64_t most = std::min(plan_.blockCount(), kMaxBlocks);
        MACULA_TRY(planned_, gpu::Buffer::create(device_, {.label = "planned blocks",
                                                           .bytes = most * sizeof(shared::PlannedBlock),
                                                           .memory = gpu::MemoryKind::upload}));
    }
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "start accumulation"));
    film_->clear(recorder);
    if (primaries_) recorder.fill(*primaries_, 0);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    ++edition_;
    return {};
}

std::uint32_t Accumulation::mostSamples(const TraceVariant& variant, std::uint32_t perThread) const {
    return variant.isSideBySide ? sideBySide_.mostSamples(plan_.blockCount(), perThread) : perThread;
}

double Accumulation::passMs(const TraceVariant& variant, int bounces) const {
    const bool leavesIdle = plan_.blockCount() < sideBySide_.blocksAtOnce();
    return plan_.blockCount() /
           pace_.perMs({.variant = variant, .bounces = bounces, .leavesIdle = leavesIdle});
}

Result<void> Accumulation::makeRoomForTraced(std::uint64_t blockSamples) {
    if (!taken_) {
        MACULA_TRY(taken_,
                   gpu::Buffer::create(device_, {.label = "samples taken", .bytes = sizeof(std::uint32_t)}));
    }
    const std::uint64_t bytes = blockSamples * shared::kBlockEdge * shared::kBlockEdge * sizeof(glm::vec4);
    if (traced_ && traced_->bytes() >= bytes) return {};
    traced_.reset();
    MACULA_TRY(traced_, gpu::Buffer::create(device_, {.label = "traced samples", .bytes = bytes}));
    return {};
}

Result<void> Accumulation::record(gpu::Recorder& recorder, const SceneView& scene, TraceKernels& kernels,
                                  const gpu::Kernel& samples, const TraceVariant& variant,
                                  std::uint32_t blocks, std::uint32_t mostSamples) {
    std::vector<gpu::Binding> bindings = scene.bindings();
    const gpu::Threads pixels{blocks * shared::kBlockEdge, shared::kBlockEdge};
    if (variant.isSideBySide) {
        std::vector<gpu::Binding> toAdd{bindings.front()};
        film_->appendTo(toAdd);
        for (auto* const list : {&bindings, &toAdd}) {
            list->emplace_back(*planned_);
            list->emplace_back(*traced_);
        }
        bindings.emplace_back(film_->faultsBuffer());
        scene.scene().indirect().appendTo(bindings);
        bindings.emplace_back(*taken_);
        MACULA_TRY(const gpu::Kernel* add, kernels.addSamples());
        recorder.fill(*taken_, 0);
        recorder.dispatch(samples, {sideBySide_.threads(blocks, mostSamples)},
                          shared::SidePush{.blockCount = blocks, .mostSamples = mostSamples}, bindings);
        recorder.dispatch(*add, pixels, toAdd);
        return {};
    }
    film_->appendTo(bindings);
    bindings.emplace_back(*planned_);
    if (isPathTraced(variant.look)) scene.scene().indirect().appendTo(bindings);
    if (variant.tellsPrimaries) bindings.emplace_back(*primaries_);
    recorder.dispatch(samples, pixels, bindings);
    return {};
}

Result<void> Accumulation::step(const SceneView& scene, TraceKernels& kernels, const TraceVariant& variant,
                                int bounces, double ms) {
    Work work{.variant = variant, .bounces = bounces, .isAdaptive = plan_.isAdaptive()};
    // Side by side a block has up to hundreds of threads for each pixel, so that one block can fill a small
    // card.
    const std::uint32_t least = std::clamp(sideBySide_.leastBlocks(variant.isSideBySide, plan_.passMost()),
                                           leastBlocks(*device_), kMaxBlocks);
    const auto planned = plan_.next(pace_.perMs(work) * ms, least, kMaxBlocks);
    const auto blocks = static_cast<std::uint32_t>(planned.size());
    double samples = 0.0;
    std::uint32_t most = 0;  // samples of a block
    for (const shared::PlannedBlock& block : planned) {
        samples += block.sampleCount;
        most = std::max(most, block.sampleCount);
    }
    const std::uint32_t threads = variant.isSideBySide ? sideBySide_.threadsPerPixel(most) : 1;
    work.leavesIdle = std::uint64_t(blocks) * threads < sideBySide_.blocksAtOnce();

    if (variant.isSideBySide) MACULA_TRY_VOID(makeRoomForTraced(std::uint64_t(blocks) * most));
    MACULA_TRY_VOID(scene.scene().indirect().makeBindable());
    MACULA_TRY(const TraceKernels::Found found, kernels.samples(variant));
    // The device does not read it now: each dispatch is waited for.
    std::memcpy(planned_->mapped().data(), planned.data(), planned.size() * sizeof(shared::PlannedBlock));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "trace"));
    MACULA_TRY_VOID(record(recorder, scene, kernels, *found.kernel, variant, blocks, most));
    if (variant.usesIndirect && !plan_.hasPass())
        MACULA_TRY_VOID(scene.scene().indirect().add(recorder, scene.params()));
    const auto start = Clock::now();
    MACULA_TRY(const gpu::Ticket ticket, recorder.submit());
    MACULA_TRY([[maybe_unused]] const bool done, device_->waitFor(ticket));
    const double took = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    // The first dispatch of a kernel compiles it, and says nothing about the pace. Nor does the rest of a
    // pass if it is too small to keep the device busy.
    const bool tells = !work.leavesIdle || blocks == plan_.blockCount();
    if (!found.isNew && tells) pace_.learn(work, samples, took);
    deviceMs_ += took;
    ++dispatches_;
    ++edition_;
    return {};
}

Result<void> Accumulation::clearPrimaries() {
    if (!primaries_) {
        const std::uint64_t pixels = std::uint64_t(film_->width()) * std::uint64_t(film_->height());
        MACULA_TRY(primaries_, gpu::Buffer::create(device_, {.label = "primary vertices",
                                                             .bytes = pixels * shared::kPrimarySamples *
                                                                      sizeof(shared::PrimaryVertex)}));
    }
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "clear primary vertices"));
    recorder.fill(*primaries_, 0);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return {};
}

Result<std::vector<shared::PrimaryVertex>> Accumulation::readPrimaries() const {
    return gpu::read<shared::PrimaryVertex>(*primaries_);
}

Result<bool> Accumulation::hasLostPaths() const {
    if (!device_->isCpu() || plan_.passMost() < 2) return false;
    MACULA_TRY(const Film::Faults seen, film_->faults());
    return seen.abandoned > 0;
}

Result<void> Accumulation::measureSome(const Settings& settings) {
    if (!noiseMap_) {
        MACULA_TRY(noiseMap_, NoiseMap::create(device_, film_->width(), film_->height()));
    }
    if (measuredEdition_ != edition_) noiseMap_->begin();
    measuredEdition_ = edition_;
    estimate_.reset();
    MACULA_TRY_VOID(noiseMap_->measureSome(*film_, settings));
    if (!noiseMap_->isWhole()) return {};
    MACULA_TRY(noises_, noiseMap_->read());
    estimate_ = estimateOf(noises_);
    return {};
}

}  // namespace macula::trace
