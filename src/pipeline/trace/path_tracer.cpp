#include "pipeline/trace/path_tracer.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/accumulation.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/film.h"
#include "pipeline/trace/pixel_layers.h"
#include "pipeline/trace/scene_view.h"
#include "pipeline/trace/trace_kernels.h"
#include "pipeline/trace/variance_map.h"
#include "pipeline/trace/view_history.h"
#include "shaders/trace.h"
#include "shared/trace_params.h"

namespace macula::trace {

namespace {

using Clock = std::chrono::steady_clock;

// A dispatch is this long or shorter: a cancel is quick, and no watchdog fires.
constexpr double kDispatchMs = 40.0;
constexpr double kLeastDispatchMs = 4.0;  // less is mostly overhead
// Several samples of a pixel in one thread keep a lane busy while its neighbours' paths are longer. Not too
// many vertices in all: see kMaxRounds in path_samples.glsl.
constexpr int kMaxVerticesPerDispatch = 64;
constexpr std::uint32_t kMaxRaysPerDispatch = 4;  // samples of a pixel that is cast
// A pass that adapts adds so much to the samples there are: then it is time to look again where noise is.
constexpr double kGrowth = 0.5;

const glm::dvec3 kLuminance(0.2126, 0.7152, 0.0722);  // Rec. 709

// The variance of the means of luminance and of coverage, which is 0 or 1 in each sample and so its own
// square.
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
    Impl(SceneView s, gpu::Kernel display)
        : scene(std::move(s)),
          device(scene.scene().device()),
          kernels(device),
          displayKernel(std::move(display)),
          accumulation(device),
          history(device),
          variances(device) {}

    SceneView scene;
    std::shared_ptr<gpu::Device> device;
    Settings settings;
    View view;

    TraceKernels kernels;
    gpu::Kernel displayKernel;

    double dispatchMs = kDispatchMs;
    bool stale = true;                       // view or settings have changed: accumulation starts again
    bool restarting = false;                 // nothing has changed: only the portions were too large
    bool tellsPrimaries = false;             // the samples under way tell their primary vertices
    std::uint32_t firstPrimary = 0;          // where those begin that were told last
    std::uint32_t primarySamples = 0;        // how many they are
    std::uint32_t mostSamples = UINT32_MAX;  // of one dispatch; lowered when paths turn out too long
    Accumulation accumulation;
    ViewHistory history;
    VarianceMap variances;
    std::optional<SurfacePointSearch> search;  // under way, in what is looked at

