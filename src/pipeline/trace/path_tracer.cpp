#include "pipeline/trace/path_tracer.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <limits>
#include <map>
#include <span>
#include <tuple>

#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/denoiser.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/film.h"
#include "pipeline/trace/noise_map.h"
#include "pipeline/trace/sampling_plan.h"
#include "pipeline/trace/trace_kernels.h"
#include "shaders/trace.h"
#include "shared/trace_params.h"

namespace macula::trace {

namespace {

using Clock = std::chrono::steady_clock;

// A dispatch is this long or shorter: a cancel is quick, and no watchdog fires.
constexpr double kDispatchMs = 40.0;
constexpr double kLeastDispatchMs = 4.0;     // less is mostly overhead
constexpr std::uint32_t kMaxBlocks = 65535;  // of one dispatch: what every device allows
constexpr std::uint32_t kMinBlocks = 4;      // so that no thread of a CPU device is idle
constexpr double kFirstRate = 0.1;  // block samples per ms, before anything is known: a very slow CPU
constexpr double kFaster = 2.0;     // at most so much larger is a dispatch than the one before
constexpr double kDenser = 0.5;     // of the rate of even passes: the blocks that noise chooses take longer
// Several samples of a pixel in one dispatch keep a lane busy while its neighbours' paths are longer. Not too
// many vertices in all: see kMaxRounds in path.comp.
constexpr int kMaxVerticesPerDispatch = 64;
constexpr std::uint32_t kMaxRaysPerDispatch = 4;  // of a pixel that is cast; a ray is as long as it is
// A pass that adapts adds so much to the samples there are: then it is time to look again where noise is.
constexpr double kGrowth = 0.5;

// A gaze that jumps asks for detail where the picture before had little.
constexpr double kFarthestGaze = 0.1;

const glm::dvec3 kLuminance(0.2126, 0.7152, 0.0722);  // Rec. 709

// A view that turned by more shows other sides of things: nothing is gained from the one before.
constexpr double kMostTurnDeg = 20.0;
constexpr double kMostTurnWithLightsDeg = 1.0;

// With the gaze within `farthest`, in half widths and half heights of the picture.
bool sameFovea(const std::optional<Foveation>& a, const std::optional<Foveation>& b, double farthest) {
    if (!a || !b) return !a && !b;
    return a->fieldDeg == b->fieldDeg && a->magnification == b->magnification &&
           glm::distance(a->gaze, b->gaze) <= farthest;
}

bool sameView(const View& a, const View& b) {
    return a.width == b.width && a.height == b.height && a.camera.positionMm == b.camera.positionMm &&
           a.camera.targetMm == b.camera.targetMm && a.camera.up == b.camera.up &&
           a.camera.verticalFovDeg == b.camera.verticalFovDeg && sameFovea(a.foveation, b.foveation, 0.0);
}

// Of luminance and of coverage, which is 0 or 1 in each sample and so its own square.
glm::vec2 varianceOfMean(const glm::vec4& sums, float squares, std::uint32_t count) {
    if (count < 2) return glm::vec2(std::numeric_limits<float>::infinity());
    const glm::dvec2 mean = glm::dvec2(glm::dot(glm::dvec3(sums), kLuminance), sums.w) / double(count);
    const glm::dvec2 meanSquare = glm::dvec2(squares, sums.w) / double(count);
    return glm::max(meanSquare - mean * mean, glm::dvec2(0.0)) / double(count - 1);
}

// Something was never set, or could not be: why is told by the error of that call.
Error nothingToTrace() {
    return {ErrorCode::usage, "There is nothing to trace yet.", {}, "Open a study first."};
}

}  // namespace

struct PathTracer::Impl {
    Impl(std::shared_ptr<gpu::Device> d, DeviceScene s)
        : device(std::move(d)), scene(std::move(s)), kernels(device) {}

    std::shared_ptr<gpu::Device> device;

    DeviceScene scene;
    Settings settings;
    View view;

