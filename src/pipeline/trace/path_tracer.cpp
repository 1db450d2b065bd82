#include "pipeline/trace/path_tracer.h"

#include <utility>

#include "base/check.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/film.h"
#include "pipeline/trace/picture_readback.h"
#include "pipeline/trace/pixel_layers.h"
#include "pipeline/trace/sampled_picture.h"
#include "shaders/trace.h"
#include "shared/trace_params.h"

namespace macula::trace {

struct PathTracer::Impl {
    Impl(SceneView scene, gpu::Kernel d) : picture(std::move(scene)), display(std::move(d)) {}

    SampledPicture picture;
    gpu::Kernel display;
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
    return of(impl_->picture.scene().shared());
}

DeviceScene& PathTracer::scene() {
    return impl_->picture.scene().scene();
}

const DeviceScene& PathTracer::scene() const {
    return impl_->picture.scene().scene();
}

Result<Box> PathTracer::seenMm() {
    MACULA_TRY_VOID(impl_->picture.prepare());
    if (isProjection(impl_->picture.settings().look))
        return Error{
            ErrorCode::usage, Text("Projections show all of the volume."), {}, Text("Choose another look.")};
    return impl_->picture.scene().scene().seenMm();
}

Result<std::vector<glm::dvec3>> PathTracer::outlineMm() const {
    const DeviceScene& scene = impl_->picture.scene().scene();
    if (!scene.isComplete()) return nothingToTrace();
    return scene.outlineMm();
}

Result<void> PathTracer::setSettings(const Settings& settings) {
    return impl_->picture.setSettings(settings);
}

Result<void> PathTracer::setView(const View& view) {
    impl_->picture.setView(view);
    return {};
}

void PathTracer::setDispatchMs(double ms) {
    impl_->picture.setDispatchMs(ms);
}

void PathTracer::setSideBySide(std::uint32_t samples) {
    impl_->picture.setSideBySide(samples);
}

void PathTracer::forgetViews() {
    impl_->picture.forgetViews();
}

Result<bool> PathTracer::trace(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    return impl_->picture.trace(samplesPerPixel, keepGoing);
}

Result<bool> PathTracer::traceFor(double budgetMs, const std::function<bool()>& keepGoing) {
    return impl_->picture.traceFor(budgetMs, keepGoing);
}

Result<void> PathTracer::addPrimaries(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    return impl_->picture.addPrimaries(samplesPerPixel, keepGoing);
}

Result<std::vector<shared::PrimaryVertex>> PathTracer::tracePrimaries(
    std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    return impl_->picture.tracePrimaries(samplesPerPixel, keepGoing);
}

double PathTracer::meanSamples() const {
    return impl_->picture.accumulation().plan().meanSamples();
}

Result<ErrorEstimate> PathTracer::estimateError() {
    return impl_->picture.estimateError();
}

Result<TracedLight> PathTracer::light() {
    return impl_->picture.light();
}

Result<TracedLight> PathTracer::noisyLight() {
    return impl_->picture.noisyLight();
}

Result<const gpu::Image*> PathTracer::display(const glm::vec3& background, Smoothing smoothing) {
    SampledPicture& picture = impl_->picture;
    MACULA_TRY(const TracedLight shown, light());
    const Film& film = picture.accumulation().film();
    MACULA_TRY(auto recorder, gpu::Recorder::create(picture.device(), "display"));
    const shared::DisplayPush push{.background = background,
                                   .exposure = static_cast<float>(picture.settings().exposure),
                                   .smoothing = shown.areMeans ? 0 : static_cast<int>(smoothing),
                                   .denoised = shown.areMeans ? 1 : 0,
                                   .keepsHue = picture.settings().toneMap == ToneMap::hue ? 1 : 0};
    recorder.dispatch(
        impl_->display,
        {static_cast<std::uint32_t>(picture.view().width), static_cast<std::uint32_t>(picture.view().height)},
        push, {*shown.values, *shown.counts, film.picture()});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &film.picture();
}

Result<std::vector<std::uint8_t>> PathTracer::readDisplay(const glm::vec3& background) {
    MACULA_TRY(const gpu::Image* picture, display(background));
    return gpu::read<std::uint8_t>(*picture);
}

Result<bool> PathTracer::develop(const std::function<bool()>& keepGoing) {
    return impl_->picture.develop(keepGoing);
}

Result<const Guides*> PathTracer::guides() {
    MACULA_TRY_VOID(impl_->picture.prepare());
    MACULA_TRY_VOID(impl_->picture.scene().scene().keepForGradients());
    MACULA_TRY_VOID(impl_->picture.prepare());
    return impl_->picture.guides();
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
    return impl_->picture.device();
}

Result<void> PathTracer::findLayersIn(std::optional<gpu::Buffer>& layers) {
    SampledPicture& picture = impl_->picture;
    MACULA_TRY_VOID(picture.prepare());
    MACULA_TRY(const gpu::Kernel* kernel, picture.kernels().layers(kindOf(picture.scene().scene())));
    return trace::findLayers(picture.device(), picture.scene(), *kernel, picture.view().width,
                             picture.view().height, layers);
}

Result<std::optional<SurfacePoints>> PathTracer::someSurfacePoints(const SurfacePointOptions& options,
                                                                   const std::function<bool()>& keepGoing) {
    using Found = std::optional<SurfacePoints>;
    SampledPicture& picture = impl_->picture;
    MACULA_TRY_VOID(picture.prepare());
    const DeviceScene& scene = picture.scene().scene();
    SceneKind kind = kindOf(scene);
    kind.greyFaces = scene.hasGreyFaces();
    if (!picture.search()) {
        MACULA_TRY(picture.search(), SurfacePointSearch::begin(picture.scene(), options));
    }
    while (!picture.search()->isDone()) {
        if (const Result<void> done = picture.search()->step(picture.scene(), picture.kernels(), kind);
            !done) {
            picture.search().reset();
            return done.error();
        }
        if (keepGoing && !keepGoing()) break;
    }
    if (!picture.search()->isDone()) return Found();
    Found found(picture.search()->take());
    picture.search().reset();
    return found;
}

Result<SurfacePoints> PathTracer::surfacePoints(const SurfacePointOptions& options,
                                                const std::function<bool()>& keepGoing) {
    impl_->picture.search().reset();
    MACULA_TRY(std::optional<SurfacePoints> found, someSurfacePoints(options, keepGoing));
    impl_->picture.search().reset();
    if (found) return *std::move(found);
    return Error{ErrorCode::cancelled, Text("The search for points on the surface was cancelled."), {}, {}};
}

Result<TracedImage> PathTracer::readback() {
    return readImage(impl_->picture);
}

Result<TracedColours> PathTracer::readColours() {
    return trace::readColours(impl_->picture);
}

Result<void> PathTracer::beginReading(ViewReading& reading, const WantedReading& wanted) {
    return trace::beginReading(impl_->picture, reading, wanted);
}

std::vector<Message> PathTracer::messages() const {
    return impl_->picture.scene().scene().messages();
}

Result<Statistics> PathTracer::statistics() const {
    const SampledPicture& picture = impl_->picture;
    Statistics statistics;
    statistics.voxels = picture.scene().scene().voxelMemory();
    statistics.messages = messages();
    statistics.denoised = isDenoised(picture.settings());
    if (picture.isStale()) return statistics;
    const SamplingPlan& plan = picture.accumulation().plan();
    statistics.samplesPerPixel = plan.leastSamples();
    statistics.meanSamplesPerPixel = plan.meanSamples();
    if (picture.accumulation().estimate()) statistics.estimatedError = picture.accumulation().estimate()->rms;
    statistics.converged = picture.converged();
    statistics.deviceMs = picture.accumulation().deviceMs();
    statistics.dispatches = picture.accumulation().dispatches();
    if (statistics.meanSamplesPerPixel > 0.0) {
        MACULA_TRY(const Film::Faults faults, picture.accumulation().film().faults());
        statistics.nonFiniteSamples = faults.nonFinite;
        statistics.abandonedSamples = faults.abandoned;
        statistics.collisionsAboveBound = faults.aboveBound;
    }
    return statistics;
}

}  // namespace macula::trace
