#include "live/frame/frame_renderer.h"

#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include "base/check.h"
#include "base/log.h"
#include "base/srgb.h"
#include "pipeline/trace/device_scene.h"

namespace macula::live {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kModelToldEvery{500};
constexpr milliseconds kTimeToldEvery{250};
constexpr double kQuickMs = 250.0;  // a picture of all pixels that is there sooner has no need of small ones
constexpr std::uint64_t kShelfBytes = std::uint64_t(1) << 30;

// Whether both are the same picture but for the size of the window.
bool isSameScene(FrameInput a, const FrameInput& b) {
    a.width = b.width;
    a.height = b.height;
    return isSamePicture(a, b);
}

bool isSameMatter(const std::optional<std::shared_ptr<const Additions>>& applied,
                  const std::shared_ptr<const Additions>& wanted) {
    static const Additions kNone;
    return applied && macula::isSameMatter(*applied ? **applied : kNone, wanted ? *wanted : kNone);
}

// An eye that looks beside the picture, or nobody knows where: at its border, or in its middle.
glm::dvec2 usableGaze(const glm::dvec2& gaze) {
    const bool isFinite = std::isfinite(gaze.x) && std::isfinite(gaze.y);
    return isFinite ? glm::clamp(gaze, -1.0, 1.0) : glm::dvec2(0.0);
}

}  // namespace

FrameRenderer::FrameRenderer(gpu::Instance instance, gpu::DeviceOptions device,
                             std::shared_ptr<SceneKeeper> keeper, RenderListener listener)
    : instance_(std::move(instance)),
      deviceOptions_(std::move(device)),
      listener_(std::move(listener)),
      keeper_(std::move(keeper)) {}

FrameRenderer::~FrameRenderer() {
    releaseScreen();
    putModelAway();
}

// What it has learnt goes to the shelf and to the keeper.
void FrameRenderer::putModelAway() {
    dropModelAfter(&hybrid::LiveModel::hide);
}

// Throws nothing.
void FrameRenderer::dropModelAfter(void (hybrid::LiveModel::*keep)()) {
    try {
        if (model_) ((*model_).*keep)();
    } catch (const std::exception&) {
        log::warning("There was no memory to keep the peripheral model.");
    }
    model_.reset();
}

void FrameRenderer::accept(FrameInput input) {
    const Timeline::Watch watch(timeline_);
    const TimelineStage stage("input");
    rhythm_.input(input.published, input.interacting);
    hasLearntBesideHand_ = false;
    if (!(input.noiseTarget > 0.0)) input.noiseTarget = kUnseenNoise;
    input.drawing.settings.errorThreshold = input.noiseTarget;
    if (input.place != input_.place) releaseScreen();
    if (input.drawing != input_.drawing) editShownAt_.reset();
    if (input.study != input_.study || input.volume != input_.volume) {
        // Nobody may take the picture of one patient for that of the next, not even while this one is
        // prepared.
        duty_.otherStudy();
        if (screen_) screen_->forget();
        kept_.reset();
        unreported_.reset();
        hybrid_.reset();
        estimate_.reset();
        putModelAway();
        shelf_.reset();
    }
    // Another use of the device leaves another amount of memory, and nobody knows how much.
    if (traced_ &&
        (input.volume != input_.volume || input.drawing.transferFunction != input_.drawing.transferFunction ||
         input.drawing.clip != input_.drawing.clip || input.drawing.additions != input_.drawing.additions ||
         input.width != input_.width || input.height != input_.height)) {
        traced_->roomChanged();
        foveaHasRoom_ = true;
        estimateHasRoom_ = true;
        if (model_ && model_->news().stage == hybrid::ModelStage::noRoom) model_->hide();
    }
    if (!isSamePicture(input, input_)) {
        // The window takes another size around the sentence that says that the device was lost.
        isSameScene(input, input_) ? duty_.otherSizeOnly() : duty_.otherPicture();
    } else if (input.usesModel != input_.usesModel) {
        duty_.beginAnew();
    } else if (input.background != input_.background) {
        duty_.otherBackground();
    }
    if (input.sampleLimit > input_.sampleLimit || input.noiseTarget < input_.noiseTarget)
        course_.goOnTracing();
    input.gaze = usableGaze(input.gaze);
    if (input.volume) input.camera = standingBefore(input.camera, input.volume->worldBox());
    input_ = std::move(input);
    lookForModel();
    tellCourse();
    if (input_.modelRequests == modelsGiven_) return;
    modelsGiven_ = input_.modelRequests;
    if (const Result<void> given = giveModel(); !given) handle(given.error());
}

