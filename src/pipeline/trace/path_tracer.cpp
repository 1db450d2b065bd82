#include "pipeline/trace/path_tracer.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <numeric>

#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/film.h"
#include "shaders/trace.h"
#include "shared/trace_params.h"

namespace macula::trace {

namespace {

using Clock = std::chrono::steady_clock;

// A dispatch is this long or shorter: a cancel is quick, and no watchdog fires.
constexpr double kDispatchMs = 40.0;
constexpr int kBlock = 8;                    // pixels; a work group is a square of them
constexpr std::uint32_t kMaxBlocks = 65535;  // of one dispatch: what every device allows
constexpr std::uint32_t kMinBlocks = 4;      // so that no thread of a CPU device is idle
constexpr double kFirstRate = 0.5;           // block samples per ms, before anything is known: a slow CPU
// Several samples of a pixel in one dispatch keep a lane busy while its neighbours' paths are longer. Not too
// many vertices in all: see kMaxRounds in path.comp.
constexpr int kMaxVerticesPerDispatch = 64;
constexpr int kMaxRoundsCpu = 16000;
constexpr int kMaxRoundsGpu = 1 << 24;  // no limit is known: only so that nothing runs for ever

// A step through `blocks` that visits each once and spreads any few of them evenly: near the golden section,
// coprime, and small enough that the shader's product does not overflow.
std::uint32_t spreadingStride(std::uint32_t blocks) {
    constexpr double kGolden = 0.6180339887;
    auto stride = static_cast<std::uint32_t>(std::min(kGolden * blocks, 4294967295.0 / blocks - 64.0));
    stride = std::max(stride, 1u);
    while (std::gcd(stride, blocks) != 1) ++stride;
    return stride;
}

// Something was never set, or could not be: why is told by the error of that call.
Error nothingToTrace() {
    return {ErrorCode::usage, "There is nothing to trace yet.", {}, "Open a study first."};
}

}  // namespace

struct PathTracer::Impl {
    Impl(std::shared_ptr<gpu::Device> d, DeviceScene s) : device(std::move(d)), scene(std::move(s)) {}

    std::shared_ptr<gpu::Device> device;

    DeviceScene scene;
    Settings settings;
    View view;

    // How.
    std::map<std::pair<Filter, bool>, gpu::Kernel> pathKernels;  // by filter, and whether there is a clip
    std::map<bool, gpu::Kernel> depthKernels;                    // by whether there is a clip
    std::optional<gpu::Kernel> displayKernel;
    bool paramsStale = true;  // something above has changed: accumulation starts again
    std::map<std::pair<Filter, int>, double> blockSamplesPerMs;  // by filter and bounces
    bool warm = false;  // the first dispatch of a kernel compiles it, and says nothing about speed

    // What has been traced.
    std::optional<Film> film;
    std::uint32_t samplesDone = 0;  // of every pixel
    std::uint32_t passSamples = 0;  // that the pass in progress adds
    std::uint32_t passBlock = 0;    // where it goes on
    double deviceMs = 0.0;
    std::uint32_t mostSamples = UINT32_MAX;  // of one dispatch; lowered when paths turn out too long

