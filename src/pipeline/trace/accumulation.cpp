#include "pipeline/trace/accumulation.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::trace {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kMaxBlocks = 65535;  // of one dispatch: what every device allows
constexpr std::uint32_t kMinBlocks = 4;      // of one dispatch, so that no thread of a CPU device is idle

}  // namespace

Result<void> Accumulation::begin(int width, int height) {
    plan_ = SamplingPlan(width, height);
    estimate_.reset();
    deviceMs_ = 0.0;
    if (!film_ || film_->width() != width || film_->height() != height) {
        film_.reset();  // first, so that only one is ever on the device
        noiseMap_.reset();
        planned_.reset();
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

double Accumulation::passMs(const TraceVariant& variant, int bounces) const {
    return plan_.blockCount() / pace_.perMs({.variant = variant, .bounces = bounces});
}

Result<void> Accumulation::step(const SceneView& scene, TraceKernels& kernels, const TraceVariant& variant,
                                int bounces, double ms) {
    const Work work{.variant = variant, .bounces = bounces, .isAdaptive = plan_.isAdaptive()};
    const auto blocks = plan_.next(pace_.perMs(work) * ms, kMinBlocks, kMaxBlocks);
    MACULA_TRY(const TraceKernels::Found found, kernels.samples(variant));
    // Nothing reads it now: each dispatch is waited for.
    std::memcpy(planned_->mapped().data(), blocks.data(), blocks.size() * sizeof(shared::PlannedBlock));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "trace"));
    std::vector<gpu::Binding> bindings = scene.bindings();
    film_->appendTo(bindings);
    bindings.emplace_back(*planned_);
    if (variant.tellsPrimaries) bindings.emplace_back(*primaries_);
    recorder.dispatch(*found.kernel,
                      {static_cast<std::uint32_t>(blocks.size()) * shared::kBlockEdge, shared::kBlockEdge},
                      bindings);
    const auto start = Clock::now();
    MACULA_TRY(const gpu::Ticket ticket, recorder.submit());
    MACULA_TRY([[maybe_unused]] const bool done, device_->waitFor(ticket));
    const double took = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    double samples = 0.0;
    for (const shared::PlannedBlock& block : blocks) samples += block.sampleCount;
    // The first dispatch of a kernel compiles it, and says nothing about the pace.
    if (!found.isNew) pace_.learn(work, samples, took);
    deviceMs_ += took;
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
