#include "pictures/drawn_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include "base/elapsed.h"
#include "pictures/covering_picture.h"
#include "pictures/fitted_view.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/scene.h"
#include "pipeline/trace/shown_colours.h"
#include "scene/drawing/nothing_visible.h"
#include "scene/lights/light_meter.h"

namespace macula::pictures {

namespace {

const glm::vec3 kWhite(1.0f);

using Rgba = std::vector<std::uint8_t>;

// The display values that the request wants; `over` draws the picture over a background.
Result<Rgba> rgbaOf(const PictureRequest& request,
                    const std::function<Result<Rgba>(const glm::vec3&)>& over) {
    if (!request.isTransparent) return over(scene::lightOf(request.background));
    MACULA_TRY(const Rgba overBlack, over(scene::lightOf(scene::kBlackBackground)));
    MACULA_TRY(const Rgba overWhite, over(kWhite));
    return coveringPicture(overBlack, overWhite);
}

// The size of a picture of the same shape whose longer side has at most so many pixels.
glm::ivec2 smallSize(const glm::dvec2& size, double longerSidePx) {
    return glm::max(glm::ivec2(glm::round(size * std::min(1.0, longerSidePx / std::max(size.x, size.y)))),
                    glm::ivec2(1));
}

Result<Camera> cameraOf(const PictureRequest& request, const trace::PathTracer& tracer) {
    MACULA_TRY(std::vector<glm::dvec3> outline, tracer.outlineMm());
    return fittedCamera(std::move(outline), request.settings.look, *request.scene.volume,
                        {.from = request.from,
                         .verticalFovDeg = request.verticalFovDeg,
                         .isParallel = request.isParallel,
                         .aspectWidthOverHeight = double(request.sizePx.x) / request.sizePx.y});
}

Result<void> traceAll(trace::PathTracer& tracer, std::uint32_t samplesPerPixel, Progress& progress) {
    // One pass has all samples: the tracer calls `tell` between its dispatches, and lanes wait less for one
    // another in a long pass.
    progress.beginStage(Text("Tracing"), samplesPerPixel);
    std::size_t told = 0;
    const auto tell = [&] {
        const auto done = static_cast<std::size_t>(tracer.meanSamples() + 1e-6);
        if (done > told) progress.advance(done - std::exchange(told, done));
        return !progress.cancelled();
    };
    MACULA_TRY(const bool whole, tracer.trace(samplesPerPixel, tell));
    if (!whole || progress.cancelled()) return stopped();
    return {};
}

// Traces until the picture has converged, with more samples where there is more noise. A picture that is
// stopped is kept if the request says so.
Result<void> traceUntilConverged(trace::PathTracer& tracer, const PictureRequest& request,
                                 Progress& progress) {
    constexpr double kPortionMs = 200.0;
    constexpr std::size_t kSteps = 1000;
    progress.beginStage(Text("Tracing until the noise is gone"), kSteps);
    std::size_t shown = 0;
    for (;;) {
        MACULA_TRY_VOID(tracer.traceFor(kPortionMs, [&] { return !progress.cancelled(); }));
        MACULA_TRY(const trace::Statistics statistics, tracer.statistics());
        if (statistics.converged) return {};
        if (progress.cancelled() && (!request.keepUnfinished || statistics.samplesPerPixel == 0))
            return stopped();
        if (progress.cancelled() || statistics.meanSamplesPerPixel >= request.samplesPerPixel) break;
        // Noise falls with the root of the samples.
        const double left = statistics.estimatedError / request.settings.errorThreshold;
        const auto done = static_cast<std::size_t>(double(kSteps) / std::max(left * left, 1.0));
        if (done > shown) progress.advance(done - std::exchange(shown, done));
    }
    return {};
}

}  // namespace

Error stopped() {
    return {ErrorCode::cancelled, Text("Stopped; nothing was written."), {}, {}};
}

Result<PictureDrawer> PictureDrawer::create(const std::shared_ptr<gpu::Device>& device,
                                            const PictureRequest& request, const Progress& progress) {
    const live::StudyScene& scene = request.scene;
    // Whoever cancels waits for one step at most: compiling kernels or uploading bricks may take a second.
    if (progress.cancelled()) return stopped();
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device, request.memory));
    if (progress.cancelled()) return stopped();
    MACULA_TRY_VOID(tracer.scene().setVolume(scene.volume));
    if (progress.cancelled()) return stopped();
    MACULA_TRY_VOID(tracer.scene().setClip(scene.clip));  // first: what it hides is not uploaded
    MACULA_TRY_VOID(tracer.scene().setAdditions(scene.additions));
    MACULA_TRY_VOID(tracer.scene().setTransferFunction(scene.function));
    MACULA_TRY_VOID(tracer.scene().setEnvironment(scene.environment));
    MACULA_TRY_VOID(tracer.setSettings(request.settings));
    return PictureDrawer(device, request, std::move(tracer));
}

