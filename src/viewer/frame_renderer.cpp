#include "viewer/frame_renderer.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include "base/log.h"

namespace macula::viewer {

namespace {

using std::chrono::duration;
using std::chrono::milliseconds;

double millisecondsBetween(std::chrono::steady_clock::time_point from,
                           std::chrono::steady_clock::time_point to) {
    return duration<double, std::milli>(to - from).count();
}

constexpr double kMotionBudgetMs = 100.0;  // 10 pictures a second; 5 are still left on a machine half as fast
constexpr double kNsPerPixelGuessCpu = 4000.0;
constexpr double kNsPerPixelGuessGpu = 50.0;
// In motion light may bounce this often. With fewer, bone turns from ivory to grey: its colour is made by
// many bounces, and the picture would change its look each time a hand lets go.
constexpr int kMotionBounces = 4;
// Of each pixel before a picture in motion is shown. Denoised, one is enough: the view before helps, and what
// a second costs is better spent on pixels. A picture that is not would be a cloud of dots.
constexpr std::uint32_t kMotionSamples = 1;
constexpr std::uint32_t kPlainMotionSamples = 2;
constexpr trace::Smoothing kPlainMotionSmoothing = trace::Smoothing::slight;
constexpr std::uint64_t kMotionSampleLimit = 64;  // while a hand holds still
// Cast rays have no noise: more samples only make edges smoother. As many as `macula render` takes.
constexpr std::uint64_t kCastSampleLimit = 8;
// After the last change the small picture is refined for so long before the full one starts: it stays on
// screen during the long first pass of that, and should not be the noisiest of all.
constexpr milliseconds kSettle{300};
constexpr milliseconds kShowInterval{100};  // while converging; nobody sees more, and each costs a copy
constexpr milliseconds kRateWindow{2000};
// The full picture is denoised while it has few samples: each time they have doubled, as the filter takes as
// long as a sample or two. What has more is shown as it is.
constexpr std::uint64_t kFirstDenoised = 2;
constexpr std::uint64_t kDenoisedBelow = 64;
// A hand that moves on waits for the filter. Where a full picture would take longer it is not denoised, and
// the small one, which is, stays until the full one is no longer a cloud of dots.
constexpr double kMostFilterMs = 1000.0;
constexpr std::uint64_t kFirstPlain = 4;
// Standard error of what is shown: one step of eight bits, which nobody sees.
constexpr double kConverged = 1.0 / 255.0;

bool sameCamera(const Camera& a, const Camera& b) {
    return a.positionMm == b.positionMm && a.targetMm == b.targetMm && a.up == b.up &&
           a.verticalFovDeg == b.verticalFovDeg;
}

bool sameScene(const FrameInput& a, const FrameInput& b) {
    return a.volume == b.volume && a.drawing == b.drawing && sameCamera(a.camera, b.camera) &&
           a.surface == b.surface;
}

bool samePicture(const FrameInput& a, const FrameInput& b) {
    return sameScene(a, b) && a.width == b.width && a.height == b.height;
}

trace::Settings denoised(trace::Settings settings, bool isDenoised) {
    settings.denoising = isDenoised ? trace::Denoising::on : trace::Denoising::off;
    return settings;
}

trace::Settings motionSettings(trace::Settings settings, std::uint32_t frame) {
    settings.bounces = std::min(settings.bounces, kMotionBounces);
    settings.seed += frame;  // else the noise would stand still on the screen like dirt
    settings.filter = trace::Filter::stochastic;
    return settings;
}

float encodedSrgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

}  // namespace

FrameRenderer::FrameRenderer(gpu::Instance instance, std::string preferredDevice, RenderListener listener)
    : instance_(std::move(instance)),
      preferredDevice_(std::move(preferredDevice)),
      listener_(std::move(listener)) {}

FrameRenderer::~FrameRenderer() {
    releaseSurface();
}

void FrameRenderer::accept(FrameInput input) {
    input.drawing.settings.errorThreshold = kConverged;
    if (input.surface != input_.surface) releaseSurface();
    if (input.study != input_.study || input.volume != input_.volume) {
        // Nobody may take the picture of one patient for that of the next, not even while this one is
        // prepared.
        clear_ = true;
        if (presenter_) presenter_->forget();
        unreported_.reset();
    }
    // What else is on the device leaves another room; and nobody knows how much.
    if (input.volume != input_.volume || input.drawing.transferFunction != input_.drawing.transferFunction ||
        input.drawing.clip != input_.drawing.clip || input.width != input_.width ||
        input.height != input_.height) {
        pixelsRefused_ = kNoneRefused;
    }
    if (!samePicture(input, input_)) {
        restart_ = true;
        // The window takes another size around the sentence that says so: nobody has asked for another try.
        const bool stillGivenUp = givenUp_ && sameScene(input, input_);
        if (!stillGivenUp) halted_ = givenUp_ = false;
    } else if (input.background != input_.background) {
        redisplay_ = true;
    }
    if (stage_ == Stage::converged && input.sampleLimit > input_.sampleLimit) stage_ = Stage::converging;
    input_ = std::move(input);
}

bool FrameRenderer::hasWork() const {
    if (!input_.visible || input_.surface == VK_NULL_HANDLE) return false;
    if (input_.width <= 0 || input_.height <= 0) return false;
    if (halted_) return presenter_ && applied_.exposures != input_.exposures;
    if (restart_ || redisplay_ || !device_ || !presenter_ || applied_.exposures != input_.exposures) {
        return true;
    }
    if (!input_.volume || stage_ == Stage::converged) return false;
    return stage_ != Stage::moving || !input_.interacting ||
           movingSamples_ < std::min(kMotionSampleLimit, sampleLimit());
}

void FrameRenderer::step(const Interrupts& interrupts) {
    if (!hasWork()) return;
    try {
        if (const Result<void> done = tryStep(interrupts); !done) handle(done.error());
    } catch (const std::bad_alloc&) {
        fail(ErrorCode::outOfMemory, "There is not enough memory to show this study.",
             "Close other programs, or open a smaller series.");
    } catch (const std::exception&) {
        fail(ErrorCode::deviceNotUsable, "The picture could not be made.",
             "Open the study again, or start the program with another --device.");
    }
}

void FrameRenderer::fail(ErrorCode code, const char* message, const char* hint) {
    halted_ = true;  // first: it also holds when the rest fails
    // Nobody knows how far the tracer got.
    applied_.volume = nullptr;
    applied_.transferFunction = nullptr;
    applied_.lights = nullptr;
    applied_.clip.reset();
    applied_.settings.reset();
    try {
        handle({code, message, {}, hint});
    } catch (const std::exception&) {
        log::error("An error could not be reported.");
    }
}

Result<void> FrameRenderer::tryStep(const Interrupts& interrupts) {
    MACULA_TRY_VOID(ensureDevice());
    MACULA_TRY_VOID(ensurePresenter());
    if (halted_) return {};  // it was only to paint the window again
    if (!input_.volume || !input_.drawing.transferFunction || !input_.drawing.lights) {
        restart_ = redisplay_ = false;
        stage_ = Stage::converged;
        return clearWindow();
    }
    if (clear_) MACULA_TRY_VOID(clearWindow());
    if (restart_) {
        MACULA_TRY(const bool complete, applyScene(interrupts));
        if (!complete) return {};
        MACULA_TRY_VOID(startMoving());
    }
    if (std::exchange(redisplay_, false)) return showPicture();
    if (stage_ == Stage::moving) return stepMoving(interrupts);
    if (stage_ == Stage::converging) return stepConverging(interrupts);
    return {};
}

Result<void> FrameRenderer::ensureDevice() {
    if (device_ && tracer_) return {};
    listener_(Preparing{"Starting the graphics device"});
    if (!device_) {
        gpu::DeviceOptions options;
        options.preferred = preferredDevice_;
        options.extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
        MACULA_TRY(device_, gpu::Device::create(instance_, options));
    }
    MACULA_TRY(tracer_, trace::PathTracer::create(device_));
    warmWidth_ = 0;
    pixelsRefused_ = kNoneRefused;
    filterNsPerPixel_ = 0.0;
    applied_ = {};
    restart_ = true;
    motionScale_.emplace(kMotionBudgetMs, device_->isCpu() ? kNsPerPixelGuessCpu : kNsPerPixelGuessGpu);
    listener_(DeviceReady{device_->info().name, gpu::describe(device_->info())});
    return {};
}

Result<void> FrameRenderer::ensurePresenter() {
    const VkExtent2D window{std::uint32_t(input_.width), std::uint32_t(input_.height)};
    if (!presenter_) {
        MACULA_TRY(Presenter presenter, Presenter::create(device_, input_.surface, window));
        presenter_.emplace(std::move(presenter));
        restart_ = true;
    } else if (applied_.window.width != window.width || applied_.window.height != window.height) {
        MACULA_TRY_VOID(presenter_->resize(window));
    }
    applied_.window = window;
    if (applied_.exposures != input_.exposures) {
        applied_.exposures = input_.exposures;
        MACULA_TRY(const bool shown, presenter_->showAgain());
        if (shown && unreported_) listener_(*std::exchange(unreported_, std::nullopt));
    }
    return {};
}

Result<void> FrameRenderer::clearWindow() {
    presenter_->forget();
    unreported_.reset();
    shown_.clear();
    const glm::vec3 b = input_.background;
    const VkClearColorValue colour{{encodedSrgb(b.r), encodedSrgb(b.g), encodedSrgb(b.b), 1.0f}};
    MACULA_TRY(const bool shown, presenter_->showColour(colour));
    clear_ = !shown;
    return {};
}

Result<bool> FrameRenderer::applyScene(const Interrupts& interrupts) {
    const Drawing& drawing = input_.drawing;
    // Each part may take long. Whoever waits for the surface, or has changed something, waits for one of
    // them; what is done stays done, so that a hand that never rests does not keep the scene from being
    // applied.
    const auto interrupted = [&] { return interrupts.newInput() || interrupts.stopping(); };
    if (applied_.volume != input_.volume) {
        listener_(Preparing{"Preparing the volume"});
        // After a failure the tracer has neither the old one nor the new one; so with the other parts.
        applied_.volume = nullptr;
        applied_.transferFunction = nullptr;
        MACULA_TRY_VOID(tracer_->setVolume(input_.volume));
        applied_.volume = input_.volume;
        if (interrupted()) return false;
    }
    // Before the transfer function: what is hidden is not brought to the device.
    if (applied_.clip != drawing.clip) {
        if (applied_.transferFunction) listener_(Preparing{"Preparing what is shown"});
        applied_.clip.reset();
        MACULA_TRY_VOID(tracer_->setClip(drawing.clip ? *drawing.clip : Clip{}));
        applied_.clip = drawing.clip;
        if (interrupted()) return false;
    }
    if (applied_.transferFunction != drawing.transferFunction) {
        applied_.transferFunction = nullptr;
        MACULA_TRY_VOID(tracer_->setTransferFunction(*drawing.transferFunction));
        applied_.transferFunction = drawing.transferFunction;
        if (interrupted()) return false;
    }
    if (applied_.lights != drawing.lights) {
        applied_.lights = nullptr;
        MACULA_TRY_VOID(tracer_->setEnvironment(trace::Environment::fromRig(*drawing.lights)));
        applied_.lights = drawing.lights;
    }
    return true;
}

Result<void> FrameRenderer::applySettings(const trace::Settings& settings) {
    if (applied_.settings && *applied_.settings == settings) return {};
    MACULA_TRY_VOID(tracer_->setSettings(settings));
    applied_.settings = settings;
    return {};
}

Result<void> FrameRenderer::startMoving() {
    scale_ = motionScale_->choose(input_.width, input_.height);
    view_ = {.camera = input_.camera,
             .width = scaledEdge(input_.width, scale_),
             .height = scaledEdge(input_.height, scale_)};
    MACULA_TRY_VOID(
        applySettings(denoised(motionSettings(input_.drawing.settings, ++motionFrame_), mayDenoise())));
    MACULA_TRY_VOID(tracer_->setView(view_));
    movingSince_ = Clock::now();
    movingSamples_ = 0;
    restart_ = redisplay_ = false;
    stage_ = Stage::moving;
    return {};
}

Result<void> FrameRenderer::startConverging() {
    scale_ = 1;
    view_ = {.camera = input_.camera, .width = input_.width, .height = input_.height};
    stillIsDenoised_ =
        mayDenoise() && filterNsPerPixel_ * 1e-6 * input_.width * input_.height <= kMostFilterMs;
    showFrom_ = !hasNoise() ? 1 : stillIsDenoised_ ? kFirstDenoised : kFirstPlain;
    MACULA_TRY_VOID(applySettings(denoised(input_.drawing.settings, stillIsDenoised_)));
    MACULA_TRY_VOID(tracer_->setView(view_));
    stage_ = Stage::converging;
    return {};
}

Result<void> FrameRenderer::stepMoving(const Interrupts& interrupts) {
    if (!input_.interacting && movingSamples_ > 0 && Clock::now() - movingSince_ >= kSettle) {
        return startConverging();
    }
    const std::uint32_t samples = mayDenoise() || !hasNoise() ? kMotionSamples : kPlainMotionSamples;
    const Clock::time_point start = Clock::now();
    MACULA_TRY(const bool complete, tracer_->trace(samples, [&] { return !interrupts.stopping(); }));
    if (!complete) return {};
    const Clock::time_point traced = Clock::now();
    MACULA_TRY(const gpu::Image* picture, develop());
    MACULA_TRY_VOID(device_->waitForAll());
    const Clock::time_point developed = Clock::now();
    MACULA_TRY_VOID(show(*picture));
    // One picture in flight: a longer queue would show where the hand was, not where it is.
    MACULA_TRY_VOID(device_->waitForAll());
    const bool first = movingSamples_ == 0;
    movingSamples_ += samples;
    // The first picture of a size also compiles kernels, and later ones of a view have its guides: they say
    // nothing about the next.
    if (std::exchange(warmWidth_, view_.width) != view_.width || !first) return {};
    if (mayDenoise()) {
        filterNsPerPixel_ =
            millisecondsBetween(traced, developed) * 1e6 / (double(view_.width) * double(view_.height));
    }
    motionScale_->observe(view_.width, view_.height, millisecondsBetween(start, developed),
                          millisecondsBetween(developed, Clock::now()));
    return {};
}

Result<void> FrameRenderer::stepConverging(const Interrupts& interrupts) {
    const auto keepGoing = [&] { return !interrupts.newInput() && !interrupts.stopping(); };
    MACULA_TRY(const trace::Statistics before, tracer_->statistics());
    if (before.samplesPerPixel < trace::kEvenSamples) {
        // One at a time: each of the first is seen.
        MACULA_TRY(const bool complete, tracer_->trace(1, keepGoing));
        if (!complete) return {};
    } else {
        MACULA_TRY_VOID(tracer_->traceFor(double(kShowInterval.count()), keepGoing));
        if (!keepGoing()) return {};
    }
    MACULA_TRY(const trace::Statistics statistics, tracer_->statistics());
    const auto samples = static_cast<std::uint64_t>(statistics.meanSamplesPerPixel);
    const bool last = statistics.converged || statistics.meanSamplesPerPixel >= double(sampleLimit());
    if (last) stage_ = Stage::converged;
    if (stillIsDenoised_ && samples >= kDenoisedBelow) {
        stillIsDenoised_ = false;
        MACULA_TRY_VOID(applySettings(denoised(input_.drawing.settings, false)));
    }
    const bool early = samples < showFrom_;
    const bool rested = shown_.empty() || Clock::now() - shown_.back() >= kShowInterval;
    if (!last && (early || !rested)) return {};
    if (stillIsDenoised_) showFrom_ = 2 * samples;
    return showPicture();
}

bool FrameRenderer::hasNoise() const {
    return trace::isPathTraced(input_.drawing.settings.look);
}

bool FrameRenderer::mayDenoise() const {
    return std::int64_t(view_.width) * view_.height < pixelsRefused_ && hasNoise();
}

std::uint64_t FrameRenderer::sampleLimit() const {
    return hasNoise() ? input_.sampleLimit : std::min<std::uint64_t>(input_.sampleLimit, kCastSampleLimit);
}

// The picture of the samples so far, on the device. What is too large for the filter is shown without.
Result<const gpu::Image*> FrameRenderer::develop() {
    const auto smoothing = stage_ == Stage::moving && hasNoise() && !mayDenoise() ? kPlainMotionSmoothing
                                                                                  : trace::Smoothing::none;
    auto picture = tracer_->display(input_.background, smoothing);
    if (picture.ok() || picture.error().code != ErrorCode::outOfMemory || !mayDenoise()) return picture;
    log::warning("There is no room on the device to denoise a picture of this size.");
    pixelsRefused_ = std::int64_t(view_.width) * view_.height;
    stillIsDenoised_ = false;
    MACULA_TRY_VOID(applySettings(denoised(*applied_.settings, false)));
    return tracer_->display(input_.background, smoothing);
}

Result<void> FrameRenderer::showPicture() {
    MACULA_TRY(const gpu::Image* picture, develop());
    return show(*picture);
}

Result<void> FrameRenderer::show(const gpu::Image& picture) {
    MACULA_TRY(const bool visible, presenter_->show(picture));
    const Clock::time_point now = Clock::now();
    if (visible) shown_.push_back(now);
    while (!shown_.empty() && now - shown_.front() > kRateWindow) shown_.pop_front();
    MACULA_TRY(const trace::Statistics statistics, tracer_->statistics());
    const FrameShown frame{.inputSequence = input_.sequence,
                           .study = input_.study,
                           .letters = input_.letters,
                           .stage = stage_,
                           .width = view_.width,
                           .height = view_.height,
                           .scale = scale_,
                           .samplesPerPixel = static_cast<std::uint64_t>(statistics.meanSamplesPerPixel),
                           .sampleLimit = sampleLimit(),
                           .denoised = statistics.denoised,
                           .look = input_.drawing.settings.look,
                           .remarks = input_.drawing.remarks,
                           .framesPerSecond = framesPerSecond(),
                           .latencyMs = millisecondsBetween(input_.published, now),
                           .samplesLeftOut = statistics.nonFiniteSamples + statistics.abandonedSamples,
                           .messages = statistics.messages};
    // The presenter has kept a picture that could not be shown now, and shows it when the window comes back.
    unreported_ = visible ? std::nullopt : std::optional(frame);
    if (visible) listener_(frame);
    return {};
}

double FrameRenderer::framesPerSecond() const {
    if (shown_.size() < 2) return 0.0;
    const double spanMs = millisecondsBetween(shown_.front(), shown_.back());
    return spanMs > 0.0 ? 1000.0 * double(shown_.size() - 1) / spanMs : 0.0;
}

void FrameRenderer::handle(Error error) {
    // An error of another kind may have come of the loss; and what is lost while it is made is not there to
    // be asked.
    if ((device_ && device_->lost()) || error.code == ErrorCode::deviceLost) {
        dropDevice();
        if (losses_.mayGoOn()) {
            halted_ = false;  // hasWork() is true without a device: the next step makes a new one
            log::warning("The graphics device was lost; starting it again.");
            listener_(DeviceRestarting{});
            return;
        }
        error = gpu::lostTooOften();
        givenUp_ = true;
    }
    halted_ = true;
    clear_ = true;
    try {
        const Result<void> cleared = presenter_ ? clearWindow() : Result<void>{};
        if (!cleared) log::warning("{}", cleared.error().message);
    } catch (const std::exception&) {
        log::warning("The window could not be cleared.");  // which must not keep the error from being told
    }
    listener_(RenderFailure{error});
}

void FrameRenderer::dropDevice() {
    releaseSurface();
    tracer_.reset();
    device_.reset();
    applied_ = {};
}

void FrameRenderer::releaseSurface() {
    if (const Result<void> released = Presenter::release(std::exchange(presenter_, std::nullopt));
        !released) {
        log::warning("{}", released.error().message);
    }
}

}  // namespace macula::viewer
