#include "live/frame/traced_pictures.h"

#include <algorithm>
#include <utility>

#include "base/log.h"

namespace macula::live {

namespace {

using std::chrono::milliseconds;

double millisecondsSince(std::chrono::steady_clock::time_point from) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count();
}

constexpr double kPreviewBudgetMs =
    100.0;  // 10 pictures a second; 5 are still left on a machine half as fast
constexpr double kNsPerPixelGuessCpu = 4000.0;
constexpr double kNsPerPixelGuessGpu = 50.0;
// Bounces of light in small pictures. With fewer, bone turns from ivory to grey: its colour is made by many
// bounces, and the picture would change its look each time a hand lets go.
constexpr int kPreviewBounces = trace::kDefaultBounces;
// Samples of each pixel before a small picture is shown. One is enough with denoising, which reuses earlier
// pictures: more pixels are better than a second sample. Without denoising one would be a cloud of dots.
constexpr std::uint32_t kPreviewSamples = 1;
constexpr std::uint32_t kPlainPreviewSamples = 2;
constexpr trace::Smoothing kPlainPreviewSmoothing = trace::Smoothing::slight;
constexpr std::uint64_t kPreviewSampleLimit = 64;  // while a hand holds still
// Cast rays have no noise: more samples only make edges smoother. As many as `macula render` takes.
constexpr std::uint64_t kCastSampleLimit = 8;
// Samples of each pixel before the full picture is first shown, denoised (filter_course.h).
constexpr std::uint64_t kFirstDenoised = 2;
// The same without denoising, for lack of memory: fewer samples would be a cloud of dots.
constexpr std::uint64_t kFirstPlain = 4;

bool hasNoise(const FrameInput& input) {
    return trace::isPathTraced(input.drawing.settings.look);
}

trace::Settings denoised(trace::Settings settings, bool isDenoised) {
    settings.denoising = isDenoised ? trace::Denoising::on : trace::Denoising::off;
    return settings;
}

// The noise target does not change what is drawn.
bool sameDrawing(const scene::Drawing& a, scene::Drawing b) {
    b.settings.errorThreshold = a.settings.errorThreshold;
    return a == b;
}

trace::Settings previewSettings(trace::Settings settings, std::uint32_t number) {
    settings.bounces = std::min(settings.bounces, kPreviewBounces);
    settings.seed += number;  // otherwise the noise would stand still on the screen like dirt
    // A spline stays: the majorants of bricks depend on the filter, and each motion would compute them again.
    if (settings.filter == trace::Filter::trilinear) settings.filter = trace::Filter::stochastic;
    return settings;
}

}  // namespace

bool isSamePicture(const FrameInput& a, const FrameInput& b) {
    return a.volume == b.volume && sameDrawing(a.drawing, b.drawing) && a.camera == b.camera &&
           a.place == b.place && a.width == b.width && a.height == b.height;
}

Result<TracedPictures> TracedPictures::create(const std::shared_ptr<gpu::Device>& device) {
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    const double guess = device->isCpu() ? kNsPerPixelGuessCpu : kNsPerPixelGuessGpu;
    return TracedPictures(std::move(tracer), MotionScales(kPreviewBudgetMs, guess));
}

void TracedPictures::sceneChanged() {
    full_.reset();
    settings_.reset();
}

Result<void> TracedPictures::applySettings(const trace::Settings& settings) {
    if (settings_ == settings) return {};
    settings_.reset();
    MACULA_TRY_VOID(tracer_.setSettings(settings));
    settings_ = settings;
    return {};
}

bool TracedPictures::mayDenoise(const FrameInput& input) const {
    return std::int64_t(view_.width) * view_.height < pixelsRefused_ && hasNoise(input);
}

std::uint64_t TracedPictures::sampleLimit(const FrameInput& input) {
    return hasNoise(input) ? input.sampleLimit : std::min<std::uint64_t>(input.sampleLimit, kCastSampleLimit);
}

std::uint64_t TracedPictures::previewLimit(const FrameInput& input) {
    return std::min(kPreviewSampleLimit, sampleLimit(input));
}

Result<void> TracedPictures::beginPreview(const FrameInput& input) {
    full_.reset();
    previewLook_ = input.drawing.settings.look;
    scale_ = motionScales_.of(previewLook_).choose(input.width, input.height);
    view_ = {.camera = input.camera,
             .width = scaledEdge(input.width, scale_),
             .height = scaledEdge(input.height, scale_)};
    MACULA_TRY_VOID(applySettings(
        denoised(previewSettings(input.drawing.settings, ++previewNumber_), mayDenoise(input))));
    MACULA_TRY_VOID(tracer_.setView(view_));
    previewSamples_ = 0;
    return {};
}

Result<bool> TracedPictures::tracePreview(const FrameInput& input, const std::function<bool()>& keepGoing) {
    const std::uint32_t samples =
        mayDenoise(input) || !hasNoise(input) ? kPreviewSamples : kPlainPreviewSamples;
    const Clock::time_point start = Clock::now();
    MACULA_TRY(const bool isWhole, tracer_.trace(samples, keepGoing));
    previewMs_ = millisecondsSince(start);
    isFirstPreview_ = previewSamples_ == 0;
    if (isWhole) previewSamples_ += samples;
    return isWhole;
}