    // How.
    TraceKernels kernels;
    std::optional<gpu::Kernel> displayKernel;
    bool paramsStale = true;  // something above has changed: accumulation starts again
    bool restarting = false;  // nothing has: only the portions were too large
    // By kernel and bounces, and whether the passes adapt.
    std::map<std::tuple<TraceVariant, int, bool>, double> blockSamplesPerMs;
    bool warm = false;  // the first dispatch of a kernel compiles it, and says nothing about speed

    // What has been traced.
    std::optional<Film> film;
    std::optional<gpu::Buffer> planned;  // PlannedBlock: what the dispatch under way does
    SamplingPlan plan;
    std::uint64_t edition = 0;  // of the film: grows whenever something is added to it, or it is cleared
    double deviceMs = 0.0;

    // How noisy it is.
    std::optional<NoiseMap> noiseMap;
    std::uint64_t measuredEdition = 0;  // of the film, that the map is of, or is being made of
    std::vector<shared::BlockNoise> noises;
    std::optional<ErrorEstimate> estimate;  // of this accumulation, the last one made

    // What it shows, and what the view before showed.
    std::optional<Guides> guides, guidesBefore;
    std::optional<Denoiser> denoiser;
    bool guidesStale = true;
    std::optional<View> filmView;  // what the film has samples of
    std::uint32_t filmSeed = 0;
    View viewBefore;                               // what it had samples of before
    bool matterChanged = true;                     // or its light: no earlier view shows the same
    std::optional<std::uint64_t> denoisedEdition;  // of the film, when the denoiser ran
    Denoising denoisedAs = Denoising::off;         // then

    std::uint32_t mostSamples = UINT32_MAX;  // of one dispatch; lowered when paths turn out too long

    Result<void> prepare();
    Result<void> prepareGuides();
    void turnPage();
    bool continues(const View& from, const View& to) const;
    Result<void> denoise();
    Result<bool> tooLong();
    SceneKind sceneKind() const {
        return {.clip = scene.isClipped(),
                .mask = scene.isMasked(),
                .gradientOpacity = scene.hasGradientOpacity()};
    }
    TraceVariant variant() const { return variantOf(settings, sceneKind()); }
    std::uint32_t mostPerDispatch() const;  // samples of a pixel
    double& rate(bool adaptive) {
        const double first = adaptive ? kDenser * rate(false) : kFirstRate;
        return blockSamplesPerMs.try_emplace({variant(), settings.bounces, adaptive}, first).first->second;
    }
    Result<void> traceBlocks(std::span<const shared::PlannedBlock> blocks);
    Result<void> step(double ms);
    void beginEvenPass(double samples);
    bool needsEstimate() const;
    Result<void> measureSome();
    bool converged() const { return estimate && isConverged(*estimate, settings.errorThreshold); }
    Result<void> stepFor(double leftMs);
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
    impl_->matterChanged = true;
    impl_->paramsStale = true;
    return impl_->scene.setVolume(std::move(volume));
}

Result<void> PathTracer::setTransferFunction(const TransferFunction& function) {
    impl_->mostSamples = UINT32_MAX;
    impl_->matterChanged = true;
    impl_->paramsStale = true;
    return impl_->scene.setTransferFunction(function);
}

Result<void> PathTracer::setEnvironment(const Environment& environment) {
    impl_->matterChanged = true;
    impl_->paramsStale = true;
    return impl_->scene.setEnvironment(environment);
}

Result<void> PathTracer::setClip(const Clip& clip) {
    MACULA_TRY_VOID(impl_->scene.setClip(clip));
    impl_->matterChanged = true;
    impl_->paramsStale = true;
    return {};
}

Result<void> PathTracer::setSettings(const Settings& settings) {
    // What may differ while the light that arrives from each point stays what it was.
    Settings same = settings;
    same.seed = impl_->settings.seed;
    same.exposure = impl_->settings.exposure;
    same.denoising = impl_->settings.denoising;
    same.errorThreshold = impl_->settings.errorThreshold;
    const bool changed = same != impl_->settings;
    // What is shown of the samples, and how many are enough.
    const bool onlyAfterwards = !changed && settings.seed == impl_->settings.seed &&
                                settings.exposure == impl_->settings.exposure &&
                                (settings.denoising != impl_->settings.denoising ||
                                 settings.errorThreshold != impl_->settings.errorThreshold);
    impl_->settings = settings;
    if (onlyAfterwards) return {};
    impl_->matterChanged = impl_->matterChanged || changed;
    impl_->paramsStale = true;
    return {};
}

Result<void> PathTracer::setView(const View& view) {
    impl_->view = view;
    impl_->paramsStale = true;
    return {};
}

std::uint32_t PathTracer::Impl::mostPerDispatch() const {
    if (!isPathTraced(settings.look)) return std::max(std::min(kMaxRaysPerDispatch, mostSamples), 1u);
    const int bounces = settings.look == Look::clear ? 1 : settings.bounces;
    const auto most = static_cast<std::uint32_t>(std::max(kMaxVerticesPerDispatch / bounces, 1));
    return std::max(std::min(most, mostSamples), 1u);
}

// Brings the device up to what was set, and starts a new accumulation when anything changed.
Result<void> PathTracer::Impl::prepare() {
    if (!scene.isComplete()) return nothingToTrace();
    if (!paramsStale) return {};
    if (!restarting) turnPage();
    restarting = false;
    denoisedEdition.reset();
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
        noiseMap.reset();
        planned.reset();
    }
    plan = SamplingPlan(view.width, view.height);
    if (!planned) {
        const std::uint64_t most = std::min(plan.blockCount(), kMaxBlocks);
        MACULA_TRY(planned, gpu::Buffer::create(device, {.label = "planned blocks",
                                                         .bytes = most * sizeof(shared::PlannedBlock),
                                                         .memory = gpu::MemoryKind::upload}));
    }
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "start accumulation"));
    film->clear(recorder);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    ++edition;
    estimate.reset();
    deviceMs = 0.0;
    guidesStale = true;
    paramsStale = false;
    return {};
}