// Whoever asked waits for an answer, and gets one.
Result<void> FrameRenderer::giveModel() {
    ModelSnapshot taken{.request = input_.modelRequests};
    Result<void> done;
    try {
        done = snapshotModel(taken);
    } catch (const std::bad_alloc&) {
        // The picture goes on without that.
        taken.error = {ErrorCode::outOfMemory,
                       "There is not enough memory to write the model.",
                       {},
                       "Close other programs."};
    }
    if (!done) taken.error = done.error();
    if (taken.error) {
        taken.splats.reset();
        taken.state.reset();
    }
    listener_(std::move(taken));
    return done;
}

// What is drawn now, and only of what is wanted now.
Result<void> FrameRenderer::snapshotModel(ModelSnapshot& taken) {
    if (!isComplete() || !canDrawModel()) return {};
    if (model_->key() != sceneNames_.of(input_.study, input_.drawing)) return {};
    taken.splats = model_->shown();
    taken.gain = model_->gain();
    if (input_.requestsTraining) {
        MACULA_TRY(taken.state, model_->state());
    }
    return {};
}

// A model holds its light, so only lights that stay with the patient can have one.
bool FrameRenderer::canHaveModel() const {
    return input_.usesModel && trace::isPathTraced(input_.drawing.settings.look) &&
           input_.drawing.lights->frame == trace::LightFrame::patient;
}

// While the volume is brought to the device the stored model is read.
void FrameRenderer::lookForModel() {
    if (!keeper_ || !isComplete() || !canHaveModel()) return;
    std::string name = sceneNames_.of(input_.study, input_.drawing);
    if (name == lookedFor_) return;
    lookedFor_ = std::move(name);
    if (!shelf_ || !shelf_->find(lookedFor_)) keeper_->willShow(lookedFor_, input_.volume, input_.drawing);
}

void FrameRenderer::tellCourse() {
    if (estimate_ && hasFitModel()) estimate_->forget();
    course_.setHand(input_.interacting);
    course_.setPreviewLimit(TracedPictures::previewLimit(input_));
    course_.setFovea(wantsFovea());
    ModelState state = ModelState::none;
    const bool works = model_ && model_->hasWork() && !input_.convergesNow;
    if (canDrawModel())
        state = hasFitModel() ? ModelState::ready : ModelState::young;
    else if (works)
        state = ModelState::searching;
    course_.setModel(state, works);
    course_.setEstimate(drawsEstimate());
    course_.setLearnsBesideHand(works && learnsBesideHand());
    course_.setQuick(isQuick());
}

// Once for each input: whoever holds the picture will move it soon. Where the device is the CPU, frames and
// learning take the same cores, and a step takes longer than a frame may be late.
bool FrameRenderer::learnsBesideHand() const {
    return input_.interacting && !hasLearntBesideHand_ && canDrawModel() && !device_->isCpu() &&
           rhythm_.leftMs(Clock::now()) > 0.0;
}

bool FrameRenderer::hasFitModel() const {
    return canDrawModel() && hybrid::isFitToBeShown(model_->news());
}

bool FrameRenderer::isQuick() {
    return device_ && traced_ && !device_->isCpu() && input_.volume &&
           traced_->expectedFullMs(input_) <= kQuickMs;
}

