#include "live/frame/course_steps.h"

#include <thread>
#include <utility>

#include "base/check.h"
#include "base/timeline.h"

namespace macula::live {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kHandRests{150};
constexpr milliseconds kHandIsAskedEvery{2};
// How long searching and learning take at a time. A dispatch and a step of training may take longer on a CPU.
constexpr double kSliceMs = 40.0;
constexpr double kQuickMs = 250.0;  // a full-size picture that comes sooner needs no small ones before

double millisecondsBetween(std::chrono::steady_clock::time_point from,
                           std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

}  // namespace

void CourseSteps::hear(const FrameInput& input) {
    rhythm_.input(input.published, input.interacting);
    hasLearntBesideHand_ = false;
}

void CourseSteps::tellCourse() {
    models_.forgetNeedlessEstimate();
    course_.setHand(input_.interacting);
    course_.setPreviewLimit(TracedPictures::previewLimit(input_));
    course_.setFovea(models_.wantsFovea(input_));
    ModelState state = ModelState::none;
    const bool works = models_.hasWork() && !input_.convergesNow;
    if (models_.canDrawModel())
        state = models_.hasFit() ? ModelState::ready : ModelState::young;
    else if (works)
        state = ModelState::searching;
    course_.setModel(state, works);
    course_.setPhases(!input_.convergesNow && !input_.interacting && models_.hasPhaseWork(input_));
    course_.setEstimate(models_.drawsEstimate(input_));
    course_.setLearnsBesideHand(works && learnsBesideHand());
    course_.setQuick(isQuick());
}

// Once per input, because a hand that holds the picture will move it soon. Not on a CPU device: there frames
// and training share the cores, and a training step takes longer than a frame may be late.
bool CourseSteps::learnsBesideHand() const {
    return input_.interacting && !hasLearntBesideHand_ && models_.canDrawModel() &&
           !device_.device()->isCpu() && rhythm_.leftMs(Clock::now()) > 0.0;
}

bool CourseSteps::isQuick() const {
    return device_.isReady() && !device_.device()->isCpu() && input_.volume &&
           device_.traced()->expectedFullMs(input_) <= kQuickMs;
}

void CourseSteps::begin() {
    course_.want(device_.traced()->hasFull(input_));
}

Result<void> CourseSteps::takeNext(const Interrupts& interrupts) {
    Result<void> done = take(course_.next(Clock::now()), interrupts);
    // Traced pictures matter more: without the model there may be enough memory for them.
    const bool isEstimate = models_.drawsEstimate(input_);
    if (done || done.error().code != ErrorCode::outOfMemory || (!isEstimate && !models_.isModelDrawable()))
        return done;
    duty_.beginAnew();
    device_.traced()->roomChanged();
    return withoutSplats(isEstimate, done.error());
}

Result<void> CourseSteps::take(Step step, const Interrupts& interrupts) {
    const TimelineStage stage(nameOf(step));
    switch (step) {
        case Step::none:
            return {};
        case Step::showModel: {
            MACULA_TRY_VOID(showModel());
            // Otherwise a hand that never rests would leave no time for the fovea.
            if (course_.next(Clock::now()) != Step::traceFovea || !models_.hasTimeForFovea(input_)) return {};
            MACULA_TRY(const bool isThere, models_.traceFovea(input_, interrupts));
            return isThere && !interrupts.newInput() ? showModel() : Result<void>();
        }
        case Step::traceFovea: {
            MACULA_TRY(const bool isThere, models_.traceFovea(input_, interrupts));
            return isThere ? showModel() : Result<void>();
        }
        case Step::showPreview:
            return showPreview(interrupts);
        case Step::search:
            return search(interrupts);
        case Step::trace:
            return trace(interrupts);
        case Step::showTraced:
            return showTraced();
        case Step::fade:
            return fade();
        case Step::learn:
            return learn(interrupts);
        case Step::learnPhases:
            return learnPhases(interrupts);
    }
    return {};
}

Result<void> CourseSteps::withoutSplats(bool isEstimate, const Error& error) {
    return isEstimate ? models_.withoutEstimate(error) : models_.withoutModel(input_, error);
}

Result<void> CourseSteps::showModel() {
    const bool isEstimate = models_.drawsEstimate(input_);
    if (!models_.canDrawModel() && !isEstimate) {  // it was given up meanwhile
        duty_.beginAnew();
        return {};
    }
    MACULA_CHECK(isEstimate || models_.isModelOf(input_));
    const auto picture = models_.draw(input_, 0.0f);
    // A small picture comes next.
    if (!picture) return withoutSplats(isEstimate, picture.error());
    isEstimate ? course_.showedEstimate() : course_.showedModel();
    MACULA_TRY_VOID(show(**picture));
    // One picture in flight: a longer queue would show where the hand was, not where it is.
    return device_.device()->waitForAll();
}

Result<bool> CourseSteps::showEstimate(const Interrupts& interrupts) {
    MACULA_TRY(const bool isEstimated, models_.estimateEdit(input_));
    if (!isEstimated) return false;
    course_.want(false);
    MACULA_TRY_VOID(showModel());
    // Counts from the first estimate of the drawing: inputs that keep it, as in orbiting, may never end.
    const bool isFirst = !editShownAt_;
    if (isFirst) editShownAt_ = Clock::now();
    const auto rests = [&] { return Clock::now() - *editShownAt_ >= kHandRests; };
    if (isFirst && interrupts.any()) return true;
    while (!interrupts.any() && !rests()) std::this_thread::sleep_for(kHandIsAskedEvery);
    return !rests();
}

Result<void> CourseSteps::showPreview(const Interrupts& interrupts) {
    TracedPictures& traced = *device_.traced();
    if (course_.onScreen() != OnScreen::preview) MACULA_TRY_VOID(traced.beginPreview(input_));
    MACULA_TRY(const bool isWhole, traced.tracePreview(input_, [&] { return !interrupts.stopping(); }));
    if (!isWhole) return {};
    const Clock::time_point tracedAt = Clock::now();
    MACULA_TRY(const gpu::Image* picture, traced.display(input_.background));
    MACULA_TRY_VOID(device_.device()->waitForAll());
    const Clock::time_point developedAt = Clock::now();
    course_.showedPreview(traced.previewSamples(), developedAt);
    MACULA_TRY_VOID(show(*picture));
    MACULA_TRY_VOID(device_.device()->waitForAll());
    traced.previewWasShown(millisecondsBetween(tracedAt, developedAt),
                           millisecondsBetween(developedAt, Clock::now()));
    return {};
}

Result<void> CourseSteps::trace(const Interrupts& interrupts) {
    TracedPictures& traced = *device_.traced();
    const auto keepGoing = [&] { return !interrupts.any(); };
    const Clock::time_point start = Clock::now();
    MACULA_TRY_VOID(traced.beginFull(input_));
    MACULA_TRY(const TracedPictures::Progress progress, traced.traceFull(input_, keepGoing));
    const Clock::time_point now = Clock::now();
    course_.spent(Step::trace, millisecondsBetween(start, now));
    if (!progress.isNews) return {};
    course_.traced(progress.isLast);
    MACULA_TRY_VOID(models_.keepForMotion(input_));
    return course_.onScreen() == OnScreen::fading ? Result<void>() : showTraced();
}

Result<void> CourseSteps::showTraced() {
    MACULA_TRY(const gpu::Image* picture, models_.drawTraced(input_));
    course_.showedTraced();
    return show(*picture);
}

Result<void> CourseSteps::fade() {
    const Clock::time_point now = Clock::now();
    const auto picture = models_.draw(input_, static_cast<float>(course_.tracedShare(now)));
    if (!picture) {  // the traced picture exists
        MACULA_TRY_VOID(withoutSplats(models_.drawsEstimate(input_), picture.error()));
        return showTraced();
    }
    course_.faded(now);
    MACULA_TRY_VOID(show(**picture));
    return device_.device()->waitForAll();
}

// After a slice of the model's search or training.
Result<void> CourseSteps::noteWork(const Result<void>& done) {
    if (!done) return models_.withoutModel(input_, done.error());
    models_.tellOfModel(input_);
    return {};
}

Result<void> CourseSteps::search(const Interrupts& interrupts) {
    course_.searched();
    const Clock::time_point start = Clock::now();
    const Result<void> done = models_.work(kSliceMs, [&] { return !interrupts.any(); });
    course_.spent(Step::search, millisecondsBetween(start, Clock::now()));
    return noteWork(done);
}

Result<void> CourseSteps::learn(const Interrupts& interrupts) {
    const auto keepGoing = [&] { return !interrupts.any(); };
    if (course_.onScreen() == OnScreen::model) return learnBesideHand(keepGoing);
    const Clock::time_point start = Clock::now();
    const Result<void> done = models_.work(kSliceMs, keepGoing);
    course_.spent(Step::learn, millisecondsBetween(start, Clock::now()));
    return noteWork(done);
}

// Within the time that is left before the next input is due.
Result<void> CourseSteps::learnBesideHand(const std::function<bool()>& keepGoing) {
    hasLearntBesideHand_ = true;
    return noteWork(models_.workWithin(rhythm_.leftMs(Clock::now()), keepGoing));
}

Result<void> CourseSteps::learnPhases(const Interrupts& interrupts) {
    const Clock::time_point start = Clock::now();
    MACULA_TRY_VOID(models_.learnPhases(input_, kSliceMs, [&] { return !interrupts.any(); }));
    course_.spent(Step::learnPhases, millisecondsBetween(start, Clock::now()));
    return {};
}

Result<bool> CourseSteps::showPlayed() {
    if (!models_.canPlay(input_)) return false;
    // A person who steps through phases sees the next one at once; then it is traced.
    if (!input_.playsPhases && models_.hasModel() && models_.isModelOf(input_)) return false;
    course_.want(false);
    const auto picture = models_.drawPlayed(input_);
    if (!picture) {
        MACULA_TRY_VOID(models_.withoutPlayed(picture.error()));
        return false;
    }
    course_.showedModel();
    MACULA_TRY_VOID(show(**picture));
    MACULA_TRY_VOID(device_.device()->waitForAll());
    return input_.playsPhases;
}

Result<void> CourseSteps::showAgain() {
    if (course_.onScreen() == OnScreen::nothing) return {};
    if (isOfSplats(course_.onScreen())) return showModel();
    if (course_.onScreen() == OnScreen::traced) {
        MACULA_TRY(const gpu::Image* picture, models_.drawTraced(input_));
        return show(*picture);
    }
    if (course_.onScreen() == OnScreen::preview) {
        MACULA_TRY(const gpu::Image* picture, device_.traced()->display(input_.background));
        return show(*picture);
    }
    const auto picture = models_.draw(input_, static_cast<float>(course_.tracedShare(Clock::now())));
    if (!picture) {
        duty_.beginAnew();
        return withoutSplats(models_.drawsEstimate(input_), picture.error());
    }
    return show(**picture);
}

Result<void> CourseSteps::show(const gpu::Image& picture) {
    const TimelineStage stage("show");
    const OnScreen kind = course_.onScreen();
    MACULA_TRY(const PictureOnScreen::Put put, screen_.put(picture, input_, kind));
    FrameShown frame{.inputSequence = input_.sequence,
                     .study = input_.study,
                     .phase = input_.phase,
                     .letters = input_.letters,
                     .camera = input_.camera,
                     .picture = kind,
                     .width = input_.width,
                     .height = input_.height,
                     .sampleLimit = TracedPictures::sampleLimit(input_),
                     .noiseTarget = input_.noiseTarget,
                     .look = input_.drawing.settings.look,
                     .remarks = input_.drawing.remarks,
                     .framesPerSecond = put.framesPerSecond,
                     .latencyMs = millisecondsBetween(input_.published, put.at)};
    frame.model = models_.news();
    if (isOfSplats(kind)) {
        const hybrid::Frame& last = models_.lastFrame();
        frame.foveaAgeMs = last.foveaAgeMs;
        frame.foveaSamples = last.foveaSamples;
        frame.foveaShare = last.foveaShare;
    }
    frame.greyFacesAreCoarse = isOfSplats(kind) && scene::hasGreyFaces(input_.drawing);
    frame.mixesModel = kind == OnScreen::traced && models_.mixesModel();
    MACULA_TRY_VOID(addTraced(frame));
    screen_.report(std::move(frame), put.isVisible);
    return {};
}

// Adds the tracer's statistics of a picture that is traced, wholly or in part, and its messages.
Result<void> CourseSteps::addTraced(FrameShown& frame) {
    TracedPictures& traced = *device_.traced();
    const bool isFull = frame.picture == OnScreen::traced || frame.picture == OnScreen::fading;
    if (isFull) frame.stage = course_.hasConverged() ? Stage::converged : Stage::converging;
    if (isFull || frame.picture == OnScreen::preview) {
        MACULA_TRY(const trace::Statistics statistics, traced.statistics());
        frame.width = traced.width();
        frame.height = traced.height();
        frame.scale = traced.scale();
        frame.samplesPerPixel = static_cast<std::uint64_t>(statistics.meanSamplesPerPixel);
        frame.noise = statistics.estimatedError;
        frame.denoised = statistics.denoised;
        frame.samplesLeftOut = statistics.nonFiniteSamples + statistics.abandonedSamples;
    }
    // Behind an estimate or a played phase, the tracer may still have the previous scene.
    if (frame.picture != OnScreen::estimate && !models_.isPlayed())
        frame.messages = traced.tracer().messages();
    return {};
}

}  // namespace macula::live
