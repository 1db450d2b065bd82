#include "pipeline/trace/path_tracer.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <numeric>

#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/scene.h"
#include "shaders/trace.h"

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

template <class T>
Result<gpu::TexelBuffer> makeTexels(const std::shared_ptr<gpu::Device>& device, const char* label,
                                    VkFormat format, std::span<const T> values) {
    MACULA_TRY(auto texels, gpu::TexelBuffer::create(
                                device, {.label = label, .elements = values.size(), .format = format}));
    MACULA_TRY_VOID(gpu::uploadTo(texels.buffer(), values));
    return texels;
}

Result<gpu::TexelBuffer> makeEntryTexels(const std::shared_ptr<gpu::Device>& device, const Volume& volume) {
    const EntryMap map = entryMapOf(volume);
    const std::size_t count = volume.voxels().size();
    if (count > std::size_t(std::numeric_limits<std::int32_t>::max())) {  // shaders index voxels with 31 bits
        return Error{
            ErrorCode::outOfMemory,
            fmt::format("A volume of {} million voxels is more than can be traced.", count / 1000000),
            {},
            "Open a smaller series."};
    }
    // Uploads to memory that is not mapped go by words of 4 bytes.
    MACULA_TRY(auto texels,
               gpu::TexelBuffer::create(
                   device, {.label = "voxels", .elements = count + count % 2, .format = VK_FORMAT_R16_UINT}));
    const std::span<std::byte> mapped = texels.buffer().mapped();
    if (!mapped.empty()) {
        writeEntries(volume, map, 0, {reinterpret_cast<std::uint16_t*>(mapped.data()), count});
        return texels;
    }
    constexpr std::size_t kChunk = std::size_t{8} << 20;
    std::vector<std::uint16_t> chunk;
    for (std::size_t first = 0; first < count; first += kChunk) {
        const std::size_t size = std::min(kChunk, count - first);
        chunk.assign(size + size % 2, 0);
        writeEntries(volume, map, first, std::span(chunk).first(size));
        MACULA_TRY_VOID(
            gpu::uploadTo(texels.buffer(), first * sizeof(std::uint16_t), std::as_bytes(std::span(chunk))));
    }
    return texels;
}

// Something was never set, or could not be: why is told by the error of that call.
Error nothingToTrace() {
    return {ErrorCode::usage, "There is nothing to trace yet.", {}, "Open a study first."};
}

}  // namespace

struct PathTracer::Impl {
    explicit Impl(std::shared_ptr<gpu::Device> d) : device(std::move(d)) {}

    std::shared_ptr<gpu::Device> device;

    // What is traced.
    std::shared_ptr<const Volume> volume;
    BrickGrid grid;
    Medium medium;
    std::optional<gpu::TexelBuffer> entries, extinction, albedo, bounds;
    std::optional<Environment> environment;
    std::optional<gpu::TexelBuffer> environmentTexels, aliasTexels;
    Settings settings;
    View view;

    // How.
    std::optional<gpu::Kernel> trilinearKernel, stochasticKernel, depthKernel, displayKernel;
    std::optional<gpu::Buffer> paramsBuffer;
    bool paramsStale = true;  // something above has changed: accumulation starts again
    std::map<std::pair<Filter, int>, double> blockSamplesPerMs;  // by filter and bounces
    bool warm = false;  // the first dispatch of a kernel compiles it, and says nothing about speed

    // What has been traced.
    std::optional<gpu::Buffer> sums, lost, counts, faults;
    std::optional<gpu::Image> picture;
    int width = 0;
    int height = 0;
    std::uint32_t samplesDone = 0;  // of every pixel
    std::uint32_t passSamples = 0;  // that the pass in progress adds
    std::uint32_t passBlock = 0;    // where it goes on
    double deviceMs = 0.0;
    std::uint32_t mostSamples = UINT32_MAX;  // of one dispatch; lowered when paths turn out too long

    Result<void> prepare();
    Result<bool> tooLong();
    Result<void> makePicture();
    Result<const gpu::Kernel*> pathKernel();
    std::uint32_t blocks() const;  // of the picture
    double& rate() {
        return blockSamplesPerMs.try_emplace({settings.filter, settings.bounces}, kFirstRate).first->second;
    }
    Result<void> traceBlocks(std::uint32_t count);
    Result<void> uploadMedium();
};

PathTracer::PathTracer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

