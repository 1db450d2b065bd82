#include "pipeline/trace/sampled_picture.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/check.h"
#include "pipeline/trace/device_scene.h"

namespace macula::trace {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLeastDispatchMs = 4.0;  // less is mostly overhead
// With several samples of a pixel in one thread a lane stays busy while its neighbours' paths are longer. The
// limit on all their vertices is explained at kMaxRounds in path_samples.glsl.
constexpr int kMaxVerticesPerDispatch = 64;
constexpr std::uint32_t kMaxRaysPerDispatch = 4;  // samples of a pixel, for cast rays
// An adaptive pass adds this fraction of the present samples: after it noise is measured again.
constexpr double kGrowth = 0.5;

}  // namespace

Error nothingToTrace() {
    return {ErrorCode::usage, Text("There is nothing to trace yet."), {}, Text("Open a study first.")};
}

// The light that arrives from each point has changed, so that the history is void too.
void SampledPicture::looksOther() {
    history_.forget();
    stale_ = true;
}

Result<void> SampledPicture::setSettings(const Settings& settings) {
    const Settings before = std::exchange(settings_, settings);
    // Samples stay valid if only the denoising or the error threshold differs. Setting equal settings again
    // starts the picture over.
    Settings sameSamples = before;
    sameSamples.denoising = settings.denoising;
    sameSamples.errorThreshold = settings.errorThreshold;
    if (settings != sameSamples || settings == before) stale_ = true;
    // If only these differ as well, the light that arrives from each point stays the same, and so the history
    // valid. But grey faces emit other light for each exposure and tone map, so that they look the same.
    Settings sameLight = sameSamples;
    sameLight.seed = settings.seed;
    sameLight.indirect = settings.indirect;
    if (!scene_.scene().hasGreyFaces()) {
        sameLight.exposure = settings.exposure;
        sameLight.toneMap = settings.toneMap;
    }
    if (settings != sameLight) looksOther();
    return isDenoised(settings) && scene_.scene().isComplete() ? scene_.scene().keepForGradients()
                                                               : Result<void>();
}

void SampledPicture::setView(const View& view) {
    view_ = view;
    stale_ = true;
}

void SampledPicture::setDispatchMs(double ms) {
    dispatchMs_ = std::max(ms, kLeastDispatchMs);
}

void SampledPicture::setSideBySide(std::uint32_t samples) {
    accumulation_.sideBySide().force(samples);
    stale_ = true;
}

// Whether paths use the cache of indirect light.
bool SampledPicture::usesIndirect() const {
    if (settings_.indirect == Indirect::traced || !isPathTraced(settings_.look)) return false;
    if (verticesOf(settings_) < 2 || scene_.scene().lightFrame() == LightFrame::camera) return false;
    if (scene_.scene().hasSurfaces()) return false;
    return settings_.indirect == Indirect::corrected || scene_.scene().anisotropy() == 0.0;
}

LightOfScene SampledPicture::lightOfScene() const {
    return {.sceneEdition = scene_.scene().edition(),
            .bounces = settings_.bounces,
            .strength = settings_.lightStrength,
            .rotationDeg = settings_.lightRotationDeg,
            .exposure = scene_.scene().hasGreyFaces() ? settings_.exposure : 1.0,
            .toneMap = scene_.scene().hasGreyFaces() ? settings_.toneMap : ToneMap::neutral};
}

TraceVariant SampledPicture::variant() const {
    TraceVariant variant = variantOf(settings_, kindOf(scene_.scene()));
    variant.tellsPrimaries = tellsPrimaries_;
    variant.usesIndirect = usesIndirect();
    variant.isSideBySide = isPathTraced(settings_.look) && !tellsPrimaries_ && accumulation_.isSideBySide();
    return variant;
}

std::uint32_t SampledPicture::mostPerDispatch() const {
    if (!isPathTraced(settings_.look)) return std::max(std::min(kMaxRaysPerDispatch, mostSamples_), 1u);
    const auto perThread =
        static_cast<std::uint32_t>(std::max(kMaxVerticesPerDispatch / verticesOf(settings_), 1));
    return std::max(std::min(accumulation_.mostSamples(variant(), perThread), mostSamples_), 1u);
}