    bool isStale() const { return stale || !scene.isCurrent(); }
    void looksOther();
    Result<void> prepare();
    Result<const gpu::Buffer*> denoised();
    TraceVariant variant() const;
    bool usesIndirect() const;
    LightOfScene lightOfScene() const;
    std::uint32_t mostPerDispatch() const;  // samples of a pixel
    void beginEvenPass(double samples);
    void beginPass(double leftMs);
    Result<void> step(double ms);
    bool needsEstimate() const;
    bool converged() const;
    Result<void> stepFor(double leftMs);
};

PathTracer::PathTracer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

Result<PathTracer> PathTracer::create(std::shared_ptr<gpu::Device> device, const MemoryLimits& limits) {
    return of(std::make_shared<DeviceScene>(std::move(device), limits));
}

Result<PathTracer> PathTracer::of(std::shared_ptr<DeviceScene> scene) {
    MACULA_TRY(gpu::Kernel display, gpu::Kernel::create(scene->device(), shaders::trace_display_comp));
    MACULA_TRY(SceneView view, SceneView::create(std::move(scene)));
    return PathTracer(std::make_unique<Impl>(std::move(view), std::move(display)));
}

Result<PathTracer> PathTracer::ofSameScene() const {
    return of(impl_->scene.shared());
}

// Other light arrives from each point of what is shown, along other paths.
void PathTracer::Impl::looksOther() {
    history.forget();
    stale = true;
}

DeviceScene& PathTracer::scene() {
    return impl_->scene.scene();
}

const DeviceScene& PathTracer::scene() const {
    return impl_->scene.scene();
}

Result<Box> PathTracer::seenMm() {
    MACULA_TRY_VOID(impl_->prepare());
    if (isProjection(impl_->settings.look))
        return Error{ErrorCode::usage, "Projections show all of the volume.", {}, "Choose another look."};
    return impl_->scene.scene().seenMm();
}

Result<std::vector<glm::dvec3>> PathTracer::outlineMm() const {
    const DeviceScene& scene = impl_->scene.scene();
    if (!scene.isComplete()) return nothingToTrace();
    return scene.outlineMm();
}

Result<void> PathTracer::setSettings(const Settings& settings) {
    const Settings before = std::exchange(impl_->settings, settings);
    // Samples stay while only what is shown of them differs, and how many are enough. The same settings once
    // more begin anew.
    Settings sameSamples = before;
    sameSamples.denoising = settings.denoising;
    sameSamples.errorThreshold = settings.errorThreshold;
    if (settings != sameSamples || settings == before) impl_->stale = true;
    // The light that arrives from each point stays what it was while these differ besides. Grey faces are
    // another light for each exposure and tone map, so that they look the same.
    Settings sameLight = sameSamples;
    sameLight.seed = settings.seed;
    sameLight.indirect = settings.indirect;
    if (!impl_->scene.scene().hasGreyFaces()) {
        sameLight.exposure = settings.exposure;
        sameLight.toneMap = settings.toneMap;
    }
    if (settings != sameLight) impl_->looksOther();
    return isDenoised(settings) && impl_->scene.scene().isComplete() ? impl_->scene.scene().keepForGradients()
                                                                     : Result<void>();
}

void PathTracer::setDispatchMs(double ms) {
    impl_->dispatchMs = std::max(ms, kLeastDispatchMs);
}

void PathTracer::setSideBySide(std::uint32_t samples) {
    impl_->accumulation.sideBySide().force(samples);
    impl_->stale = true;
}

void PathTracer::forgetViews() {
    impl_->history.forget();
}

Result<void> PathTracer::setView(const View& view) {
    impl_->view = view;
    impl_->stale = true;
    return {};
}

// Whether the cache of indirect light is good for anything.
bool PathTracer::Impl::usesIndirect() const {
    if (settings.indirect == Indirect::traced || !isPathTraced(settings.look)) return false;
    if (verticesOf(settings) < 2 || scene.scene().lightFrame() == LightFrame::camera) return false;
    if (scene.scene().hasSurfaces()) return false;
    return settings.indirect == Indirect::corrected || scene.scene().anisotropy() == 0.0;
}

LightOfScene PathTracer::Impl::lightOfScene() const {
    return {.sceneEdition = scene.scene().edition(),
            .bounces = settings.bounces,
            .strength = settings.lightStrength,
            .rotationDeg = settings.lightRotationDeg,
            .exposure = scene.scene().hasGreyFaces() ? settings.exposure : 1.0,
            .toneMap = scene.scene().hasGreyFaces() ? settings.toneMap : ToneMap::neutral};
}

TraceVariant PathTracer::Impl::variant() const {
    TraceVariant variant = variantOf(settings, kindOf(scene.scene()));
    variant.tellsPrimaries = tellsPrimaries;
    variant.usesIndirect = usesIndirect();
    variant.isSideBySide = isPathTraced(settings.look) && !tellsPrimaries && accumulation.isSideBySide();
    return variant;
}

std::uint32_t PathTracer::Impl::mostPerDispatch() const {
    if (!isPathTraced(settings.look)) return std::max(std::min(kMaxRaysPerDispatch, mostSamples), 1u);
    const auto perThread =
        static_cast<std::uint32_t>(std::max(kMaxVerticesPerDispatch / verticesOf(settings), 1));
    return std::max(std::min(accumulation.mostSamples(variant(), perThread), mostSamples), 1u);
}

// Brings the device up to what was set, and starts a new accumulation when anything changed.
Result<void> PathTracer::Impl::prepare() {
    if (!scene.scene().isComplete()) return nothingToTrace();
    if (!isStale()) return {};
    if (!scene.isCurrent()) {
        mostSamples = UINT32_MAX;
        restarting = false;
        looksOther();
    }
    search.reset();
    primarySamples = 0;
    const bool again = std::exchange(restarting, false);
    MACULA_TRY_VOID(
        scene.look(view, settings));  // first: a view that cannot be used must not enter the history
    if (usesIndirect()) MACULA_TRY_VOID(scene.scene().indirect().prepare(lightOfScene()));
    if (again) {
        history.restart();
    } else {
        const bool wasTraced = accumulation.plan().leastSamples() > 0;
        history.turnPage(view, settings.seed, wasTraced, scene.scene().lightFrame());
    }
    if (const Result<void> begun = accumulation.begin(view.width, view.height); !begun) {
        Error error = begun.error();
        if (error.code == ErrorCode::outOfMemory) error.hint = "Choose a smaller picture, or another device.";
        return error;
    }
    stale = false;
    return {};
}

Result<const gpu::Buffer*> PathTracer::Impl::denoised() {
    return history.denoised(accumulation.film(), accumulation.edition(), settings.denoising, scene, kernels);
}

// One dispatch of the pass under way, which takes about `ms`.
Result<void> PathTracer::Impl::step(double ms) {
    stale = true;  // stays so if this fails
    MACULA_TRY_VOID(accumulation.step(scene, kernels, variant(), settings.bounces, ms));
    stale = false;
    if (accumulation.plan().hasPass()) return {};
    MACULA_TRY(const bool tooLong, accumulation.hasLostPaths());
    if (!tooLong) return {};
    // Paths were lost to the device's limit: the picture begins again, with smaller portions.
    mostSamples = accumulation.plan().passMost() / 2;
    stale = true;
    restarting = true;
    return prepare();
}

void PathTracer::Impl::beginEvenPass(double samples) {
    const double most = mostPerDispatch();
    accumulation.plan().beginEven(static_cast<std::uint32_t>(std::clamp(samples, 1.0, most)));
}

Result<bool> PathTracer::trace(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    SamplingPlan& plan = t.accumulation.plan();
    if (plan.isAdaptive()) plan.dropPass();
    // A pass that was interrupted is part of what was asked for.
    const std::uint32_t underWay = plan.hasPass() ? plan.passMost() : 0;
    const std::uint32_t target = plan.leastSamples() + std::max(samplesPerPixel, underWay);
    while (!plan.hasAll(target)) {
        if (!plan.hasPass()) t.beginEvenPass(target - plan.leastSamples());
        MACULA_TRY_VOID(t.step(t.dispatchMs));
        if (keepGoing && !keepGoing()) break;
    }
    return !plan.hasPass();
}

Result<void> PathTracer::addPrimaries(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    MACULA_CHECK(samplesPerPixel >= 1 && samplesPerPixel <= shared::kPrimarySamples);
    Impl& t = *impl_;
    if (!isPathTraced(t.settings.look))
        return Error{ErrorCode::usage, "This look traces no paths.", {}, "Choose the cinematic look."};
    // Primary vertices are kept by sample index, so all pixels need the same samples.
    const SamplingPlan& plan = t.accumulation.plan();
    if (plan.hasPass() || plan.isAdaptive()) t.stale = true;
    MACULA_TRY_VOID(t.prepare());
    MACULA_TRY_VOID(t.accumulation.clearPrimaries());
    const std::uint32_t before = plan.leastSamples();
    t.tellsPrimaries = true;
    const Result<bool> traced = trace(samplesPerPixel, keepGoing);
    t.tellsPrimaries = false;
    if (!traced) return traced.error();
    if (!plan.hasAll(before + samplesPerPixel)) {
        t.stale = true;
        return Error{ErrorCode::cancelled, "Stopped.", {}, {}};
    }
    t.firstPrimary = before % shared::kPrimarySamples;
    t.primarySamples = samplesPerPixel;
    return {};
}

Result<std::vector<shared::PrimaryVertex>> PathTracer::tracePrimaries(
    std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    MACULA_TRY_VOID(addPrimaries(samplesPerPixel, keepGoing));
    MACULA_TRY(std::vector<shared::PrimaryVertex> found, impl_->accumulation.readPrimaries());
    const std::size_t pixels = found.size() / shared::kPrimarySamples;
    const std::size_t first = impl_->firstPrimary;
    std::rotate(found.begin(), found.begin() + std::ptrdiff_t(first * pixels), found.end());
    found.resize(samplesPerPixel * pixels);
    return found;
}

// Noise decides about the next pass, or about whether there is one.
bool PathTracer::Impl::needsEstimate() const {
    if (accumulation.plan().leastSamples() < kEvenSamples || accumulation.isMeasured()) return false;
    return isPathTraced(settings.look) || settings.errorThreshold > 0.0;
}

bool PathTracer::Impl::converged() const {
    const auto& estimate = accumulation.estimate();
    return estimate && isConverged(*estimate, settings.errorThreshold);
}

void PathTracer::Impl::beginPass(double leftMs) {
    SamplingPlan& plan = accumulation.plan();
    const std::uint32_t least = plan.leastSamples();
    if (least >= kEvenSamples && isPathTraced(settings.look)) {
        plan.beginAdaptive(accumulation.noises(), kGrowth * plan.meanSamples(), mostPerDispatch());
        return;
    }
    // As many samples of every pixel as fit the time that is left; the first picture comes soonest with one.
    const double fitting = least == 0 ? 1.0 : leftMs / accumulation.passMs(variant(), settings.bounces);
    beginEvenPass(least < kEvenSamples ? std::min(fitting, double(kEvenSamples - least)) : fitting);
}

// One dispatch of whatever comes next.
Result<void> PathTracer::Impl::stepFor(double leftMs) {
    if (!accumulation.plan().hasPass()) {
        if (needsEstimate()) return accumulation.measureSome(settings);
        beginPass(leftMs);
    }
    return step(std::clamp(leftMs, kLeastDispatchMs, dispatchMs));
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
    return !t.accumulation.plan().hasPass();
}

double PathTracer::meanSamples() const {
    return impl_->accumulation.plan().meanSamples();
}

Result<ErrorEstimate> PathTracer::estimateError() {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    while (!t.accumulation.isMeasured()) MACULA_TRY_VOID(t.accumulation.measureSome(t.settings));
    return *t.accumulation.estimate();
}

Result<TracedLight> PathTracer::light() {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    const Film& film = t.accumulation.film();
    TracedLight light{.values = &film.sums(), .counts = &film.counts(), .areMeans = isDenoised(t.settings)};
    if (light.areMeans) {
        MACULA_TRY(light.values, t.denoised());
    }
    return light;
}

Result<TracedLight> PathTracer::noisyLight() {
    MACULA_TRY(TracedLight light, this->light());
    MACULA_TRY(light.variances,
               light.areMeans ? impl_->history.variances() : impl_->variances.of(impl_->accumulation.film()));
    return light;
}

Result<const gpu::Image*> PathTracer::display(const glm::vec3& background, Smoothing smoothing) {
    Impl& t = *impl_;
    MACULA_TRY(const TracedLight shown, light());
    const Film& film = t.accumulation.film();
    MACULA_TRY(auto recorder, gpu::Recorder::create(t.device, "display"));
    const shared::DisplayPush push{.background = background,
                                   .exposure = static_cast<float>(t.settings.exposure),
                                   .smoothing = shown.areMeans ? 0 : static_cast<int>(smoothing),
                                   .denoised = shown.areMeans ? 1 : 0,
                                   .keepsHue = t.settings.toneMap == ToneMap::hue ? 1 : 0};
    recorder.dispatch(t.displayKernel,
                      {static_cast<std::uint32_t>(t.view.width), static_cast<std::uint32_t>(t.view.height)},
                      push, {*shown.values, *shown.counts, film.picture()});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &film.picture();
}

Result<std::vector<std::uint8_t>> PathTracer::readDisplay(const glm::vec3& background) {
    MACULA_TRY(const gpu::Image* picture, display(background));
    return gpu::read<std::uint8_t>(*picture);
}

Result<bool> PathTracer::develop(const std::function<bool()>& keepGoing) {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    if (!isDenoised(t.settings)) return true;
    return t.history.denoiseSome(t.accumulation.film(), t.accumulation.edition(), t.settings.denoising,
                                 t.scene, t.kernels, keepGoing);
}

Result<const Guides*> PathTracer::guides() {
    MACULA_TRY_VOID(impl_->prepare());
    MACULA_TRY_VOID(impl_->scene.scene().keepForGradients());
    MACULA_TRY_VOID(impl_->prepare());
    return impl_->history.guides(impl_->scene, impl_->kernels);
}

Result<std::vector<GuidePixel>> PathTracer::readGuides() {
    MACULA_TRY(const Guides* computed, guides());
    return computed->read();
}

Result<std::vector<shared::PixelLayers>> PathTracer::readLayers() {
    std::optional<gpu::Buffer> found;
    MACULA_TRY_VOID(findLayersIn(found));
    return gpu::read<shared::PixelLayers>(*found);
}

const std::shared_ptr<gpu::Device>& PathTracer::device() const {
    return impl_->device;
}

Result<void> PathTracer::findLayersIn(std::optional<gpu::Buffer>& layers) {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    MACULA_TRY(const gpu::Kernel* kernel, t.kernels.layers(kindOf(t.scene.scene())));
    return trace::findLayers(t.device, t.scene, *kernel, t.view.width, t.view.height, layers);
}

Result<std::optional<SurfacePoints>> PathTracer::someSurfacePoints(const SurfacePointOptions& options,
                                                                   const std::function<bool()>& keepGoing) {
    using Found = std::optional<SurfacePoints>;
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    const DeviceScene& scene = t.scene.scene();
    SceneKind kind = kindOf(scene);
    kind.greyFaces = scene.hasGreyFaces();
    if (!t.search) {
        MACULA_TRY(t.search, SurfacePointSearch::begin(t.scene, options));
    }
    while (!t.search->isDone()) {
        if (const Result<void> done = t.search->step(t.scene, t.kernels, kind); !done) {
            t.search.reset();
            return done.error();
        }
        if (keepGoing && !keepGoing()) break;
    }
    if (!t.search->isDone()) return Found();
    Found found(t.search->take());
    t.search.reset();
    return found;
}

Result<SurfacePoints> PathTracer::surfacePoints(const SurfacePointOptions& options,
                                                const std::function<bool()>& keepGoing) {
    impl_->search.reset();
    MACULA_TRY(std::optional<SurfacePoints> found, someSurfacePoints(options, keepGoing));
    impl_->search.reset();
    if (found) return *std::move(found);
    return Error{ErrorCode::cancelled, "The search for points on the surface was cancelled.", {}, {}};
}

Result<TracedImage> PathTracer::readback() {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    MACULA_TRY(const Guides* guides,
               t.history.guides(t.scene, t.kernels));  // only their depths are read, not their normals
    MACULA_TRY(const std::vector<GuidePixel> pixels, guides->read());
    const Film& film = t.accumulation.film();
    TracedImage image{.width = t.view.width,
                      .height = t.view.height,
                      .radiance = {},
                      .depthMm = {},
                      .variance = {},
                      .denoised = isDenoised(t.settings)};
    MACULA_TRY(image.radiance, gpu::read<glm::vec4>(film.sums()));
    MACULA_TRY(image.samples, gpu::read<std::uint32_t>(film.counts()));
    MACULA_TRY(const auto squares, gpu::read<glm::vec2>(film.squares()));
    image.depthMm.resize(pixels.size(), std::numeric_limits<float>::infinity());
    image.variance.resize(pixels.size(), glm::vec2(std::numeric_limits<float>::infinity()));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        image.variance[i] = varianceOfMean(image.radiance[i], squares[i].x, image.samples[i]);
        image.radiance[i] /= static_cast<float>(std::max(image.samples[i], 1u));
        if (pixels[i].depthMm >= 0.0f && !isProjection(t.settings.look)) image.depthMm[i] = pixels[i].depthMm;
    }
    if (image.denoised) {
        MACULA_TRY(const gpu::Buffer* filtered, t.denoised());
        MACULA_TRY(image.radiance, gpu::read<glm::vec4>(*filtered));
    }
    return image;
}