void TracedPictures::previewWasShown(double developMs, double otherMs) {
    // Two kinds of pictures do not predict the next one's time: the first of a size or a look also compiles
    // kernels, and later ones of a view reuse its guides.
    const bool isOfWarmLook = std::exchange(warmLook_, previewLook_) == previewLook_;
    if (std::exchange(warmWidth_, view_.width) != view_.width || !isOfWarmLook || !isFirstPreview_) return;
    motionScales_.of(previewLook_).observe(view_.width, view_.height, previewMs_ + developMs, otherMs);
}

double TracedPictures::expectedFullMs(const FrameInput& input) {
    const double nsPerPixel = motionScales_.of(input.drawing.settings.look).nsPerPixel();
    const auto samples = double(hasNoise(input) ? kFirstDenoised : 1);
    return samples * nsPerPixel * 1e-6 * double(input.width) * double(input.height);
}

bool TracedPictures::hasFull(const FrameInput& input) const {
    return full_ && course_.isWorthShowing() && isSamePicture(*full_, input);
}

Result<void> TracedPictures::beginFull(const FrameInput& input) {
    if (full_ && settings_ && isSamePicture(*full_, input)) {
        full_ = input;
        trace::Settings settings = *settings_;
        settings.errorThreshold = input.drawing.settings.errorThreshold;
        return applySettings(settings);
    }
    full_.reset();
    scale_ = 1;
    view_ = {.camera = input.camera, .width = input.width, .height = input.height};
    const bool isDenoised = mayDenoise(input);
    course_.begin(!hasNoise(input) ? 1 : isDenoised ? kFirstDenoised : kFirstPlain, isDenoised);
    MACULA_TRY_VOID(applySettings(denoised(input.drawing.settings, isDenoised)));
    MACULA_TRY_VOID(tracer_.setView(view_));
    isDeveloping_ = isLast_ = false;
    samples_ = 0.0;
    full_ = input;
    return {};
}

Result<TracedPictures::Progress> TracedPictures::traceFull(const FrameInput& input,
                                                           const std::function<bool()>& keepGoing) {
    if (!isDeveloping_) {
        MACULA_TRY(const trace::Statistics before, tracer_.statistics());
        if (before.samplesPerPixel < trace::kEvenSamples) {
            // One sample at a time: each of the first ones is shown.
            MACULA_TRY(const bool isWhole, tracer_.trace(1, keepGoing));
            if (!isWhole) return Progress{};
        } else {
            MACULA_TRY_VOID(tracer_.traceFor(double(FilterCourse::kNewsInterval.count()), keepGoing));
            if (!keepGoing()) return Progress{};
        }
        MACULA_TRY(const trace::Statistics statistics, tracer_.statistics());
        samples_ = statistics.meanSamplesPerPixel;
        isLast_ = statistics.converged || samples_ >= double(sampleLimit(input));
        course_.noiseIs(statistics.converged, settings_->errorThreshold);
        if (!isLast_ && !course_.isDue(samples_, Clock::now())) return Progress{};
        MACULA_TRY_VOID(applySettings(denoised(*settings_, course_.isFiltered())));
        isDeveloping_ = true;
        developMs_ = 0.0;
    }
    const Clock::time_point start = Clock::now();
    const Result<bool> developed = tracer_.develop(keepGoing);
    developMs_ += millisecondsSince(start);
    if (!developed && developed.error().code == ErrorCode::outOfMemory && trace::isDenoised(*settings_)) {
        MACULA_TRY_VOID(doWithoutDenoising());
        isDeveloping_ = isLast_ || course_.isDue(samples_, Clock::now());
        return Progress{};
    }
    if (!developed) return developed.error();
    if (!*developed) return Progress{};
    isDeveloping_ = false;
    course_.showed(samples_, developMs_, Clock::now());
    if (isLast_) {
        // More samples may be asked for by now.
        MACULA_TRY(const trace::Statistics now, tracer_.statistics());
        isLast_ = now.converged || now.meanSamplesPerPixel >= double(sampleLimit(input));
    }
    return Progress{.isNews = true, .isLast = isLast_};
}

Result<void> TracedPictures::doWithoutDenoising() {
    log::warning("There is no room on the device to denoise a picture of this size.");
    pixelsRefused_ = std::int64_t(view_.width) * view_.height;
    course_.doWithoutFilter(kFirstPlain);
    return applySettings(denoised(*settings_, false));
}

Result<const gpu::Image*> TracedPictures::display(const glm::vec3& background) {
    const auto smoothing = [&] {
        const bool isPlain = !full_ && trace::isPathTraced(settings_->look) && !trace::isDenoised(*settings_);
        return isPlain ? kPlainPreviewSmoothing : trace::Smoothing::none;
    };
    auto picture = tracer_.display(background, smoothing());
    if (picture.ok() || picture.error().code != ErrorCode::outOfMemory || !trace::isDenoised(*settings_))
        return picture;
    MACULA_TRY_VOID(doWithoutDenoising());
    return tracer_.display(background, smoothing());
}

}  // namespace macula::live