Result<void> PictureDrawer::change(const PictureRequest& request, const Progress& progress) {
    const live::StudyScene before = std::exchange(request_, request).scene;
    const live::StudyScene& scene = request_.scene;
    const auto bring = [&](bool isSame, auto&& set) -> Result<void> {
        if (isSame) return {};
        if (progress.cancelled()) return stopped();
        return set();
    };
    MACULA_TRY_VOID(bring(scene.clip == before.clip, [&] { return tracer_.scene().setClip(scene.clip); }));
    MACULA_TRY_VOID(bring(scene.additions == before.additions,
                          [&] { return tracer_.scene().setAdditions(scene.additions); }));
    MACULA_TRY_VOID(bring(scene.function == before.function,
                          [&] { return tracer_.scene().setTransferFunction(scene.function); }));
    MACULA_TRY_VOID(bring(scene.environment == before.environment,
                          [&] { return tracer_.scene().setEnvironment(scene.environment); }));
    return tracer_.setSettings(request_.settings);
}

Result<void> PictureDrawer::adapt(std::optional<PictureDrawer>& kept,
                                  const std::shared_ptr<gpu::Device>& device, const PictureRequest& request,
                                  const Progress& progress) {
    if (kept && kept->device_ == device && kept->request_.scene.volume == request.scene.volume &&
        kept->request_.memory == request.memory) {
        if (Result<void> changed = kept->change(request, progress); !changed) {
            kept.reset();
            return changed;
        }
        // If the device lacks memory for all voxels, those of the previous picture may keep it from the
        // others.
        if (kept->tracer_.messages().empty()) return {};
    }
    kept.reset();  // first: the device may have no room for both
    MACULA_TRY(kept, create(device, request, progress));
    return {};
}

Result<DrawnPicture> PictureDrawer::draw(const std::optional<Camera>& camera, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    DrawnPicture drawn{.device = gpu::describe(device_->info())};
    if (camera) {
        drawn.camera = *camera;
    } else {
        MACULA_TRY(drawn.camera, cameraOf(request_, tracer_));
    }
    const Camera asked = drawn.camera;
    drawn.camera = standingBefore(asked, request_.scene.volume->worldBox());
    drawn.exposure = request_.settings.exposure;
    if (request_.metersExposure && !trace::isProjection(request_.settings.look)) {
        MACULA_TRY(drawn.exposure, meterExposure(drawn.camera, progress));
        trace::Settings exposed = request_.settings;
        exposed.exposure = drawn.exposure;
        MACULA_TRY_VOID(tracer_.setSettings(exposed));
    }
    MACULA_TRY(const trace::Lens lens, lensFor(asked, drawn.camera));
    drawn.focusMm = lens.focusMm;
    tracer_.forgetViews();
    MACULA_TRY_VOID(tracer_.setView(
        {.camera = drawn.camera, .width = request_.sizePx.x, .height = request_.sizePx.y, .lens = lens}));
    // Before tracing, because reading guides may upload voxels, which restarts the picture.
    std::vector<float> distancesMm;
    if (request_.effects.fogMm > 0.0 && !trace::isProjection(request_.settings.look)) {
        MACULA_TRY(const std::vector<trace::GuidePixel> guides, tracer_.readGuides());
        distancesMm = matterMm(guides);
    }
    MACULA_TRY_VOID(request_.settings.errorThreshold > 0.0
                        ? traceUntilConverged(tracer_, request_, progress)
                        : traceAll(tracer_, request_.samplesPerPixel, progress));
    drawn.seconds = secondsSince(start);
    MACULA_TRY_VOID(tracer_.estimateError());
    MACULA_TRY(drawn.statistics, tracer_.statistics());
    MACULA_TRY_VOID(read(drawn, distancesMm));
    return drawn;
}

Result<trace::Lens> PictureDrawer::lensFor(const Camera& asked, const Camera& standing) {
    constexpr int kLongerSidePx = 256;
    const PictureEffects& effects = request_.effects;
    if (!(effects.lensMm > 0.0) || !trace::isPathTraced(request_.settings.look)) return trace::Lens{};
    trace::Lens lens{.diameterMm = effects.lensMm};
    if (effects.focusMm) {
        MACULA_TRY(const CameraBasis axes, basis(standing));
        lens.focusMm = *effects.focusMm + glm::dot(asked.positionMm - standing.positionMm, axes.forward);
        return lens;
    }
    const glm::ivec2 small = smallSize(request_.sizePx, kLongerSidePx);
    tracer_.forgetViews();
    MACULA_TRY_VOID(tracer_.setView({.camera = standing, .width = small.x, .height = small.y}));
    MACULA_TRY(const std::vector<trace::GuidePixel> guides, tracer_.readGuides());
    MACULA_TRY(lens.focusMm, focusOfMiddle(guides, small, standing));
    return lens;
}