Result<TracedColours> PathTracer::readColours() {
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    if (!t.device->hasUnifiedMemory()) {
        ViewReading reading;  // one wait instead of three
        MACULA_TRY_VOID(beginReading(reading, {.colours = true}));
        MACULA_TRY_VOID(reading.finish());
        return reading.colours();
    }
    TracedColours colours{
        .width = t.view.width, .height = t.view.height, .radiance = {}, .samples = {}, .coverage = {}};
    colours.meanSamples = t.accumulation.plan().meanSamples();
    MACULA_TRY(const Guides* guides, t.history.guides(t.scene, t.kernels));
    MACULA_TRY(colours.coverage, guides->readCoverage());
    const Film& film = t.accumulation.film();
    MACULA_TRY(colours.samples, gpu::read<std::uint32_t>(film.counts()));
    if (isDenoised(t.settings)) {
        MACULA_TRY(const gpu::Buffer* filtered, t.denoised());
        MACULA_TRY(colours.radiance, gpu::read<glm::vec4>(*filtered));
        return colours;
    }
    MACULA_TRY(colours.radiance, gpu::read<glm::vec4>(film.sums()));
    for (std::size_t i = 0; i < colours.radiance.size(); ++i)
        colours.radiance[i] /= static_cast<float>(std::max(colours.samples[i], 1u));
    return colours;
}