// The marks that are wanted are of the picture on screen, and are not there: they were hidden or are to be.
bool FrameRenderer::hasOtherMarks() const {
    return screen_ && kept_ == Shown{input_.camera, input_.width, input_.height} &&
           screen_->marks() != input_.marks;
}

bool FrameRenderer::hasWork() const {
    if (!input_.visible || !input_.place) return false;
    if (input_.width <= 0 || input_.height <= 0) return false;
    const bool isWindowRight = screen_ && applied_.exposures == input_.exposures &&
                               screen_->text() == input_.text && !hasOtherMarks() && !duty_.isForeign() &&
                               !screen_->owes();
    if (duty_.isHalted()) return screen_ && !isWindowRight;
    return !device_ || !isWindowRight || work() != RenderDuty::Work::nothing;
}

RenderDuty::Work FrameRenderer::work() const {
    return duty_.work(isComplete(), [&] { return course_.next(Clock::now()) != Step::none; });
}

bool FrameRenderer::isComplete() const {
    return input_.volume && input_.drawing.transferFunction && input_.drawing.lights;
}

void FrameRenderer::step(const Interrupts& interrupts) {
    if (!hasWork()) return;
    const Timeline::Watch watch(timeline_);
    try {
        const TimelineStage stage("bookkeeping");
        if (const Result<void> done = tryStep(interrupts); !done) handle(done.error());
        tellOfTime();
    } catch (const std::bad_alloc&) {
        fail(ErrorCode::outOfMemory, "There is not enough memory to show this study.",
             "Close other programs, or open a smaller series.");
    } catch (const std::exception&) {
        fail(ErrorCode::deviceNotUsable, "The picture could not be made.",
             "Open the study again, or start the program with another --device.");
    }
}

void FrameRenderer::fail(ErrorCode code, const char* message, const char* hint) {
    duty_.halt();  // first: it also holds when the rest fails
    // Nobody knows how far the tracer got.
    applied_.volume = nullptr;
    applied_.transferFunction = nullptr;
    applied_.lights = nullptr;
    applied_.clip.reset();
    hybrid_.reset();
    // Of the model, what is on the host: what the device did last may be half of a step.
    dropModelAfter(&hybrid::LiveModel::save);
    if (traced_) traced_->sceneChanged();
    try {
        handle({code, message, {}, hint});
    } catch (const std::exception&) {
        log::error("An error could not be reported.");
    }
}

Result<void> FrameRenderer::tryStep(const Interrupts& interrupts) {
    MACULA_TRY_VOID(ensureDevice());
    MACULA_TRY_VOID(ensureScreen());
    const bool mustClear =
        duty_.isForeign() && !screen_->owes();  // a picture still owed is an empty one already
    if (mustClear) MACULA_TRY_VOID(clearWindow());
    tellCourse();
    switch (work()) {
        case RenderDuty::Work::nothing:
            return {};
        case RenderDuty::Work::clear:
            duty_.appliedScene();  // there is no scene
            return mustClear ? Result<void>() : clearWindow();
        case RenderDuty::Work::background:
            duty_.showedBackground();
            return showAgain();
        case RenderDuty::Work::scene: {
            MACULA_TRY(const bool isPassed, showEstimate(interrupts));
            if (isPassed) return {};
            MACULA_TRY(const bool complete, applyScene(interrupts));
            if (!complete) return {};
            MACULA_TRY_VOID(applyModel());
            MACULA_TRY_VOID(makeEstimate());
            course_.want(traced_->hasFull(input_));
            duty_.appliedScene();
            break;
        }
        case RenderDuty::Work::course:
            break;
    }
    tellCourse();
    return takeNext(interrupts);
}