// Whether `to` can use what `from` has shown: it is as large and as wide, and the light stayed where it was.
bool PathTracer::Impl::continues(const View& from, const View& to) const {
    if (from.width != to.width || from.height != to.height ||
        from.camera.verticalFovDeg != to.camera.verticalFovDeg ||
        !sameFovea(from.foveation, to.foveation, kFarthestGaze)) {
        return false;
    }
    const auto eyeFrom = basis(from.camera);
    const auto eyeTo = basis(to.camera);
    if (!eyeFrom || !eyeTo) return false;
    // What turns with the camera lights matter otherwise from degree to degree.
    const double turned =
        std::min(glm::dot(eyeFrom->forward, eyeTo->forward), glm::dot(eyeFrom->up, eyeTo->up));
    const bool lightsTurn = scene.lightFrame() == LightFrame::camera;
    return turned >= std::cos(glm::radians(lightsTurn ? kMostTurnWithLightsDeg : kMostTurnDeg));
}

// What the film shows becomes what the view before showed; if nobody has seen it, there was none.
void PathTracer::Impl::turnPage() {
    const bool traced = filmView && plan.leastSamples() > 0;
    const bool again = traced && filmSeed == settings.seed && sameView(*filmView, view);
    if (traced) {
        const bool known = denoiser && denoisedEdition && !guidesStale;
        if (known) {
            std::swap(guides, guidesBefore);
            denoiser->advance();
        } else if (denoiser) {
            denoiser->forget();
        }
        viewBefore = *filmView;
    }
    if (!filmView || matterChanged) viewBefore = view;
    // The same random numbers once more would tell nothing new.
    if (denoiser && (matterChanged || again || !continues(viewBefore, view))) denoiser->forget();
    filmView = view;
    filmSeed = settings.seed;
    matterChanged = false;
}

