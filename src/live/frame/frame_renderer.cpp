#include "live/frame/frame_renderer.h"

#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include "base/log.h"

namespace macula::live {

namespace {

// Whether both are the same picture but for the size of the window.
bool isSameScene(FrameInput a, const FrameInput& b) {
    a.width = b.width;
    a.height = b.height;
    return isSamePicture(a, b);
}

// Moves a gaze outside the picture to its border, and one that is not finite (unknown) to its middle.
glm::dvec2 usableGaze(const glm::dvec2& gaze) {
    const bool isFinite = std::isfinite(gaze.x) && std::isfinite(gaze.y);
    return isFinite ? glm::clamp(gaze, -1.0, 1.0) : glm::dvec2(0.0);
}

Error notMade() {
    return {ErrorCode::deviceNotUsable,
            Text("The picture could not be made."),
            {},
            Text("Open the study again, or start the program with another --device.")};
}

}  // namespace

Error noMemoryToShow() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory to show this study."),
            {},
            Text("Close other programs, or open a smaller series.")};
}

FrameRenderer::FrameRenderer(gpu::Instance instance, gpu::DeviceOptions device,
                             std::shared_ptr<SceneKeeper> keeper, RenderListener listener)
    : reports_(std::move(listener)),
      device_(std::move(instance), std::move(device)),
      screen_(device_, duty_, reports_),
      models_(device_, reports_, std::move(keeper)),
      scene_(reports_),
      steps_({.input = input_, .device = device_, .duty = duty_, .screen = screen_, .models = models_}) {}

// Puts what the model has learnt on the shelf, and has the keeper store it.
FrameRenderer::~FrameRenderer() {
    releaseScreen();
    models_.putAway();
}

void FrameRenderer::accept(FrameInput input) {
    const Timeline::Watch watch(timeline_);
    const TimelineStage stage("input");
    steps_.hear(input);
    if (!(input.noiseTarget > 0.0)) input.noiseTarget = kUnseenNoise;
    input.drawing.settings.errorThreshold = input.noiseTarget;
    if (input.place != input_.place) releaseScreen();
    if (input.drawing != input_.drawing) steps_.otherDrawing();
    const bool isOtherPhase = input.phase != input_.phase && input.volume && input_.volume;
    if (input.study != input_.study || (input.volume != input_.volume && !isOtherPhase)) {
        // Nobody may mistake the picture of one patient for that of the next, not even while the next is
        // being prepared.
        duty_.otherStudy();
        screen_.forgetPicture();
        models_.otherStudy();
    }
    noteOtherRoom(input);
    duty_.otherInput();
    noteDuty(input);
    if (input.sampleLimit > input_.sampleLimit || input.noiseTarget < input_.noiseTarget)
        steps_.goOnTracing();
    input.gaze = usableGaze(input.gaze);
    if (input.volume) input.camera = standingBefore(input.camera, input.volume->worldBox());
    input_ = std::move(input);
    models_.lookFor(input_);
    steps_.tellCourse();
    giveModelIfAsked();
}

// After such a change the free memory is unknown, so work that lacked memory may be tried again.
void FrameRenderer::noteOtherRoom(const FrameInput& next) {
    if (!device_.traced()) return;
    if (next.volume == input_.volume && next.drawing.transferFunction == input_.drawing.transferFunction &&
        next.drawing.clip == input_.drawing.clip && next.drawing.additions == input_.drawing.additions &&
        next.width == input_.width && next.height == input_.height)
        return;
    device_.traced()->roomChanged();
    models_.roomChanged();
}

void FrameRenderer::noteDuty(const FrameInput& next) {
    if (!isSamePicture(next, input_)) {
        // The message about the lost device resizes the window; that alone must not start the device again.
        isSameScene(next, input_) ? duty_.otherSizeOnly() : duty_.otherPicture();
    } else if (next.usesModel != input_.usesModel) {
        duty_.beginAnew();
    } else if (next.background != input_.background) {
        duty_.otherBackground();
    }
}

void FrameRenderer::giveModelIfAsked() {
    if (input_.modelRequests == modelsGiven_) return;
    modelsGiven_ = input_.modelRequests;
    if (const Result<void> given = giveModel(); !given) handle(given.error());
}

// Always answers, if need be with an error, because the caller waits.
Result<void> FrameRenderer::giveModel() {
    ModelSnapshot taken{.request = input_.modelRequests};
    Result<void> done;
    try {
        done = models_.snapshot(input_, taken);
    } catch (const std::bad_alloc&) {
        // Rendering goes on: only the snapshot lacks memory.
        taken.error = {ErrorCode::outOfMemory,
                       Text("There is not enough memory to write the model."),
                       {},
                       Text("Close other programs.")};
    }
    if (!done) taken.error = done.error();
    if (taken.error) {
        taken.splats.reset();
        taken.state.reset();
    }
    reports_.tell(std::move(taken));
    return done;
}