    Result<void> prepare();
    Result<bool> tooLong();
    Result<const gpu::Kernel*> pathKernel();
    Result<const gpu::Kernel*> depthKernel();
    std::uint32_t blocks() const;  // of the picture
    double& rate() {
        return blockSamplesPerMs.try_emplace({settings.filter, settings.bounces}, kFirstRate).first->second;
    }
    Result<void> traceBlocks(std::uint32_t count);
};

PathTracer::PathTracer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

Result<PathTracer> PathTracer::create(std::shared_ptr<gpu::Device> device, const MemoryLimits& limits) {
    MACULA_TRY(DeviceScene scene, DeviceScene::create(device, limits));
    auto impl = std::make_unique<Impl>(std::move(device), std::move(scene));
    MACULA_TRY(impl->displayKernel, gpu::Kernel::create(impl->device, shaders::trace_display_comp));
    return PathTracer(std::move(impl));
}

Result<void> PathTracer::setVolume(std::shared_ptr<const Volume> volume) {
    impl_->mostSamples = UINT32_MAX;
    impl_->paramsStale = true;
    return impl_->scene.setVolume(std::move(volume));
}

Result<void> PathTracer::setTransferFunction(const TransferFunction& function) {
    impl_->mostSamples = UINT32_MAX;
    impl_->paramsStale = true;
    return impl_->scene.setTransferFunction(function);
}

Result<void> PathTracer::setEnvironment(const Environment& environment) {
    impl_->paramsStale = true;
    return impl_->scene.setEnvironment(environment);
}

Result<void> PathTracer::setClip(const Clip& clip) {
    MACULA_TRY_VOID(impl_->scene.setClip(clip));
    impl_->paramsStale = true;
    return {};
}

Result<void> PathTracer::setSettings(const Settings& settings) {
    impl_->settings = settings;
    impl_->paramsStale = true;
    return {};
}

Result<void> PathTracer::setView(const View& view) {
    impl_->view = view;
    impl_->paramsStale = true;
    return {};
}

Result<const gpu::Kernel*> PathTracer::Impl::pathKernel() {
    const auto found = pathKernels.find({settings.filter, scene.isClipped()});
    if (found != pathKernels.end()) return &found->second;
    MACULA_TRY(gpu::Kernel kernel,
               gpu::Kernel::create(
                   device, shaders::trace_path_comp,
                   {.specializations = {{"kTrilinear", settings.filter == Filter::trilinear},
                                        {"kClip", scene.isClipped()},
                                        {"kMaxRounds", device->isCpu() ? kMaxRoundsCpu : kMaxRoundsGpu}}}));
    warm = false;
    return &pathKernels.emplace(std::pair(settings.filter, scene.isClipped()), std::move(kernel))
                .first->second;
}

Result<const gpu::Kernel*> PathTracer::Impl::depthKernel() {
    const auto found = depthKernels.find(scene.isClipped());
    if (found != depthKernels.end()) return &found->second;
    MACULA_TRY(gpu::Kernel kernel, gpu::Kernel::create(device, shaders::trace_depth_comp,
                                                       {.specializations = {{"kClip", scene.isClipped()}}}));
    return &depthKernels.emplace(scene.isClipped(), std::move(kernel)).first->second;
}

// Brings the device up to what was set, and starts a new accumulation when anything changed.
Result<void> PathTracer::Impl::prepare() {
    if (!scene.isComplete()) return nothingToTrace();
    if (!paramsStale) return {};
    MACULA_TRY_VOID(scene.look(view, settings));
    if (!film || film->width() != view.width || film->height() != view.height) {
        film.reset();  // first, so that only one is ever on the device
        auto made = Film::create(device, view.width, view.height);
        if (!made) {
            Error error = made.error();
            if (error.code == ErrorCode::outOfMemory)
                error.hint = "Choose a smaller picture, or another device.";
            return error;
        }
        film.emplace(std::move(*made));
    }
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "start accumulation"));
    film->clear(recorder);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    samplesDone = 0;
    passSamples = 0;
    passBlock = 0;
    deviceMs = 0.0;
    paramsStale = false;
    return {};
}

std::uint32_t PathTracer::Impl::blocks() const {
    return static_cast<std::uint32_t>((film->width() + kBlock - 1) / kBlock) *
           static_cast<std::uint32_t>((film->height() + kBlock - 1) / kBlock);
}

// Adds the samples of the pass to the next blocks, waits, and learns how fast the device is.
Result<void> PathTracer::Impl::traceBlocks(std::uint32_t count) {
    MACULA_TRY(const gpu::Kernel* kernel, pathKernel());
    const shared::PathPush push{.firstBlock = passBlock,
                                .blockCount = blocks(),
                                .blockStride = spreadingStride(blocks()),
                                .firstSample = samplesDone,
                                .sampleCount = passSamples};
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "trace"));
    std::vector<gpu::Binding> bindings = scene.bindings();
    film->appendTo(bindings);
    recorder.dispatch(*kernel, {count * kBlock, kBlock}, push, bindings);
    const auto begin = Clock::now();
    MACULA_TRY(const gpu::Ticket ticket, recorder.submit());
    MACULA_TRY([[maybe_unused]] const bool done, device->waitFor(ticket));
    const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    if (warm) rate() = 0.5 * (rate() + double(count) * passSamples / std::max(ms, 1e-3));
    warm = true;
    deviceMs += ms;
    passBlock += count;
    return {};
}

// Whether paths were lost to the device's limit that smaller portions would keep. Then the picture is begun
// again: to leave out long paths only, which are those through dense matter, would darken it.
Result<bool> PathTracer::Impl::tooLong() {
    if (!device->isCpu() || passSamples < 2) return false;
    MACULA_TRY(const auto seen, film->faults());
    return seen.abandoned > 0;
}