Result<void> PathTracer::Impl::prepareGuides() {
    MACULA_TRY_VOID(prepare());
    if (!guidesStale) return {};
    if (!guides || guides->width() != view.width || guides->height() != view.height) {
        guides.reset();
        MACULA_TRY(guides, Guides::create(device, view.width, view.height));
    }
    MACULA_TRY(const shared::GuidePush push, guidePush(view, viewBefore));
    MACULA_TRY(const gpu::Kernel* kernel, kernels.guides(sceneKind()));
    MACULA_TRY_VOID(guides->compute(scene, *kernel, push));
    guidesStale = false;
    return {};
}

// Makes the denoiser's result that of the samples so far.
Result<void> PathTracer::Impl::denoise() {
    MACULA_TRY_VOID(prepareGuides());
    if (denoisedEdition == edition && denoisedAs == settings.denoising) return {};
    if (!denoiser || denoiser->width() != view.width || denoiser->height() != view.height) {
        denoiser.reset();
        MACULA_TRY(auto filters, kernels.denoising());
        MACULA_TRY(denoiser, Denoiser::create(device, std::move(filters), view.width, view.height));
    }
    const double pixelAngle = 2.0 * std::tan(glm::radians(view.camera.verticalFovDeg) / 2.0) / view.height;
    MACULA_TRY_VOID(denoiser->run(*film, *guides, guidesBefore ? &*guidesBefore : nullptr,
                                  static_cast<float>(pixelAngle), settings.denoising));
    denoisedEdition = edition;
    denoisedAs = settings.denoising;
    return {};
}

// Adds the samples that are planned, waits, and learns how fast the device is.
Result<void> PathTracer::Impl::traceBlocks(std::span<const shared::PlannedBlock> blocks) {
    MACULA_TRY(const TraceKernels::Found found, kernels.samples(variant()));
    if (found.isNew) warm = false;
    // Nothing reads it now: each dispatch is waited for.
    std::memcpy(planned->mapped().data(), blocks.data(), blocks.size_bytes());
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "trace"));
    std::vector<gpu::Binding> bindings = scene.bindings();
    film->appendTo(bindings);
    bindings.emplace_back(*planned);
    recorder.dispatch(*found.kernel,
                      {static_cast<std::uint32_t>(blocks.size()) * shared::kBlockEdge, shared::kBlockEdge},
                      bindings);
    const auto begin = Clock::now();
    MACULA_TRY(const gpu::Ticket ticket, recorder.submit());
    MACULA_TRY([[maybe_unused]] const bool done, device->waitFor(ticket));
    const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    double samples = 0.0;
    for (const shared::PlannedBlock& block : blocks) samples += block.sampleCount;
    // Slower is believed at once, faster only by and by: a few blocks may be empty, and the next ones not.
    double& known = rate(plan.isAdaptive());
    const double measured = samples / std::max(ms, 1e-3);
    if (warm) known = measured < known ? measured : std::min(0.5 * (known + measured), kFaster * known);
    warm = true;
    deviceMs += ms;
    ++edition;
    return {};
}

// Whether paths were lost to the device's limit that smaller portions would keep. Then the picture is begun
// again: to leave out long paths only, which are those through dense matter, would darken it.
Result<bool> PathTracer::Impl::tooLong() {
    if (!device->isCpu() || plan.passMost() < 2) return false;
    MACULA_TRY(const auto seen, film->faults());
    return seen.abandoned > 0;
}

void PathTracer::Impl::beginEvenPass(double samples) {
    plan.beginEven(static_cast<std::uint32_t>(std::clamp(samples, 1.0, double(mostPerDispatch()))));
}