bool FrameRenderer::hasWork() const {
    if (!input_.visible || !input_.place) return false;
    if (input_.width <= 0 || input_.height <= 0) return false;
    const bool isWindowRight = screen_.isRight(input_);
    if (duty_.isHalted()) return screen_.isOpen() && !isWindowRight;
    return !device_.isOpen() || !isWindowRight || work() != RenderDuty::Work::nothing;
}

RenderDuty::Work FrameRenderer::work() const {
    return duty_.work(isComplete(input_), [&] { return steps_.hasStep(); });
}

void FrameRenderer::step(const Interrupts& interrupts) {
    if (!hasWork()) return;
    const Timeline::Watch watch(timeline_);
    try {
        const TimelineStage stage("bookkeeping");
        if (const Result<void> done = tryStep(interrupts); !done) handle(done.error());
        reports_.tellOfTime(timeline_);
    } catch (const std::bad_alloc&) {
        fail(noMemoryToShow);
    } catch (const std::exception&) {
        fail(notMade);
    }
}

void FrameRenderer::fail(Error (*error)()) {
    duty_.halt();  // first: it also holds when the rest fails
    scene_.distrust();
    models_.failed();
    if (TracedPictures* traced = device_.traced()) traced->sceneChanged();
    try {
        handle(error());
    } catch (const std::exception&) {
        log::error("An error could not be reported.");
    }
}

Result<void> FrameRenderer::tryStep(const Interrupts& interrupts) {
    MACULA_TRY_VOID(ensureDevice());
    MACULA_TRY_VOID(screen_.ensure(input_));
    const bool mustClear = screen_.mustBeCleared();
    if (mustClear) MACULA_TRY_VOID(screen_.clear(input_.background));
    steps_.tellCourse();
    switch (work()) {
        case RenderDuty::Work::nothing:
            return {};
        case RenderDuty::Work::clear:
            duty_.appliedScene();  // there is no scene
            return mustClear ? Result<void>() : screen_.clear(input_.background);
        case RenderDuty::Work::background:
            duty_.showedBackground();
            return steps_.showAgain();
        case RenderDuty::Work::scene: {
            MACULA_TRY(const bool isPlayed, steps_.showPlayed());
            if (isPlayed) {
                duty_.played();
                return {};
            }
            MACULA_TRY(const bool isPassed, steps_.showEstimate(interrupts));
            if (isPassed) return {};
            MACULA_TRY(const bool complete, applyScene(interrupts));
            if (!complete) return {};
            MACULA_TRY_VOID(models_.apply(input_));
            steps_.begin();
            duty_.appliedScene();
            break;
        }
        case RenderDuty::Work::course:
            break;
    }
    steps_.tellCourse();
    return steps_.takeNext(interrupts);
}

Result<void> FrameRenderer::ensureDevice() {
    if (device_.isReady()) return {};
    const TimelineStage stage("start device");
    reports_.tell(Preparing{Text("Starting the graphics device")});
    MACULA_TRY_VOID(device_.open(*input_.place));
    scene_.forget();
    screen_.forgetWindow();
    duty_.beginAnew();
    const gpu::Device& device = *device_.device();
    reports_.tell(DeviceReady{device.info().name, gpu::describe(device.info()), device.isFirstStart()});
    return {};
}

Result<bool> FrameRenderer::applyScene(const Interrupts& interrupts) {
    const TimelineStage stage("set scene");
    // The model of the previous scene is put on the shelf first, to free its memory on the device.
    if (scene_.hasOtherMatter(input_)) models_.hide();
    // Whoever waits for the surface, or has changed the input, waits for one part at most.
    return scene_.apply(input_, *device_.traced(), [&] { return interrupts.any(); });
}

void FrameRenderer::handle(Error error) {
    // Any error may be a consequence of the loss.
    if (device_.isLost() || error.code == ErrorCode::deviceLost) {
        dropDevice();
        if (device_.mayGoOnAfterLoss()) {
            duty_.startedAgain();  // hasWork() is true without a device: the next step makes a new one
            log::warning("The graphics device was lost; starting it again.");
            reports_.tell(DeviceRestarting{});
            return;
        }
        error = gpu::lostTooOften();
        duty_.lostTooOften();
    }
    duty_.failed();
    // The content of the tracer's film is unknown.
    if (TracedPictures* traced = device_.traced()) traced->sceneChanged();
    try {
        const Result<void> cleared = screen_.isOpen() ? screen_.clear(input_.background) : Result<void>{};
        if (!cleared) {
            log::warning("{}", cleared.error().message.english());
            releaseScreen();
        }
    } catch (const std::exception&) {
        log::warning(
            "The window could not be cleared.");  // this must not keep the first error from being reported
        releaseScreen();
    }
    reports_.tell(RenderFailure{.error = error,
                                .inputSequence = input_.sequence,
                                .pictureRemains = !screen_.isOpen() || duty_.isForeign()});
}

// In this order: the screen and the models use the device.
void FrameRenderer::dropDevice() {
    releaseScreen();
    models_.dropDevice();
    device_.drop();
    scene_.forget();
    screen_.forgetWindow();
}

}  // namespace macula::live