Result<bool> PathTracer::trace(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    // A pass that was interrupted is part of what was asked for.
    const std::uint32_t target = t.samplesDone + std::max(samplesPerPixel, t.passSamples);
    while (t.samplesDone < target) {
        if (t.passSamples == 0) {
            const auto most =
                static_cast<std::uint32_t>(std::max(kMaxVerticesPerDispatch / t.settings.bounces, 1));
            t.passSamples = std::min({most, t.mostSamples, target - t.samplesDone});
            t.passBlock = 0;
        }
        const double affordable =
            std::clamp(t.rate() * kDispatchMs / t.passSamples, double(kMinBlocks), double(kMaxBlocks));
        MACULA_TRY_VOID(
            t.traceBlocks(std::min(static_cast<std::uint32_t>(affordable), t.blocks() - t.passBlock)));
        if (t.passBlock >= t.blocks()) {
            MACULA_TRY(const bool again, t.tooLong());
            if (again) {
                t.mostSamples = t.passSamples / 2;
                t.paramsStale = true;
                MACULA_TRY_VOID(t.prepare());
            } else {
                t.samplesDone += t.passSamples;
                t.passSamples = 0;
            }
        }
        if (keepGoing && !keepGoing()) break;
    }
    return t.passSamples == 0;
}

Result<const gpu::Image*> PathTracer::display(const glm::vec3& background, Smoothing smoothing) {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    MACULA_TRY(auto recorder, gpu::Recorder::create(t.device, "display"));
    const shared::DisplayPush push{.background = background,
                                   .exposure = static_cast<float>(t.settings.exposure),
                                   .smoothing = static_cast<int>(smoothing)};
    recorder.dispatch(*t.displayKernel,
                      {static_cast<std::uint32_t>(t.view.width), static_cast<std::uint32_t>(t.view.height)},
                      push, {t.film->sums(), t.film->counts(), t.film->picture()});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &t.film->picture();
}

Result<std::vector<std::uint8_t>> PathTracer::readDisplay(const glm::vec3& background) {
    MACULA_TRY(const gpu::Image* picture, display(background));
    return gpu::read<std::uint8_t>(*picture);
}

Result<TracedImage> PathTracer::readback() {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    const std::size_t pixels = std::size_t(t.view.width) * std::size_t(t.view.height);
    MACULA_TRY(const gpu::Buffer distances,
               gpu::Buffer::create(t.device, {.label = "distances", .bytes = pixels * sizeof(float)}));
    MACULA_TRY(const gpu::Kernel* depthKernel, t.depthKernel());
    MACULA_TRY(auto recorder, gpu::Recorder::create(t.device, "depth"));
    std::vector<gpu::Binding> bindings = t.scene.bindings();
    bindings.emplace_back(distances);
    recorder.dispatch(*depthKernel,
                      {static_cast<std::uint32_t>(t.view.width), static_cast<std::uint32_t>(t.view.height)},
                      bindings);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());

    TracedImage image{.width = t.view.width, .height = t.view.height, .radiance = {}, .depthMm = {}};
    MACULA_TRY(image.radiance, gpu::read<glm::vec4>(t.film->sums()));
    MACULA_TRY(image.depthMm, gpu::read<float>(distances));
    MACULA_TRY(const auto counts, gpu::read<std::uint32_t>(t.film->counts()));
    for (std::size_t i = 0; i < pixels; ++i) {
        image.radiance[i] /= static_cast<float>(std::max(counts[i], 1u));
        if (image.depthMm[i] < 0.0f) image.depthMm[i] = std::numeric_limits<float>::infinity();
    }
    return image;
}

Result<Statistics> PathTracer::statistics() const {
    const Impl& t = *impl_;
    Statistics statistics;
    statistics.voxels = t.scene.voxelMemory();
    statistics.messages = t.scene.messages();
    if (t.paramsStale) return statistics;
    statistics.samplesPerPixel = t.samplesDone;
    statistics.deviceMs = t.deviceMs;
    if (t.samplesDone > 0 || t.passBlock > 0) {
        MACULA_TRY(const auto faults, t.film->faults());
        statistics.nonFiniteSamples = faults.nonFinite;
        statistics.abandonedSamples = faults.abandoned;
    }
    return statistics;
}

}  // namespace macula::trace