// One dispatch of the pass under way, which takes about `ms`.
Result<void> PathTracer::Impl::step(double ms) {
    const double affordable = rate(plan.isAdaptive()) * ms;
    // Where it fails, nobody knows what the film holds.
    paramsStale = true;
    MACULA_TRY_VOID(traceBlocks(plan.next(affordable, kMinBlocks, kMaxBlocks)));
    paramsStale = false;
    if (plan.hasPass()) return {};
    MACULA_TRY(const bool again, tooLong());
    if (!again) return {};
    mostSamples = plan.passMost() / 2;
    paramsStale = true;
    restarting = true;
    return prepare();
}

Result<bool> PathTracer::trace(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    if (t.plan.isAdaptive()) t.plan.dropPass();
    // A pass that was interrupted is part of what was asked for.
    const std::uint32_t underWay = t.plan.hasPass() ? t.plan.passMost() : 0;
    const std::uint32_t target = t.plan.leastSamples() + std::max(samplesPerPixel, underWay);
    // After adaptive passes the blocks with the fewest may be done before the others.
    while (t.plan.hasPass() || t.plan.leastSamples() < target) {
        if (!t.plan.hasPass()) t.beginEvenPass(target - t.plan.leastSamples());
        MACULA_TRY_VOID(t.step(kDispatchMs));
        if (keepGoing && !keepGoing()) break;
    }
    return !t.plan.hasPass();
}

// Noise decides about the next pass, or about whether there is one.
bool PathTracer::Impl::needsEstimate() const {
    if (plan.leastSamples() < kEvenSamples || (estimate && measuredEdition == edition)) return false;
    return isPathTraced(settings.look) || settings.errorThreshold > 0.0;
}

// One dispatch.
Result<void> PathTracer::Impl::measureSome() {
    if (!noiseMap) {
        MACULA_TRY(noiseMap, NoiseMap::create(device, view.width, view.height));
    }
    if (measuredEdition != edition) noiseMap->begin();
    measuredEdition = edition;
    estimate.reset();
    MACULA_TRY_VOID(noiseMap->measureSome(*film, settings));
    if (!noiseMap->isWhole()) return {};
    MACULA_TRY(noises, noiseMap->read());
    estimate = estimateOf(noises);
    return {};
}

// One dispatch of whatever comes next.
Result<void> PathTracer::Impl::stepFor(double leftMs) {
    if (!plan.hasPass()) {
        if (needsEstimate()) return measureSome();
        const std::uint32_t least = plan.leastSamples();
        if (least < kEvenSamples || !isPathTraced(settings.look)) {
            // As many samples as the time that is left has for every pixel; the first picture comes soonest
            // with one.
            const double fitting = least == 0 ? 1.0 : rate(false) * leftMs / plan.blockCount();
            beginEvenPass(least < kEvenSamples ? std::min(fitting, double(kEvenSamples - least)) : fitting);
        } else {
            plan.beginAdaptive(noises, kGrowth * plan.meanSamples(), mostPerDispatch());
        }
    }
    return step(std::clamp(leftMs, kLeastDispatchMs, kDispatchMs));
}

Result<bool> PathTracer::traceFor(double budgetMs, const std::function<bool()>& keepGoing) {
    Impl& t = *impl_;
    const Clock::time_point start = Clock::now();
    MACULA_TRY_VOID(t.prepare());
    for (bool first = true; !t.converged(); first = false) {
        const double leftMs =
            budgetMs - std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        if (leftMs < kLeastDispatchMs && !first) break;
        MACULA_TRY_VOID(t.stepFor(leftMs));
        if (keepGoing && !keepGoing()) break;
    }
    return !t.plan.hasPass();
}

Result<ErrorEstimate> PathTracer::estimateError() {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    while (!t.estimate || t.measuredEdition != t.edition) MACULA_TRY_VOID(t.measureSome());
    return *t.estimate;
}