Result<PathTracer> PathTracer::create(std::shared_ptr<gpu::Device> device) {
    auto impl = std::make_unique<Impl>(std::move(device));
    MACULA_TRY(impl->depthKernel, gpu::Kernel::create(impl->device, shaders::trace_depth_comp));
    MACULA_TRY(impl->displayKernel, gpu::Kernel::create(impl->device, shaders::trace_display_comp));
    MACULA_TRY(impl->paramsBuffer, gpu::Buffer::create(impl->device, {.label = "trace params",
                                                                      .bytes = sizeof(shared::TraceParams),
                                                                      .memory = gpu::MemoryKind::upload}));
    MACULA_TRY(impl->faults,
               gpu::Buffer::create(impl->device, {.label = "faults", .bytes = 2 * sizeof(std::uint32_t)}));
    return PathTracer(std::move(impl));
}

Result<void> PathTracer::setVolume(std::shared_ptr<const Volume> volume) {
    MACULA_CHECK(volume != nullptr);
    Impl& t = *impl_;
    t.entries.reset();  // first, so that only one volume is ever on the device
    t.extinction.reset();
    t.volume.reset();
    MACULA_TRY(t.entries, makeEntryTexels(t.device, *volume));
    t.grid = makeBrickGrid(*volume);
    t.mostSamples = UINT32_MAX;
    t.volume = std::move(volume);
    t.paramsStale = true;
    return {};
}

Result<void> PathTracer::setTransferFunction(const TransferFunction& function) {
    Impl& t = *impl_;
    if (!t.volume) return nothingToTrace();
    MACULA_TRY_VOID(validate(function));
    t.mostSamples = UINT32_MAX;
    t.medium = makeMedium(*t.volume, t.grid, fitted(function, *t.volume));
    t.paramsStale = true;
    return t.uploadMedium();
}

Result<void> PathTracer::Impl::uploadMedium() {
    extinction.reset();  // all or none: tables of different length must never meet
    albedo.reset();
    bounds.reset();
    MACULA_TRY(extinction,
               makeTexels<float>(device, "extinction", VK_FORMAT_R32_SFLOAT, medium.extinctionPerMm));
    MACULA_TRY(albedo, makeTexels<glm::vec4>(device, "albedo", VK_FORMAT_R32G32B32A32_SFLOAT, medium.albedo));
    MACULA_TRY(bounds, makeTexels<float>(device, "bounds", VK_FORMAT_R32_SFLOAT, medium.bounds));
    return {};
}

Result<void> PathTracer::setEnvironment(const Environment& environment) {
    Impl& t = *impl_;
    static_assert(sizeof(EnvironmentTexel) == 4 * sizeof(float));
    t.environmentTexels.reset();
    t.aliasTexels.reset();
    MACULA_TRY(t.environmentTexels,
               makeTexels<EnvironmentTexel>(t.device, "environment", VK_FORMAT_R32G32B32A32_SFLOAT,
                                            environment.texels()));
    std::vector<glm::vec2> alias(environment.alias().size());
    std::transform(
        environment.alias().begin(), environment.alias().end(), alias.begin(),
        [](const AliasEntry& entry) { return glm::vec2(entry.keep, static_cast<float>(entry.other)); });
    MACULA_TRY(t.aliasTexels, makeTexels<glm::vec2>(t.device, "alias", VK_FORMAT_R32G32_SFLOAT, alias));
    t.environment = environment;
    t.paramsStale = true;
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
    const bool trilinear = settings.filter == Filter::trilinear;
    auto& kernel = trilinear ? trilinearKernel : stochasticKernel;
    if (!kernel) {
        MACULA_TRY(
            kernel,
            gpu::Kernel::create(
                device, shaders::trace_path_comp,
                {.specializations = {{"kTrilinear", trilinear},
                                     {"kMaxRounds", device->isCpu() ? kMaxRoundsCpu : kMaxRoundsGpu}}}));
        warm = false;
    }
    return &*kernel;
}

// Buffers and picture of the size of the view.
Result<void> PathTracer::Impl::makePicture() {
    if (view.width == width && view.height == height) return {};
    width = 0;  // nothing usable, should the following fail
    const std::uint64_t pixels = std::uint64_t(view.width) * std::uint64_t(view.height);
    sums.reset();
    lost.reset();
    counts.reset();
    picture.reset();
    MACULA_TRY(sums, gpu::Buffer::create(device, {.label = "sums", .bytes = pixels * sizeof(glm::vec4)}));
    MACULA_TRY(lost, gpu::Buffer::create(device, {.label = "lost", .bytes = pixels * sizeof(glm::vec4)}));
    MACULA_TRY(counts,
               gpu::Buffer::create(device, {.label = "counts", .bytes = pixels * sizeof(std::uint32_t)}));
    MACULA_TRY(picture, gpu::Image::create(device, {.label = "picture",
                                                    .width = static_cast<std::uint32_t>(view.width),
                                                    .height = static_cast<std::uint32_t>(view.height),
                                                    .format = VK_FORMAT_R8G8B8A8_UNORM}));
    width = view.width;
    height = view.height;
    return {};
}