Result<void> PathTracer::beginReading(ViewReading& reading, const WantedReading& wanted) {
    MACULA_CHECK(wanted.primaries || wanted.colours);
    Impl& t = *impl_;
    MACULA_TRY_VOID(t.prepare());
    if (wanted.primaries) MACULA_CHECK(t.firstPrimary == 0 && t.primarySamples > 0);
    reading.width_ = t.view.width;
    reading.height_ = t.view.height;
    reading.primarySamples_ = wanted.primaries ? t.primarySamples : 0;
    reading.areMeans_ = isDenoised(t.settings);
    reading.meanSamples_ = t.accumulation.plan().meanSamples();
    if (!wanted.colours) return reading.reading_.begin({&t.accumulation.primaries()});
    MACULA_TRY(const Guides* guides, t.history.guides(t.scene, t.kernels));
    const gpu::Buffer* matters = &guides->matters().buffer();
    const gpu::Buffer* counts = &t.accumulation.film().counts();
    const gpu::Buffer* light = &t.accumulation.film().sums();
    if (reading.areMeans_) {
        MACULA_TRY(light, t.denoised());
    }
    if (!wanted.primaries) return reading.reading_.begin({matters, counts, light});
    return reading.reading_.begin({&t.accumulation.primaries(), matters, counts, light});
}

std::vector<Message> PathTracer::messages() const {
    return impl_->scene.scene().messages();
}

Result<Statistics> PathTracer::statistics() const {
    const Impl& t = *impl_;
    Statistics statistics;
    statistics.voxels = t.scene.scene().voxelMemory();
    statistics.messages = messages();
    statistics.denoised = isDenoised(t.settings);
    if (t.isStale()) return statistics;
    const SamplingPlan& plan = t.accumulation.plan();
    statistics.samplesPerPixel = plan.leastSamples();
    statistics.meanSamplesPerPixel = plan.meanSamples();
    if (t.accumulation.estimate()) statistics.estimatedError = t.accumulation.estimate()->rms;
    statistics.converged = t.converged();
    statistics.deviceMs = t.accumulation.deviceMs();
    statistics.dispatches = t.accumulation.dispatches();
    if (statistics.meanSamplesPerPixel > 0.0) {
        MACULA_TRY(const Film::Faults faults, t.accumulation.film().faults());
        statistics.nonFiniteSamples = faults.nonFinite;
        statistics.abandonedSamples = faults.abandoned;
        statistics.collisionsAboveBound = faults.aboveBound;
    }
    return statistics;
}

}  // namespace macula::trace