Result<void> SampledPicture::prepare() {
    if (!scene_.scene().isComplete()) return nothingToTrace();
    if (!isStale()) return {};
    if (!scene_.isCurrent()) {
        mostSamples_ = UINT32_MAX;
        restarting_ = false;
        looksOther();
    }
    search_.reset();
    primarySamples_ = 0;
    const bool again = std::exchange(restarting_, false);
    MACULA_TRY_VOID(
        scene_.look(view_, settings_));  // first: a view that cannot be used must not enter the history
    if (usesIndirect()) MACULA_TRY_VOID(scene_.scene().indirect().prepare(lightOfScene()));
    if (again) {
        history_.restart();
    } else {
        const bool wasTraced = accumulation_.plan().leastSamples() > 0;
        history_.turnPage(view_, settings_.seed, wasTraced, scene_.scene().lightFrame());
    }
    if (const Result<void> begun = accumulation_.begin(view_.width, view_.height); !begun) {
        Error error = begun.error();
        if (error.code == ErrorCode::outOfMemory)
            error.hint = Text("Choose a smaller picture, or another device.");
        return error;
    }
    stale_ = false;
    return {};
}

Result<const gpu::Buffer*> SampledPicture::denoised() {
    return history_.denoised(accumulation_.film(), accumulation_.edition(), settings_.denoising, scene_,
                             kernels_);
}

// One dispatch of the pass under way, which takes about `ms`.
Result<void> SampledPicture::step(double ms) {
    stale_ = true;  // stays so if this fails
    MACULA_TRY_VOID(accumulation_.step(scene_, kernels_, variant(), settings_.bounces, ms));
    stale_ = false;
    if (accumulation_.plan().hasPass()) return {};
    MACULA_TRY(const bool tooLong, accumulation_.hasLostPaths());
    if (!tooLong) return {};
    // The device's limit on rounds cut off paths: the picture starts over, with smaller portions.
    mostSamples_ = accumulation_.plan().passMost() / 2;
    stale_ = true;
    restarting_ = true;
    return prepare();
}

void SampledPicture::beginEvenPass(double samples) {
    const double most = mostPerDispatch();
    accumulation_.plan().beginEven(static_cast<std::uint32_t>(std::clamp(samples, 1.0, most)));
}

Result<bool> SampledPicture::trace(std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    MACULA_TRY_VOID(prepare());
    SamplingPlan& plan = accumulation_.plan();
    if (plan.isAdaptive()) plan.dropPass();
    // The samples of an interrupted pass count towards this call's.
    const std::uint32_t underWay = plan.hasPass() ? plan.passMost() : 0;
    const std::uint32_t target = plan.leastSamples() + std::max(samplesPerPixel, underWay);
    while (!plan.hasAll(target)) {
        if (!plan.hasPass()) beginEvenPass(target - plan.leastSamples());
        MACULA_TRY_VOID(step(dispatchMs_));
        if (keepGoing && !keepGoing()) break;
    }
    return !plan.hasPass();
}

Result<void> SampledPicture::addPrimaries(std::uint32_t samplesPerPixel,
                                          const std::function<bool()>& keepGoing) {
    MACULA_CHECK(samplesPerPixel >= 1 && samplesPerPixel <= shared::kPrimarySamples);
    if (!isPathTraced(settings_.look))
        return Error{
            ErrorCode::usage, Text("This look traces no paths."), {}, Text("Choose the cinematic look.")};
    // Primary vertices are kept by sample index, so all pixels need the same samples.
    const SamplingPlan& plan = accumulation_.plan();
    if (plan.hasPass() || plan.isAdaptive()) stale_ = true;
    MACULA_TRY_VOID(prepare());
    MACULA_TRY_VOID(accumulation_.clearPrimaries());
    const std::uint32_t before = plan.leastSamples();
    tellsPrimaries_ = true;
    const Result<bool> traced = trace(samplesPerPixel, keepGoing);
    tellsPrimaries_ = false;
    if (!traced) return traced.error();
    if (!plan.hasAll(before + samplesPerPixel)) {
        stale_ = true;
        return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
    }
    firstPrimary_ = before % shared::kPrimarySamples;
    primarySamples_ = samplesPerPixel;
    return {};
}

