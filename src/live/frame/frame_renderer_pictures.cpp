// What a frame renderer shows: a function for each step of its course.
#include <cmath>
#include <new>
#include <thread>
#include <utility>

#include "base/check.h"
#include "base/log.h"
#include "live/frame/frame_renderer.h"
#include "pipeline/hybrid/frame/fovea_size.h"

namespace macula::live {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kRateWindow{2000};
constexpr milliseconds kHandRests{150};
constexpr milliseconds kHandIsAskedEvery{2};
// How long searching and learning take at a time. A dispatch and a step of training may take longer on a CPU.
constexpr double kSliceMs = 40.0;
// A picture on screen is worth learning from with so many: fewer are noise, and later the model knows most.
constexpr std::uint32_t kLearntFromSamples = 4;

double millisecondsBetween(std::chrono::steady_clock::time_point from,
                           std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

}  // namespace

Result<void> FrameRenderer::take(Step step, const Interrupts& interrupts) {
    const TimelineStage stage(nameOf(step));
    switch (step) {
        case Step::none:
            return {};
        case Step::showModel: {
            MACULA_TRY_VOID(showModel());
            // A hand that never rests would else leave no time for the fovea.
            if (course_.next(Clock::now()) != Step::traceFovea ||
                hybrid_->foveaBudgetMs(input_.live.foveaMs) < hybrid::kLeastFoveaBudgetMs)
                return {};
            MACULA_TRY(const bool isThere, traceFovea(interrupts));
            return isThere && !interrupts.newInput() ? showModel() : Result<void>();
        }
        case Step::traceFovea: {
            MACULA_TRY(const bool isThere, traceFovea(interrupts));
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
    }
    return {};
}

Result<void> FrameRenderer::showModel() {
    const bool isEstimate = drawsEstimate();
    if (!canDrawModel() && !isEstimate) {  // it was given up meanwhile
        duty_.beginAnew();
        return {};
    }
    // No model is drawn of another patient, preset, clip or light than those of the picture that is wanted
    // now.
    MACULA_CHECK(isEstimate || model_->key() == sceneNames_.of(input_.study, input_.drawing));
    const auto picture = frame(0.0f);
    // A small picture comes next.
    if (!picture) return isEstimate ? withoutEstimate(picture.error()) : withoutModel(picture.error());
    isEstimate ? course_.showedEstimate() : course_.showedModel();
    MACULA_TRY_VOID(show(**picture));
    // One picture in flight: a longer queue would show where the hand was, not where it is.
    return device_->waitForAll();
}

// An estimate is better than a model that is not fit yet.
bool FrameRenderer::drawsEstimate() const {
    return hybrid_ && estimate_ && input_.usesModel && !hasFitModel() &&
           estimate_->isOf(input_.volume, input_.drawing);
}

// What estimates are made from: the last model that was fit, before what it is of is changed.
void FrameRenderer::noteLearnt() {
    if (!estimate_) estimate_.emplace(device_);
    if (hasFitModel() && model_->key() != sceneNames_.of(input_.study, input_.drawing))
        estimate_->learnt(input_.volume, modelOf_, model_->shown(), model_->gain());
    estimate_->begin(input_.volume, input_.drawing);
}

// Of what is wanted now, where there is no more of it yet.
Result<void> FrameRenderer::makeEstimate() {
    if (!hybrid_ || !model_ || !estimate_ || !estimateHasRoom_ || hasFitModel() || !canHaveModel()) return {};
    if (!estimate_->canTell(input_.volume, input_.drawing)) return {};
    const Result<void> made = workOnModel([&] { return estimate_->make(input_.drawing); });
    return made ? Result<void>() : withoutEstimate(made.error());
}

// Whatever keeps an estimate from being made or drawn keeps nobody from learning and tracing.
Result<void> FrameRenderer::withoutEstimate(const Error& error) {
    if (device_->lost() || error.code == ErrorCode::deviceLost) return error;
    log::warning("There is no estimate of this: {}", error.message);
    estimate_->forget();
    estimateHasRoom_ = false;
    return {};
}

// A hand that edits is followed before the tracer has any of it: that takes long, and can wait until no edit
// has come for a moment.
Result<bool> FrameRenderer::showEstimate(const Interrupts& interrupts) {
    noteLearnt();
    if (!hybrid_ || !model_ || !shelf_) return false;
    const std::string key = sceneNames_.of(input_.study, input_.drawing);
    if (key == model_->key() || shelf_->find(key)) return false;  // there is more than an estimate
    model_->hide();
    MACULA_TRY_VOID(makeEstimate());
    if (!drawsEstimate()) return false;
    hybrid_->forgetFovea();
    course_.want(false);
    MACULA_TRY_VOID(showModel());
    // Of other inputs, as of a hand that orbits, there may be any number.
    const bool isFirst = !editShownAt_;
    if (isFirst) editShownAt_ = Clock::now();
    const auto rests = [&] { return Clock::now() - *editShownAt_ >= kHandRests; };
    const auto isPassed = [&] { return interrupts.newInput() || interrupts.stopping(); };
    if (isFirst && isPassed()) return true;
    while (!isPassed() && !rests()) std::this_thread::sleep_for(kHandIsAskedEvery);
    return !rests();
}

double FrameRenderer::foveaMsPerSample() const {
    return hybrid_->foveaMsPerSample().value_or(hybrid::guessedFoveaMsPerSample(*device_));
}

// At rest a small one at once, and larger ones after it, where all pixels take longer still.
bool FrameRenderer::wantsFovea() const {
    if (!canDrawModel() || drawsEstimate() || !foveaHasRoom_ || isParallel(input_.camera)) return false;
    if (input_.interacting) return input_.live.hasFovea && hybrid_->wantsFovea(input_.camera, input_.gaze);
    const double wholeMs = double(input_.width) * input_.height * foveaMsPerSample();
    return wholeMs > hybrid::kRestFoveaBudgetMs &&
           hybrid_->wouldGrow(input_.camera, hybrid::kRestFoveaBudgetMs, input_.gaze);
}

hybrid::FoveaAim FrameRenderer::nextFovea() const {
    const trace::View whole{.camera = input_.camera, .width = input_.width, .height = input_.height};
    const bool isLarger = !input_.interacting && hybrid_->isFoveaOf(input_.camera, input_.gaze);
    if (input_.interacting)
        return hybrid::affordableFovea(whole, input_.gaze, foveaMsPerSample(),
                                       hybrid_->foveaBudgetMs(input_.live.foveaMs), input_.live.fovea);
    return hybrid::affordableFovea(whole, input_.gaze, foveaMsPerSample(),
                                   isLarger ? hybrid::kRestFoveaBudgetMs : hybrid::kFoveaBudgetMs);
}

// For a slice, and longer until a new input comes. Whether a new fovea is there.
Result<bool> FrameRenderer::traceFovea(const Interrupts& interrupts) {
    const TimelineStage stage(nameOf(Step::traceFovea));
    const Clock::time_point start = Clock::now();
    const auto keepGoing = [&] {
        return !interrupts.stopping() && (!interrupts.newInput() || millisecondsBetween(start, Clock::now()) <
                                                                        input_.live.betweenFramesMs);
    };
    const auto traceSome = [&]() -> Result<bool> {
        if (!hybrid_->isTracing() || hybrid_->hasLeftAim(input_.camera))
            MACULA_TRY_VOID(hybrid_->aim(nextFovea()));
        return hybrid_->traceFovea(keepGoing);
    };
    Result<bool> isThere = traceSome();
    if (isThere || isThere.error().code != ErrorCode::outOfMemory) return isThere;
    doWithoutFovea();
    return false;
}

void FrameRenderer::doWithoutFovea() {
    log::warning("There is no room on the device for a traced fovea.");
    hybrid_->forgetFovea();
    foveaHasRoom_ = false;
}

Result<void> FrameRenderer::showPreview(const Interrupts& interrupts) {
    if (course_.onScreen() != OnScreen::preview) MACULA_TRY_VOID(traced_->beginPreview(input_));
    MACULA_TRY(const bool isWhole, traced_->tracePreview(input_, [&] { return !interrupts.stopping(); }));
    if (!isWhole) return {};
    const Clock::time_point traced = Clock::now();
    MACULA_TRY(const gpu::Image* picture, traced_->display(input_.background));
    MACULA_TRY_VOID(device_->waitForAll());
    const Clock::time_point developed = Clock::now();
    course_.showedPreview(traced_->previewSamples(), developed);
    MACULA_TRY_VOID(show(*picture));
    MACULA_TRY_VOID(device_->waitForAll());
    traced_->previewWasShown(millisecondsBetween(traced, developed),
                             millisecondsBetween(developed, Clock::now()));
    return {};
}

Result<void> FrameRenderer::trace(const Interrupts& interrupts) {
    const auto keepGoing = [&] { return !interrupts.newInput() && !interrupts.stopping(); };
    const Clock::time_point start = Clock::now();
    MACULA_TRY_VOID(traced_->beginFull(input_));
    MACULA_TRY(const TracedPictures::Progress progress, traced_->traceFull(input_, keepGoing));
    const Clock::time_point now = Clock::now();
    course_.spent(Step::trace, millisecondsBetween(start, now));
    if (!progress.isNews) return {};
    course_.traced(progress.isLast);
    MACULA_TRY_VOID(keepForMotion());
    return course_.onScreen() == OnScreen::fading ? Result<void>() : showTraced();
}

// What is traced while nothing moves is the fovea of the first frames of the next motion. Where it is not
// denoised any more its guides may be gone; the one of before was of fewer samples, and does.
Result<void> FrameRenderer::keepForMotion() {
    const TimelineStage stage("keep for motion");
    // A fovea is reprojected, and a model learns, for an eye; with parallel rays splats alone are shown.
    if (!canDrawModel() || !foveaHasRoom_ || isParallel(input_.camera)) return {};
    MACULA_TRY(const trace::Statistics statistics, traced_->statistics());
    if (!statistics.denoised) return {};
    const trace::View view{.camera = input_.camera, .width = traced_->width(), .height = traced_->height()};
    const auto samples = static_cast<std::uint32_t>(statistics.meanSamplesPerPixel);
    const Result<void> kept =
        hybrid_->adopt(traced_->tracer(), {.whole = view, .gaze = input_.gaze, .samplesPerPixel = samples});
    if (!kept && kept.error().code != ErrorCode::outOfMemory) return kept.error();
    if (!kept) doWithoutFovea();
    if (samples < kLearntFromSamples) return {};
    if (const Result<void> learnt = model_->learnFrom(traced_->tracer(), view, samples); !learnt)
        return withoutModel(learnt.error());
    return {};
}

Result<void> FrameRenderer::showTraced() {
    MACULA_TRY(const gpu::Image* picture, tracedPicture());
    course_.showedTraced();
    return show(*picture);
}

// Where splats are better they stay, until the noise cannot be seen: what is shown does not get worse.
Result<const gpu::Image*> FrameRenderer::tracedPicture() {
    mixesModel_ = false;
    if (!traced_->isNoisy() || !(hasFitModel() || drawsEstimate()))
        return traced_->display(input_.background);
    Result<const gpu::Image*> weighed = frame(1.0f);
    if (weighed) return weighed;
    // Without the memory for it the model may still do for frames in motion.
    if (drawsEstimate()) {
        MACULA_TRY_VOID(withoutEstimate(weighed.error()));
    } else if (weighed.error().code != ErrorCode::outOfMemory) {
        MACULA_TRY_VOID(withoutModel(weighed.error()));
    }
    return traced_->display(input_.background);
}

Result<void> FrameRenderer::fade() {
    const Clock::time_point now = Clock::now();
    const auto picture = frame(static_cast<float>(course_.tracedShare(now)));
    if (!picture) {  // what it fades into is there
        MACULA_TRY_VOID(drawsEstimate() ? withoutEstimate(picture.error()) : withoutModel(picture.error()));
        return showTraced();
    }
    course_.faded(now);
    MACULA_TRY_VOID(show(**picture));
    return device_->waitForAll();
}

// A slice of the model's search or training.
Result<void> FrameRenderer::workOnModel(const std::function<Result<void>()>& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        if (device_->lost()) throw;
        return Error{ErrorCode::outOfMemory, "There is not enough memory for it.", {}, {}};
    }
}

Result<void> FrameRenderer::search(const Interrupts& interrupts) {
    const auto keepGoing = [&] { return !interrupts.newInput() && !interrupts.stopping(); };
    course_.searched();
    const Clock::time_point start = Clock::now();
    const Result<void> done = workOnModel([&] { return model_->work(kSliceMs, keepGoing); });
    course_.spent(Step::search, millisecondsBetween(start, Clock::now()));
    if (!done) return withoutModel(done.error());
    tellOfModel();
    return {};
}

Result<void> FrameRenderer::learn(const Interrupts& interrupts) {
    const auto keepGoing = [&] { return !interrupts.newInput() && !interrupts.stopping(); };
    if (course_.onScreen() == OnScreen::model) return learnBesideHand(keepGoing);
    const Clock::time_point start = Clock::now();
    const Result<void> done = workOnModel([&] { return model_->work(kSliceMs, keepGoing); });
    course_.spent(Step::learn, millisecondsBetween(start, Clock::now()));
    if (!done) return withoutModel(done.error());
    tellOfModel();
    return {};
}

// In what the frame that is on screen has left of the time until the next.
Result<void> FrameRenderer::learnBesideHand(const std::function<bool()>& keepGoing) {
    hasLearntBesideHand_ = true;
    const double leftMs = rhythm_.leftMs(Clock::now());
    const Result<void> done = workOnModel([&] { return model_->workWithin(leftMs, keepGoing); });
    if (!done) return withoutModel(done.error());
    tellOfModel();
    return {};
}

// Shows the picture that is on screen over another background.
Result<void> FrameRenderer::showAgain() {
    if (course_.onScreen() == OnScreen::nothing) return {};
    if (isOfSplats(course_.onScreen())) return showModel();
    if (course_.onScreen() == OnScreen::traced) {
        MACULA_TRY(const gpu::Image* picture, tracedPicture());
        return show(*picture);
    }
    if (course_.onScreen() == OnScreen::preview) {
        MACULA_TRY(const gpu::Image* picture, traced_->display(input_.background));
        return show(*picture);
    }
    const auto picture = frame(static_cast<float>(course_.tracedShare(Clock::now())));
    if (!picture) {
        duty_.beginAnew();
        return drawsEstimate() ? withoutEstimate(picture.error()) : withoutModel(picture.error());
    }
    return show(**picture);
}

// The model with the fovea over it, and the traced picture of all pixels with that share. Where the model was
// given up while it fades, that picture alone: it is of what is wanted.
Result<const gpu::Image*> FrameRenderer::frame(float tracedShare) {
    lastFrame_ = {};
    mixesModel_ = false;
    const bool isEstimate = drawsEstimate();
    if (!canDrawModel() && !isEstimate) return traced_->display(input_.background);
    const hybrid::Periphery periphery{
        .draw = [&](const Camera& eye, const glm::ivec2& sizePx) -> Result<hybrid::DrawnSplats> {
            if (isEstimate) return estimate_->draw(eye, sizePx);
            MACULA_TRY(const splat::DevicePicture* picture, model_->draw(eye, sizePx));
            return hybrid::DrawnSplats{picture, &model_->drawnDepths()};
        },
        .gain = static_cast<float>(isEstimate ? estimate_->gain() : model_->gain()),
        .isLikeness = !isEstimate};
    hybrid::FrameRequest request{.eyes = {input_.camera},
                                 .sizePx = {input_.width, input_.height},
                                 .display = {.background = input_.background,
                                             .exposure = float(input_.drawing.settings.exposure),
                                             .toneMap = input_.drawing.settings.toneMap}};
    if (tracedShare > 0.0f) {
        MACULA_TRY(const trace::TracedLight light, traced_->light());
        request.fadingIn = {.light = light, .share = tracedShare};
    }
    Result<hybrid::Frame> drawn = hybrid_->draw(request, periphery);
    // Rather without the fovea than without the model.
    if (!drawn && drawn.error().code == ErrorCode::outOfMemory && canDrawModel() && hybrid_->hasFovea()) {
        doWithoutFovea();
        drawn = hybrid_->draw(request, periphery);
    }
    MACULA_TRY(lastFrame_, std::move(drawn));
    mixesModel_ = request.fadingIn && request.fadingIn->light.variances != nullptr;
    return std::exchange(lastFrame_.pictures, {}).front();
}

Result<void> FrameRenderer::show(const gpu::Image& picture) {
    const TimelineStage stage("show");
    screen_->setMarks(input_.marks);
    kept_ = {input_.camera, input_.width, input_.height};
    MACULA_TRY(const bool visible, screen_->show(picture));
    const Clock::time_point now = Clock::now();
    const OnScreen kind = course_.onScreen();
    // The frame rate is that of the kind of picture that is shown now.
    if (std::exchange(shownKind_, kind) != kind) shown_.clear();
    if (visible) {
        duty_.showedOurs();
        shown_.push_back(now);
    }
    while (!shown_.empty() && now - shown_.front() > kRateWindow) shown_.pop_front();
    FrameShown frame{.inputSequence = input_.sequence,
                     .study = input_.study,
                     .letters = input_.letters,
                     .camera = input_.camera,
                     .picture = kind,
                     .width = input_.width,
                     .height = input_.height,
                     .sampleLimit = TracedPictures::sampleLimit(input_),
                     .noiseTarget = input_.noiseTarget,
                     .look = input_.drawing.settings.look,
                     .remarks = input_.drawing.remarks,
                     .framesPerSecond = framesPerSecond(),
                     .latencyMs = millisecondsBetween(input_.published, now)};
    frame.model = modelNews();
    if (isOfSplats(kind)) {
        frame.foveaAgeMs = lastFrame_.foveaAgeMs;
        frame.foveaSamples = lastFrame_.foveaSamples;
        frame.foveaShare = lastFrame_.foveaShare;
    }
    frame.greyFacesAreCoarse = isOfSplats(kind) && scene::hasGreyFaces(input_.drawing);
    frame.mixesModel = kind == OnScreen::traced && mixesModel_;
    const bool isTraced = kind == OnScreen::traced || kind == OnScreen::fading;
    if (isTraced) frame.stage = course_.hasConverged() ? Stage::converged : Stage::converging;
    if (isTraced || kind == OnScreen::preview) {
        MACULA_TRY(const trace::Statistics statistics, traced_->statistics());
        frame.width = traced_->width();
        frame.height = traced_->height();
        frame.scale = traced_->scale();
        frame.samplesPerPixel = static_cast<std::uint64_t>(statistics.meanSamplesPerPixel);
        frame.noise = statistics.estimatedError;
        frame.denoised = statistics.denoised;
        frame.samplesLeftOut = statistics.nonFiniteSamples + statistics.abandonedSamples;
    }
    // The tracer may have what was wanted before.
    if (kind != OnScreen::estimate) frame.messages = traced_->tracer().messages();
    // The screen has kept a picture that could not be shown now; it is shown as soon as it can be.
    unreported_ = visible ? std::nullopt : std::optional(frame);
    if (visible) listener_(frame);
    return {};
}

double FrameRenderer::framesPerSecond() const {
    if (shown_.size() < 2) return 0.0;
    const double spanMs = millisecondsBetween(shown_.front(), shown_.back());
    return spanMs > 0.0 ? 1000.0 * double(shown_.size() - 1) / spanMs : 0.0;
}

}  // namespace macula::live