Result<void> FrameRenderer::takeNext(const Interrupts& interrupts) {
    Result<void> done = take(course_.next(Clock::now()), interrupts);
    // Traced pictures come first: without the model there may be memory for them.
    const bool isEstimate = drawsEstimate();
    if (done || done.error().code != ErrorCode::outOfMemory ||
        (!isEstimate && (!model_ || !model_->canBeDrawn())))
        return done;
    duty_.beginAnew();
    traced_->roomChanged();
    return isEstimate ? withoutEstimate(done.error()) : withoutModel(done.error());
}

// Whatever keeps the model from being made or drawn does not keep anybody from tracing.
Result<void> FrameRenderer::withoutModel(const Error& error) {
    if (device_->lost() || error.code == ErrorCode::deviceLost) return error;
    log::warning("There is no peripheral model of this: {}", error.message);
    const auto stage =
        error.code == ErrorCode::outOfMemory ? hybrid::ModelStage::noRoom : hybrid::ModelStage::failed;
    if (model_)
        model_->giveUp(stage);
    else
        whyNoModel_ = stage;
    hybrid_.reset();  // and its memory with it
    tellOfModel();
    return {};
}

Result<void> FrameRenderer::ensureDevice() {
    if (device_ && traced_) return {};
    const TimelineStage stage("start device");
    listener_(Preparing{"Starting the graphics device"});
    if (!device_) {
        gpu::DeviceOptions options = deviceOptions_;
        for (const char* extension : input_.place->deviceExtensions())
            options.extensions.push_back(extension);
        MACULA_TRY(device_, gpu::Device::create(instance_, options));
    }
    MACULA_TRY(traced_, TracedPictures::create(device_));
    applied_ = {};
    duty_.beginAnew();
    listener_(DeviceReady{device_->info().name, gpu::describe(device_->info()), device_->isFirstStart()});
    return {};
}

Result<void> FrameRenderer::ensureScreen() {
    const VkExtent2D window{std::uint32_t(input_.width), std::uint32_t(input_.height)};
    if (!screen_) {
        MACULA_TRY(screen_, input_.place->open(device_, window));
        kept_.reset();
        duty_.beginAnew();
    } else if (applied_.window.width != window.width || applied_.window.height != window.height) {
        MACULA_TRY_VOID(screen_->resize(window));
    }
    applied_.window = window;
    // The kept picture is of the input's study: that of another study is forgotten by now.
    const bool isOtherText = screen_->text() != input_.text;
    const bool isOtherMarks = hasOtherMarks();
    if (applied_.exposures != input_.exposures || isOtherText || isOtherMarks || screen_->owes()) {
        applied_.exposures = input_.exposures;
        screen_->setText(input_.text);
        if (isOtherMarks) screen_->setMarks(input_.marks);
        MACULA_TRY(const bool shown, screen_->showAgain());
        if (shown) {
            if (duty_.isForeign()) listener_(PictureRemoved{});
            duty_.showedOurs();
            if (unreported_) listener_(*std::exchange(unreported_, std::nullopt));
        }
    }
    return {};
}

Result<void> FrameRenderer::clearWindow() {
    screen_->forget();
    kept_.reset();
    unreported_.reset();
    shown_.clear();
    const glm::vec3 b = input_.background;
    const VkClearColorValue colour{{encodedSrgb(b.r), encodedSrgb(b.g), encodedSrgb(b.b), 1.0f}};
    MACULA_TRY_VOID(screen_->showColour(colour));
    if (screen_->owes()) {
        duty_.owesClearing();
    } else {  // of a hidden window nothing is to be seen
        duty_.showedOurs();
        listener_(PictureRemoved{});
    }
    return {};
}