Result<const gpu::Image*> PathTracer::display(const glm::vec3& background, Smoothing smoothing) {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    const bool denoised = isDenoised(t.settings);
    if (denoised) MACULA_TRY_VOID(t.denoise());
    MACULA_TRY(auto recorder, gpu::Recorder::create(t.device, "display"));
    const shared::DisplayPush push{.background = background,
                                   .exposure = static_cast<float>(t.settings.exposure),
                                   .smoothing = denoised ? 0 : static_cast<int>(smoothing),
                                   .denoised = denoised ? 1 : 0};
    recorder.dispatch(
        *t.displayKernel,
        {static_cast<std::uint32_t>(t.view.width), static_cast<std::uint32_t>(t.view.height)}, push,
        {denoised ? t.denoiser->result() : t.film->sums(), t.film->counts(), t.film->picture()});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &t.film->picture();
}

Result<std::vector<std::uint8_t>> PathTracer::readDisplay(const glm::vec3& background) {
    MACULA_TRY(const gpu::Image* picture, display(background));
    return gpu::read<std::uint8_t>(*picture);
}

Result<const Guides*> PathTracer::guides() {
    MACULA_TRY_VOID(impl_->prepareGuides());
    return &*impl_->guides;
}

Result<std::vector<GuidePixel>> PathTracer::readGuides() {
    MACULA_TRY(const Guides* computed, guides());
    return computed->read();
}

Result<SurfacePoints> PathTracer::surfacePoints(const SurfacePointOptions& options,
                                                const std::function<bool()>& keepGoing) {
    MACULA_TRY_VOID(impl_->prepare());
    SceneKind kind = impl_->sceneKind();
    kind.greyFaces = impl_->scene.hasGreyFaces();
    return findSurfacePoints(impl_->device, impl_->scene, impl_->kernels, kind, options, keepGoing);
}

Result<TracedImage> PathTracer::readback() {
    Impl& t = *impl_;
    MACULA_TRY(const std::vector<GuidePixel> pixels, readGuides());
    TracedImage image{.width = t.view.width,
                      .height = t.view.height,
                      .radiance = {},
                      .depthMm = {},
                      .variance = {},
                      .denoised = isDenoised(t.settings)};
    if (image.denoised) MACULA_TRY_VOID(t.denoise());
    MACULA_TRY(image.radiance, gpu::read<glm::vec4>(t.film->sums()));
    MACULA_TRY(const auto counts, gpu::read<std::uint32_t>(t.film->counts()));
    MACULA_TRY(const auto squares, gpu::read<glm::vec2>(t.film->squares()));
    image.depthMm.resize(pixels.size(), std::numeric_limits<float>::infinity());
    image.samples = counts;
    image.variance.resize(pixels.size(), glm::vec2(std::numeric_limits<float>::infinity()));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        image.variance[i] = varianceOfMean(image.radiance[i], squares[i].x, counts[i]);
        image.radiance[i] /= static_cast<float>(std::max(counts[i], 1u));
        if (pixels[i].depthMm >= 0.0f && !isProjection(t.settings.look)) image.depthMm[i] = pixels[i].depthMm;
    }
    if (image.denoised) {
        MACULA_TRY(image.radiance, gpu::read<glm::vec4>(t.denoiser->result()));
    }
    return image;
}

Result<Statistics> PathTracer::statistics() const {
    const Impl& t = *impl_;
    Statistics statistics;
    statistics.voxels = t.scene.voxelMemory();
    statistics.messages = t.scene.messages();
    statistics.denoised = isDenoised(t.settings);
    if (t.paramsStale) return statistics;
    statistics.samplesPerPixel = t.plan.leastSamples();
    statistics.meanSamplesPerPixel = t.plan.meanSamples();
    if (t.estimate) statistics.estimatedError = t.estimate->rms;
    statistics.converged = t.converged();
    statistics.deviceMs = t.deviceMs;
    if (statistics.meanSamplesPerPixel > 0.0) {
        MACULA_TRY(const auto faults, t.film->faults());
        statistics.nonFiniteSamples = faults.nonFinite;
        statistics.abandonedSamples = faults.abandoned;
    }
    return statistics;
}

}  // namespace macula::trace