// Brings the device up to what was set, and starts a new accumulation when anything changed.
Result<void> PathTracer::Impl::prepare() {
    if (!entries || !extinction || !albedo || !bounds || !environmentTexels || !aliasTexels) {
        return nothingToTrace();
    }
    if (!paramsStale) return {};
    MACULA_TRY(const shared::TraceParams params,
               makeTraceParams(*volume, medium, *environment, view, settings));
    if (auto made = makePicture(); !made) {
        Error error = made.error();
        if (error.code == ErrorCode::outOfMemory) error.hint = "Choose a smaller picture, or another device.";
        return error;
    }
    MACULA_TRY_VOID(device->waitForAll());
    std::memcpy(paramsBuffer->mapped().data(), &params, sizeof(params));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "start accumulation"));
    recorder.fill(*sums, 0);
    recorder.fill(*lost, 0);
    recorder.fill(*counts, 0);
    recorder.fill(*faults, 0);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    samplesDone = 0;
    passSamples = 0;
    passBlock = 0;
    deviceMs = 0.0;
    paramsStale = false;
    return {};
}

std::uint32_t PathTracer::Impl::blocks() const {
    return static_cast<std::uint32_t>((width + kBlock - 1) / kBlock) *
           static_cast<std::uint32_t>((height + kBlock - 1) / kBlock);
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
    recorder.dispatch(*kernel, {count * kBlock, kBlock}, push,
                      {*paramsBuffer, *entries, *extinction, *albedo, *bounds, *environmentTexels,
                       *aliasTexels, *sums, *lost, *counts, *faults});
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
    MACULA_TRY(const auto seen, gpu::read<std::uint32_t>(*faults));
    return seen[1] > 0;
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
                      {static_cast<std::uint32_t>(t.width), static_cast<std::uint32_t>(t.height)}, push,
                      {*t.sums, *t.counts, *t.picture});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &*t.picture;
}

Result<std::vector<std::uint8_t>> PathTracer::readDisplay(const glm::vec3& background) {
    MACULA_TRY(const gpu::Image* picture, display(background));
    return gpu::read<std::uint8_t>(*picture);
}

Result<TracedImage> PathTracer::readback() {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    const std::size_t pixels = std::size_t(t.width) * std::size_t(t.height);
    MACULA_TRY(const gpu::Buffer distances,
               gpu::Buffer::create(t.device, {.label = "distances", .bytes = pixels * sizeof(float)}));
    MACULA_TRY(auto recorder, gpu::Recorder::create(t.device, "depth"));
    recorder.dispatch(*t.depthKernel,
                      {static_cast<std::uint32_t>(t.width), static_cast<std::uint32_t>(t.height)},
                      {*t.paramsBuffer, *t.entries, *t.extinction, *t.albedo, *t.bounds, *t.environmentTexels,
                       *t.aliasTexels, distances});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());

    TracedImage image{.width = t.width, .height = t.height, .radiance = {}, .depthMm = {}};
    MACULA_TRY(image.radiance, gpu::read<glm::vec4>(*t.sums));
    MACULA_TRY(image.depthMm, gpu::read<float>(distances));
    MACULA_TRY(const auto counts, gpu::read<std::uint32_t>(*t.counts));
    for (std::size_t i = 0; i < pixels; ++i) {
        image.radiance[i] /= static_cast<float>(std::max(counts[i], 1u));
        if (image.depthMm[i] < 0.0f) image.depthMm[i] = std::numeric_limits<float>::infinity();
    }
    return image;
}

Result<Statistics> PathTracer::statistics() const {
    const Impl& t = *impl_;
    Statistics statistics{.samplesPerPixel = t.samplesDone,
                          .nonFiniteSamples = 0,
                          .abandonedSamples = 0,
                          .deviceMs = t.deviceMs};
    if (t.paramsStale) return Statistics{};
    if (t.samplesDone > 0 || t.passBlock > 0) {
        MACULA_TRY(const auto faults, gpu::read<std::uint32_t>(*t.faults));
        statistics.nonFiniteSamples = faults[0];
        statistics.abandonedSamples = faults[1];
    }
    return statistics;
}

}  // namespace macula::trace