Result<bool> FrameRenderer::applyScene(const Interrupts& interrupts) {
    const TimelineStage stage("set scene");
    const scene::Drawing& drawing = input_.drawing;
    // Each part may take long. Whoever waits for the surface, or has changed something, waits for one of
    // them; what is done stays done, so that a hand that never rests does not keep the scene from being
    // applied.
    const auto interrupted = [&] { return interrupts.newInput() || interrupts.stopping(); };
    trace::PathTracer& tracer = traced_->tracer();
    // A model of another scene is dropped first, to free its memory.
    if (model_ &&
        (applied_.volume != input_.volume || applied_.clip != drawing.clip ||
         applied_.additions != drawing.additions || applied_.transferFunction != drawing.transferFunction)) {
        model_->hide();
    }
    if (applied_.volume != input_.volume) {
        listener_(Preparing{"Preparing the volume"});
        traced_->sceneChanged();
        outlineOf_.reset();
        // After a failure the tracer has neither the old one nor the new one; so with the other parts.
        applied_.volume = nullptr;
        applied_.transferFunction = nullptr;
        applied_.additions = nullptr;
        MACULA_TRY_VOID(tracer.scene().setVolume(input_.volume));
        applied_.volume = input_.volume;
        if (interrupted()) return false;
    }
    // Before the transfer function: what is hidden is not brought to the device.
    if (applied_.clip != drawing.clip) {
        if (applied_.transferFunction) listener_(Preparing{"Preparing what is shown"});
        traced_->sceneChanged();
        outlineOf_.reset();
        applied_.clip.reset();
        MACULA_TRY_VOID(tracer.scene().setClip(drawing.clip ? *drawing.clip : Clip{}));
        applied_.clip = drawing.clip;
        if (interrupted()) return false;
    }
    if (applied_.additions != drawing.additions) {
        traced_->sceneChanged();
        // Other segments, or other colours of them, take little time and change no outline.
        if (!isSameMatter(applied_.additions, drawing.additions)) {
            if (applied_.transferFunction) listener_(Preparing{"Preparing what is shown"});
            outlineOf_.reset();
        }
        applied_.additions.reset();
        MACULA_TRY_VOID(tracer.scene().setAdditions(drawing.additions ? *drawing.additions : Additions{}));
        applied_.additions = drawing.additions;
        if (interrupted()) return false;
    }
    if (applied_.transferFunction != drawing.transferFunction) {
        // Until it is there, what is on screen is what was wanted before.
        if (applied_.transferFunction) listener_(Preparing{"Preparing what is shown"});
        traced_->sceneChanged();
        outlineOf_.reset();
        applied_.transferFunction = nullptr;
        MACULA_TRY_VOID(tracer.scene().setTransferFunction(*drawing.transferFunction));
        applied_.transferFunction = drawing.transferFunction;
        if (interrupted()) return false;
    }
    if (applied_.lights != drawing.lights) {
        traced_->sceneChanged();
        applied_.lights = nullptr;
        MACULA_TRY_VOID(tracer.scene().setEnvironment(trace::Environment::fromRig(*drawing.lights)));
        applied_.lights = drawing.lights;
    }
    if (outlineOf_ != input_.study) {
        MACULA_TRY(std::vector<glm::dvec3> outline, tracer.outlineMm());
        listener_(
            OutlineFound{input_.study, std::make_shared<const std::vector<glm::dvec3>>(std::move(outline))});
        outlineOf_ = input_.study;
    }
    return true;
}

// From here on no picture of the model of before is drawn any more.
Result<void> FrameRenderer::applyModel() {
    const TimelineStage stage("set model");
    whyNoModel_ = hybrid::ModelStage::none;
    if (!canHaveModel()) {
        if (model_) model_->hide();
        hybrid_.reset();
        return {};
    }
    if (!shelf_) shelf_ = std::make_shared<hybrid::ModelShelf>(kShelfBytes);
    if (!model_) {
        auto made = hybrid::LiveModel::create(device_, traced_->tracer(), shelf_, keeper_,
                                              hybrid::liveModelOptions(*device_));
        if (!made) return withoutModel(made.error());
        model_.emplace(*std::move(made));
    }
    const std::string key = sceneNames_.of(input_.study, input_.drawing);
    if (key == model_->key() && !model_->canBeDrawn() && !model_->hasWork()) return {};  // it was given up
    const bool isNew = !hybrid_;
    if (isNew) {
        auto made = hybrid::HybridFrame::create(device_, traced_->tracer());
        if (!made) return withoutModel(made.error());
        hybrid_.emplace(*std::move(made));
    }
    if (isNew || key != model_->key() || hybrid_->exposure() != input_.drawing.settings.exposure ||
        hybrid_->toneMap() != input_.drawing.settings.toneMap) {
        if (const Result<void> set = hybrid_->setScene(input_.drawing.settings); !set)
            return withoutModel(set.error());
    }
    if (const Result<void> shown = model_->show(key, input_.drawing.settings); !shown)
        return withoutModel(shown.error());
    modelOf_ = input_.drawing;
    tellOfModel();
    return {};
}