Result<void> PictureDrawer::read(DrawnPicture& drawn, const std::vector<float>& distancesMm) {
    if (!request_.isLinear && distancesMm.empty()) {
        MACULA_TRY(drawn.rgba, rgbaOf(request_, [&](const glm::vec3& background) {
                       return tracer_.readDisplay(background);
                   }));
        return {};
    }
    MACULA_TRY(trace::TracedImage traced, tracer_.readback());
    if (!distancesMm.empty()) addFog(traced.radiance, distancesMm, request_.effects.fogMm);
    if (request_.isLinear) {
        drawn.traced = std::move(traced);
        return {};
    }
    trace::Settings settings = request_.settings;
    settings.exposure = drawn.exposure;
    MACULA_TRY(drawn.rgba, rgbaOf(request_, [&](const glm::vec3& background) -> Result<Rgba> {
                   return trace::shownColours(traced.radiance, background, settings);
               }));
    return {};
}

Result<double> PictureDrawer::meterExposure(const Camera& camera, const Progress& progress) {
    if (!request_.scene.clip.greyFaces) return meter(camera, progress);
    Clip withoutFaces = request_.scene.clip;
    withoutFaces.greyFaces.reset();
    MACULA_TRY_VOID(tracer_.scene().setClip(withoutFaces));
    Result<double> exposure = meter(camera, progress);
    MACULA_TRY_VOID(tracer_.scene().setClip(request_.scene.clip));
    return exposure;
}

Result<double> PictureDrawer::meter(const Camera& camera, const Progress& progress) {
    constexpr int kLongerSidePx = 128;
    constexpr std::uint32_t kSamples = 16;
    trace::Settings settings = request_.settings;
    settings.exposure = 1.0;
    settings.errorThreshold = 0.0;
    settings.denoising = trace::Denoising::on;  // noise would count as light
    MACULA_TRY_VOID(tracer_.setSettings(settings));
    tracer_.forgetViews();
    const glm::ivec2 small = smallSize(request_.sizePx, kLongerSidePx);
    MACULA_TRY_VOID(tracer_.setView({.camera = camera, .width = small.x, .height = small.y}));
    MACULA_TRY(const bool whole, tracer_.trace(kSamples, [&] { return !progress.cancelled(); }));
    if (!whole || progress.cancelled()) return stopped();
    MACULA_TRY(const trace::TracedImage picture, tracer_.readback());
    return scene::meteredExposure(picture.radiance).value_or(1.0);
}

Result<DrawnPicture> drawPicture(const std::shared_ptr<gpu::Device>& device, const PictureRequest& request,
                                 Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY(PictureDrawer drawer, PictureDrawer::create(device, request, progress));
    MACULA_TRY(DrawnPicture drawn, drawer.draw(request.camera, progress));
    drawn.seconds = secondsSince(start);  // includes the uploads
    return drawn;
}

bool isEmpty(const DrawnPicture& drawn, const PictureRequest& request) {
    if (drawn.traced)
        return std::all_of(drawn.traced->radiance.begin(), drawn.traced->radiance.end(),
                           [](const glm::vec4& pixel) { return pixel.w <= 0.0f; });
    const scene::BackgroundColour& behind = request.background;
    for (std::size_t i = 0; i + 3 < drawn.rgba.size(); i += 4) {
        const std::uint8_t* const pixel = drawn.rgba.data() + i;
        const bool isBare = request.isTransparent
                                ? pixel[3] == 0
                                : pixel[0] == behind.r && pixel[1] == behind.g && pixel[2] == behind.b;
        if (!isBare) return false;
    }
    return true;
}

std::vector<PictureNote> notesOf(const DrawnPicture& drawn, const PictureRequest& request) {
    const trace::Statistics& statistics = drawn.statistics;
    std::vector<PictureNote> notes;
    if (request.settings.errorThreshold > 0.0 && !statistics.converged)
        notes.push_back({Text("The picture is noisier than its limit of noise.")});
    if (isEmpty(drawn, request)) {
        // A projection has no preset: it is black where values lie below its window.
        const auto& window = request.settings.window;
        const bool isSeenThroughWindow = trace::isProjection(request.settings.look) && window.has_value();
        notes.push_back({.sentence = isSeenThroughWindow
                                         ? scene::whyNothingIsVisible(*request.scene.volume, *window)
                                         : scene::whyNothingIsVisible(*request.scene.volume),
                         .isWarning = true});
    }
    for (const Message& message : statistics.messages) notes.push_back({message.sentence, message.action});
    if (statistics.nonFiniteSamples > 0)
        notes.push_back({Text("{} samples were not finite and were dropped; please report this.",
                              statistics.nonFiniteSamples)});
    if (statistics.abandonedSamples > 0)
        notes.push_back({Text("{} light paths were too long for the device and were dropped.",
                              statistics.abandonedSamples)});
    if (statistics.collisionsAboveBound > 0)
        notes.push_back(
            {Text("Light met matter {} times that was denser than its bound, and passed too easily; "
                  "please report this.",
                  statistics.collisionsAboveBound)});
    return notes;
}

}  // namespace macula::pictures