Result<std::vector<shared::PrimaryVertex>> SampledPicture::tracePrimaries(
    std::uint32_t samplesPerPixel, const std::function<bool()>& keepGoing) {
    MACULA_TRY_VOID(addPrimaries(samplesPerPixel, keepGoing));
    MACULA_TRY(std::vector<shared::PrimaryVertex> found, accumulation_.readPrimaries());
    const std::size_t pixels = found.size() / shared::kPrimarySamples;
    const std::size_t first = firstPrimary_;
    std::rotate(found.begin(), found.begin() + std::ptrdiff_t(first * pixels), found.end());
    found.resize(samplesPerPixel * pixels);
    return found;
}

// Whether the next pass, or whether there is one, depends on noise that is not measured yet.
bool SampledPicture::needsEstimate() const {
    if (accumulation_.plan().leastSamples() < kEvenSamples || accumulation_.isMeasured()) return false;
    return isPathTraced(settings_.look) || settings_.errorThreshold > 0.0;
}

bool SampledPicture::converged() const {
    const auto& estimate = accumulation_.estimate();
    return estimate && isConverged(*estimate, settings_.errorThreshold);
}

void SampledPicture::beginPass(double leftMs) {
    SamplingPlan& plan = accumulation_.plan();
    const std::uint32_t least = plan.leastSamples();
    if (least >= kEvenSamples && isPathTraced(settings_.look)) {
        plan.beginAdaptive(accumulation_.noises(), kGrowth * plan.meanSamples(), mostPerDispatch());
        return;
    }
    // As many samples of every pixel as fit the time that is left; only one at first, for an early first
    // picture.
    const double fitting = least == 0 ? 1.0 : leftMs / accumulation_.passMs(variant(), settings_.bounces);
    beginEvenPass(least < kEvenSamples ? std::min(fitting, double(kEvenSamples - least)) : fitting);
}

// One dispatch of whatever comes next.
Result<void> SampledPicture::stepFor(double leftMs) {
    if (!accumulation_.plan().hasPass()) {
        if (needsEstimate()) return accumulation_.measureSome(settings_);
        beginPass(leftMs);
    }
    return step(std::clamp(leftMs, kLeastDispatchMs, dispatchMs_));
}

Result<bool> SampledPicture::traceFor(double budgetMs, const std::function<bool()>& keepGoing) {
    const Clock::time_point start = Clock::now();
    MACULA_TRY_VOID(prepare());
    for (bool first = true; !converged(); first = false) {
        const double leftMs =
            budgetMs - std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        if (leftMs < kLeastDispatchMs && !first) break;
        MACULA_TRY_VOID(stepFor(leftMs));
        if (keepGoing && !keepGoing()) break;
    }
    return !accumulation_.plan().hasPass();
}

Result<ErrorEstimate> SampledPicture::estimateError() {
    MACULA_TRY_VOID(prepare());
    while (!accumulation_.isMeasured()) MACULA_TRY_VOID(accumulation_.measureSome(settings_));
    return *accumulation_.estimate();
}

Result<bool> SampledPicture::develop(const std::function<bool()>& keepGoing) {
    MACULA_TRY_VOID(prepare());
    if (!isDenoised(settings_)) return true;
    return history_.denoiseSome(accumulation_.film(), accumulation_.edition(), settings_.denoising, scene_,
                                kernels_, keepGoing);
}

Result<TracedLight> SampledPicture::light() {
    MACULA_TRY_VOID(prepare());
    const Film& film = accumulation_.film();
    TracedLight light{.values = &film.sums(), .counts = &film.counts(), .areMeans = isDenoised(settings_)};
    if (light.areMeans) {
        MACULA_TRY(light.values, denoised());
    }
    return light;
}

Result<TracedLight> SampledPicture::noisyLight() {
    MACULA_TRY(TracedLight light, this->light());
    MACULA_TRY(light.variances, light.areMeans ? history_.variances() : variances_.of(accumulation_.film()));
    return light;
}

}  // namespace macula::trace