hybrid::ModelNews FrameRenderer::modelNews() const {
    return model_ ? model_->news() : hybrid::ModelNews{.stage = whyNoModel_};
}

std::optional<hybrid::PeripheralReport> FrameRenderer::modelReport() const {
    return model_ ? model_->report() : std::nullopt;
}

// Tells of the model no more often than a person can read it.
void FrameRenderer::tellOfModel() {
    const hybrid::ModelNews news = modelNews();
    const Clock::time_point now = Clock::now();
    if (news == modelTold_ || (news.stage == modelTold_.stage && now - modelToldAt_ < kModelToldEvery))
        return;
    modelTold_ = news;
    modelToldAt_ = now;
    listener_(ModelChanged{input_.study, news});
}

void FrameRenderer::tellOfTime() {
    const Clock::time_point now = Clock::now();
    if (now - timeToldAt_ < kTimeToldEvery) return;
    timeToldAt_ = now;
    listener_(TimeSpent{timeline_.stages()});
}

void FrameRenderer::handle(Error error) {
    // An error of another kind may have come of the loss; and a device that is lost while it is created is
    // not there to be asked.
    if ((device_ && device_->lost()) || error.code == ErrorCode::deviceLost) {
        dropDevice();
        if (losses_.mayGoOn()) {
            duty_.startedAgain();  // hasWork() is true without a device: the next step makes a new one
            log::warning("The graphics device was lost; starting it again.");
            listener_(DeviceRestarting{});
            return;
        }
        error = gpu::lostTooOften();
        duty_.lostTooOften();
    }
    duty_.failed();
    if (traced_) traced_->sceneChanged();  // the content of its film is unknown
    try {
        const Result<void> cleared = screen_ ? clearWindow() : Result<void>{};
        if (!cleared) {
            log::warning("{}", cleared.error().message);
            releaseScreen();
        }
    } catch (const std::exception&) {
        log::warning(
            "The window could not be cleared.");  // this must not keep the first error from being reported
        releaseScreen();
    }
    listener_(RenderFailure{
        .error = error, .inputSequence = input_.sequence, .pictureRemains = !screen_ || duty_.isForeign()});
}

void FrameRenderer::dropDevice() {
    releaseScreen();
    hybrid_.reset();
    estimate_.reset();
    dropModelAfter(&hybrid::LiveModel::save);
    traced_.reset();
    device_.reset();
    applied_ = {};
}

void FrameRenderer::releaseScreen() {
    if (const Result<void> closed = closeScreen(); !closed) log::warning("{}", closed.error().message);
}

Result<void> FrameRenderer::closeScreen() {
    if (!screen_) return {};
    std::unique_ptr<Screen> screen = std::exchange(screen_, nullptr);
    if (device_->lost()) return {};  // dropping it is all that is left to do
    MACULA_TRY_VOID(device_->waitForAll());
    screen.reset();
    // Dropping only queued the destruction; a surface may go only after its swapchain is really gone.
    MACULA_TRY_VOID(device_->waitForAll());
    device_->destroyUnused();
    return {};
}

}  // namespace macula::live
