#include "pipeline/hybrid/model/live_model.h"

#include <chrono>
#include <limits>
#include <new>
#include <thread>
#include <utility>

#include "base/check.h"
#include "base/log.h"
#include "base/timeline.h"
#include "pipeline/hybrid/model/initial_splats.h"
#include "pipeline/hybrid/model/model_start.h"
#include "pipeline/hybrid/views/view_tracing.h"

namespace macula::hybrid {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kStoreIsAskedEvery{2};
constexpr int kSideOnCpuPx = 384;  // a view of 2 samples is traced in half a second to one on two cores
constexpr int kRoughSideOnCpuPx = 192;
// Of a model that is sharp, as most are: where nothing is held out that could tell.
constexpr std::uint64_t kStepsOfSharpModels = 120;
// The model learns from a picture on screen again once it has so many times the samples: half the noise.
constexpr std::uint32_t kMoreSamples = 4;

double msSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// `goesOn`, which tells the pace how long each piece took that was done between two questions.
std::function<bool()> measuredBy(LearningPace& pace, LearningPart part, const std::function<bool()>& goesOn) {
    return [&pace, part, &goesOn, last = Clock::now()]() mutable {
        constexpr double kAskedTwiceMs = 0.01;
        const double ms = msSince(std::exchange(last, Clock::now()));
        if (ms > kAskedTwiceMs) pace.took(part, ms);
        return goesOn();
    };
}

bool isOutOfMemory(const Result<void>& done) {
    return !done && done.error().code == ErrorCode::outOfMemory;
}

}  // namespace

LiveModelOptions liveModelOptions(const gpu::Device& device) {
    LiveModelOptions options;
    if (device.isCpu()) {
        options.model.wanted.sizePx = glm::ivec2(kSideOnCpuPx);
        // A person waits for what comes before the model is sharp.
        options.points.count = 5000;
        options.points.candidatesPerPoint = 2;
        options.roughSidePx = kRoughSideOnCpuPx;
        options.roughSteps = 160;
    }
    return options;
}

LiveModel::LiveModel(std::shared_ptr<gpu::Device> device, trace::PathTracer tracer,
                     std::shared_ptr<ModelShelf> shelf, std::shared_ptr<ModelStore> store,
                     const LiveModelOptions& options)
    : device_(std::move(device)),
      tracer_(std::move(tracer)),
      shelf_(std::move(shelf)),
      store_(std::move(store)),
      options_(options) {}

Result<LiveModel> LiveModel::create(const std::shared_ptr<gpu::Device>& device,
                                    const trace::PathTracer& beside, std::shared_ptr<ModelShelf> shelf,
                                    std::shared_ptr<ModelStore> store, const LiveModelOptions& options) {
    MACULA_CHECK(shelf != nullptr);
    MACULA_TRY(trace::PathTracer tracer, beside.ofSameScene());
    if (options.dispatchMs) tracer.setDispatchMs(*options.dispatchMs);
    return LiveModel(device, std::move(tracer), std::move(shelf), std::move(store), options);
}

Result<void> LiveModel::show(const std::string& key, const trace::Settings& settings) {
    MACULA_CHECK(!key.empty() && trace::isPathTraced(settings.look));
    if (key == key_) return {};
    hide();
    key_ = key;
    settings_ = settings;
    settings_.denoising = trace::Denoising::little;
    settings_.errorThreshold = 0.0;
    Result<void> done = tryShow();
    if (isOutOfMemory(done)) {
        giveUp(ModelStage::noRoom);
        return {};
    }
    if (!done) hide();
    return done;
}

Result<void> LiveModel::tryShow() {
    MACULA_TRY_VOID(tracer_.setSettings(settings_));
    stage_ = ModelStage::searching;
    if (const std::shared_ptr<const PeripheralState> kept = shelf_->find(key_))
        return goOnWith(*kept, ModelOrigin::shelf);
    origin_ = ModelOrigin::points;
    if (!store_) return {};
    askingSince_ = Clock::now();
    // Where the answer is here already, the first picture is of the model.
    const StoredModel stored = store_->find(key_);
    return stored.answer == StoredModel::Answer::pending ? Result<void>() : takeFromStore(stored);
}

Result<void> LiveModel::goOnWith(const PeripheralState& state, ModelOrigin origin) {
    MACULA_TRY(model_, PeripheralModel::resume(device_, state, options_.model));
    origin_ = origin;
    views_ = state.asked;  // the gauge's pictures were given without being asked for
    stepsAtLastView_ = model_->report().training.steps;
    kept_ = {.steps = stepsAtLastView_, .generation = model_->shown().generation, .gain = state.gain};
    keptAt_ = Clock::now();
    gauge_.emplace(state.seenMm);  // to be made anew, while what was learnt can be drawn
    gain_ = state.gain;
    stage_ = ModelStage::learning;
    return {};
}

void LiveModel::beginWithPoints(ModelOrigin origin) {
    painter_.reset();
    drawn_.reset();
    gain_ = 1.0;
    origin_ = origin;
    stage_ = ModelStage::searching;
}

// Waits for the answer, as long as it may; whoever calls has other work in between.
Result<void> LiveModel::askStore(const std::function<bool()>& goesOn) {
    const TimelineStage stage("model: store");
    while (true) {
        const StoredModel stored = whole_ ? *whole_ : store_->find(key_);
        const bool isLate = Clock::now() - *askingSince_ > options_.mostWaitForStore;
        const bool isPending = stored.answer == StoredModel::Answer::pending ||
                               (stored.answer == StoredModel::Answer::drawable && painter_);
        if (!isPending || (isLate && stage_ == ModelStage::searching)) return takeFromStore(stored);
        if (!goesOn()) return {};
        std::this_thread::sleep_for(kStoreIsAskedEvery);
    }
}

Result<void> LiveModel::takeFromStore(const StoredModel& stored) {
    using Answer = StoredModel::Answer;
    if (stored.answer != Answer::drawable && stored.answer != Answer::whole) {
        askingSince_.reset();
        // What is drawn has gone from the store since, or the rest of it could not be read.
        if (stage_ == ModelStage::resuming) beginWithPoints(ModelOrigin::points);
    }
    switch (stored.answer) {
        case Answer::pending:  // for too long
        case Answer::none:
            return {};
        case Answer::damaged:
            beginWithPoints(ModelOrigin::damagedPoints);
            return {};
        case Answer::warm:
        case Answer::stale:
            origin_ = stored.answer == Answer::warm ? ModelOrigin::otherLights : ModelOrigin::otherTrainer;
            startWith_ = stored.splats;
            return {};
        case Answer::drawable:
            return drawStored(stored);
        case Answer::whole: {
            whole_ = stored;                           // the store gives it once
            if (!painter_) return drawStored(stored);  // first it is shown
            Result<void> done = goOnWith(*stored.state, ModelOrigin::stored);
            if (!done && done.error().code != ErrorCode::inputNotUsable) return done;
            whole_.reset();
            askingSince_.reset();
            if (done) return done;
            log::warning("The stored peripheral model cannot be gone on with.");
            beginWithPoints(ModelOrigin::damagedPoints);
            return {};
        }
    }
    return {};
}

Result<void> LiveModel::drawStored(const StoredModel& stored) {
    MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(device_, *stored.splats));
    painter_.emplace(std::move(painter));
    drawn_ = stored.splats;
    stepsOfStored_ = stored.steps;
    gain_ = stored.gain;
    origin_ = ModelOrigin::stored;
    stage_ = ModelStage::resuming;
    if (!askingSince_) askingSince_ = Clock::now();
    return {};
}

void LiveModel::hide() {
    putAway();
    end(ModelStage::none);
    key_.clear();
}

// Only a model that has taken its first steps goes on the shelf: less is soon found again.
void LiveModel::putAway() {
    keepWhole();
    if (!model_ || !canBeDrawn()) return;
    Result<PeripheralState> state = model_->state();
    put(state ? *std::move(state) : model_->lastGood());
}

void LiveModel::save() {
    keepWhole();
    if (model_ && canBeDrawn()) put(model_->lastGood());
}

// What came from the store and could not be gone on with yet: a device that is lost or full is no reason to
// begin anew.
void LiveModel::keepWhole() {
    if (whole_) shelf_->put(whole_->state);
}

void LiveModel::put(PeripheralState state) {
    state.gain = gain_;
    const auto kept = std::make_shared<const PeripheralState>(std::move(state));
    shelf_->put(kept);
    giveToStore(kept);
}

// Only what is news to it.
void LiveModel::giveToStore(std::shared_ptr<const PeripheralState> state) {
    keptAt_ = Clock::now();
    const Kept now{.steps = state->training.steps, .generation = state->generation, .gain = state->gain};
    if (!store_ || now == kept_) return;
    kept_ = now;
    store_->keep(std::move(state));
}

// So that a program that is killed loses little. lastGood() is on the host already: no frame waits for it.
void LiveModel::keepSometimes() {
    if (!store_ || Clock::now() - keptAt_ < options_.leastBetweenKeeping) return;
    PeripheralState state = model_->lastGood();
    state.gain = gain_;
    giveToStore(std::make_shared<const PeripheralState>(std::move(state)));
}

Result<std::shared_ptr<const PeripheralState>> LiveModel::state() const {
    using State = std::shared_ptr<const PeripheralState>;
    if (whole_) return State(whole_->state);
    if (!model_ || !canBeDrawn()) return State();
    MACULA_TRY(PeripheralState state, model_->state());
    state.gain = gain_;
    return State(std::make_shared<const PeripheralState>(std::move(state)));
}

void LiveModel::giveUp(ModelStage stage) {
    putAway();
    end(stage);
}

void LiveModel::end(ModelStage stage) {
    model_.reset();
    painter_.reset();
    drawn_.reset();
    gain_ = 1.0;
    lookedAt_.reset();
    wanted_.reset();
    isWantedTraced_ = false;
    seenMm_.reset();
    points_.reset();
    gauge_.reset();
    views_ = 0;
    stepsAtLastView_ = 0;
    lastViewMs_ = trainedMs_ = 0.0;
    origin_ = ModelOrigin::none;
    askingSince_.reset();
    whole_.reset();
    startWith_.reset();
    kept_ = {};
    keptAt_ = Clock::now();
    stage_ = stage;
}

Result<void> LiveModel::work(double budgetMs, const std::function<bool()>& keepGoing) {
    MACULA_CHECK(hasWork());
    const auto start = Clock::now();
    const auto goesOn = [&] { return msSince(start) < budgetMs && keepGoing(); };
    return withoutRoom(askingSince_                      ? askStore(goesOn)
                       : stage_ == ModelStage::searching ? searchSome(budgetMs, goesOn)
                                                         : learnSome(goesOn));
}

Result<void> LiveModel::withoutRoom(Result<void> done) {
    if (!isOutOfMemory(done)) return done;
    log::warning("There is no room on the device for the peripheral model to learn.");
    // The model can still be drawn as it is.
    if (model_ && canBeDrawn())
        stage_ = ModelStage::resting;
    else
        giveUp(ModelStage::noRoom);
    return {};
}

// The search for points needs a view to be set, though it finds what can be seen from anywhere.
Result<void> LiveModel::beginSearch() {
    MACULA_TRY_VOID(tracer_.setView({.width = 64, .height = 64}));
    MACULA_TRY(const Box seen, tracer_.seenMm());
    if (!(seen.diagonal() > 0.0) || glm::any(glm::greaterThan(seen.low, seen.high))) {
        end(ModelStage::nothingToSee);
        return {};
    }
    MACULA_TRY_VOID(tracer_.setView(
        {.camera = frameBox(seen, ViewDirection::anterior, 20.0, 1.0), .width = 64, .height = 64}));
    seenMm_ = seen;
    return {};
}

Result<void> LiveModel::searchSome(double budgetMs, const std::function<bool()>& goesOn) {
    if (model_) return takeFirstSteps(budgetMs, goesOn);
    if (!seenMm_) MACULA_TRY_VOID(beginSearch());
    if (!seenMm_) return {};  // there is nothing to be seen
    if (startWith_ && !gauge_) gauge_.emplace(*seenMm_);
    if (!startWith_ && !points_) {
        const TimelineStage stage("model: points");
        MACULA_TRY(points_, tracer_.someSurfacePoints(options_.points, goesOn));
        if (!points_) return {};
        if (points_->points.empty()) {
            end(ModelStage::nothingToSee);
            return {};
        }
        gauge_.emplace(*seenMm_);
        if (!goesOn()) return {};
    }
    if (!gauge_->isWhole()) {
        const TimelineStage stage("model: gauge");
        MACULA_TRY_VOID(gauge_->traceSome(tracer_, settings_, goesOn));
        // What follows cannot be interrupted, and takes long where it compiles: a picture may come between.
        if (!gauge_->isWhole() || !goesOn()) return {};
    }
    const TimelineStage stage("model: begin");
    const ModelStart start{.splats = startWith_ ? *startWith_ : initialSplats(*points_),
                           .seenMm = *seenMm_,
                           .isTaught = startWith_ != nullptr,
                           .key = key_};
    MACULA_TRY(model_, PeripheralModel::begin(device_, start, options_.model));
    points_.reset();
    startWith_.reset();
    // Splats made of points alone are too bright, and too opaque where matter is thin. The trainer corrects
    // that in some 40 steps with the six pictures that the gauge has traced.
    for (const TracedView& picture : gauge_->pictures()) {
        MACULA_TRY([[maybe_unused]] const Offered offered, model_->offer(picture, false));
    }
    return {};
}

Result<void> LiveModel::takeFirstSteps(double budgetMs, const std::function<bool()>& goesOn) {
    const TimelineStage stage("model: first steps");
    // A model that was trained in other lights has the right geometry: it needs no first steps.
    const bool isWarm = origin_ == ModelOrigin::otherLights || origin_ == ModelOrigin::otherTrainer;
    const auto isDone = [&] {
        return isWarm || model_->report().training.steps >= options_.stepsBeforeShown;
    };
    if (!isDone() && !model_->isPaused())
        MACULA_TRY_VOID(model_->step(budgetMs, [&] { return goesOn() && !isDone(); }));
    if (!isDone() && !model_->isPaused()) return {};
    MACULA_TRY_VOID(makeDrawable());
    stage_ = ModelStage::learning;
    return {};
}

// Makes the shown model drawable, as bright as traced pictures are.
Result<void> LiveModel::makeDrawable() {
    const ShownModel shown = model_->shown();
    if (painter_ && shown.splats == drawn_) return {};
    painter_.reset();
    drawn_ = shown.splats;
    MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(device_, *drawn_));
    if (gauge_ && gauge_->isWhole()) {
        MACULA_TRY(gain_, gauge_->gainOf(painter, drawn_->originMm));
    }
    painter_.emplace(std::move(painter));
    return {};
}

bool LiveModel::wantsView() const {
    if (views_ >= options_.views) return false;
    const PeripheralReport report = model_->report();
    const std::uint64_t since = report.training.steps - std::min(report.training.steps, stepsAtLastView_);
    const bool isDue = since >= options_.mostStepsBetweenViews || trainedMs_ >= lastViewMs_;
    return report.pause == Pause::noViews ||
           (since >= options_.stepsBetweenViews && (isDue || model_->isPaused()));
}

Result<void> LiveModel::learnSome(const std::function<bool()>& goesOn) {
    if (!gauge_->isWhole()) {
        const TimelineStage stage("model: gauge");
        MACULA_TRY_VOID(gauge_->traceSome(tracer_, settings_, goesOn));
        if (gauge_->isWhole()) painter_.reset();
        return gauge_->isWhole() ? makeDrawable() : Result<void>();
    }
    if (!wanted_ && wantsView()) MACULA_TRY_VOID(doPart(LearningPart::ask, goesOn));
    if (wanted_) {
        if (!isWantedTraced_) MACULA_TRY_VOID(doPart(LearningPart::trace, goesOn));
        return isWantedTraced_ ? doPart(LearningPart::take, goesOn) : Result<void>();
    }
    MACULA_TRY_VOID(doPart(LearningPart::step, goesOn));
    MACULA_TRY_VOID(doPart(LearningPart::show, goesOn));
    if (model_->isPaused() && !wantsView()) {
        stage_ = ModelStage::resting;
        putAway();
    }
    keepSometimes();
    return {};
}

Result<void> LiveModel::doPart(LearningPart part, const std::function<bool()>& goesOn) {
    const TimelineStage stage(nameOf(part));
    const auto start = Clock::now();
    switch (part) {
        // Of these, what is done between two questions cannot be interrupted.
        case LearningPart::step: {
            // `goesOn` alone says when it ends: it has to be asked after a step that took too long.
            Result<void> done =
                model_->step(std::numeric_limits<double>::infinity(), measuredBy(pace_, part, goesOn));
            trainedMs_ += msSince(start);
            return done;
        }
        case LearningPart::trace: {
            Result<void> done = traceWanted(measuredBy(pace_, part, goesOn));
            lastViewMs_ += msSince(start);
            return done;
        }
        case LearningPart::show: {
            if (isShownDrawn()) return {};
            MACULA_TRY_VOID(makeDrawable());
            break;
        }
        case LearningPart::ask: {
            MACULA_TRY_VOID(askForView());
            break;
        }
        case LearningPart::take: {
            MACULA_TRY_VOID(takeWanted());
            break;
        }
    }
    pace_.took(part, msSince(start));
    return {};
}

// What is learnt while a hand moves is shown, and taken in, when there is time for it; whatever waits for
// that keeps nobody from training.
std::optional<LearningPart> LiveModel::nextWithin(double leftMs) const {
    if (stage_ != ModelStage::learning || askingSince_ || !gauge_->isWhole() || !painter_)
        return std::nullopt;
    const auto fitting = [&](LearningPart part) {
        return pace_.fits(part, leftMs) ? std::optional(part) : std::nullopt;
    };
    std::optional<LearningPart> next;
    if (!isShownDrawn()) next = fitting(LearningPart::show);
    if (!next && wanted_) next = fitting(isWantedTraced_ ? LearningPart::take : LearningPart::trace);
    if (!next && !wanted_ && wantsView()) next = fitting(LearningPart::ask);
    if (!next && !model_->isPaused()) next = fitting(LearningPart::step);
    return next;
}

Result<void> LiveModel::workWithin(double leftMs, const std::function<bool()>& keepGoing) {
    MACULA_CHECK(hasWork());
    const auto start = Clock::now();
    bool isDone = false;
    while (const std::optional<LearningPart> next = nextWithin(leftMs - msSince(start))) {
        isDone = true;
        const auto goesOn = [&] { return pace_.fits(*next, leftMs - msSince(start)) && keepGoing(); };
        if (Result<void> done = doPart(*next, goesOn); !done) return withoutRoom(std::move(done));
        if (!keepGoing()) return {};
    }
    if (!isDone && model_ && !model_->isPaused()) pace_.refusedStep();
    return {};
}

Result<void> LiveModel::askForView() {
    MACULA_TRY(const std::optional<CandidatePose> wanted, model_->wantedView());
    if (!wanted) {
        views_ = options_.views;
        return {};
    }
    trace::Settings settings = settings_;
    // The same noise in all views would be learnt as if it were there.
    settings.seed += static_cast<std::uint32_t>(views_);
    tracer_.forgetViews();
    MACULA_TRY_VOID(tracer_.setSettings(settings));
    const bool isRough = model_->report().training.steps < options_.roughSteps;
    const glm::ivec2 sizePx = isRough ? glm::ivec2(options_.roughSidePx) : options_.model.wanted.sizePx;
    MACULA_TRY_VOID(tracer_.setView({.camera = wanted->camera, .width = sizePx.x, .height = sizePx.y}));
    wanted_ = wanted->camera;
    isWantedTraced_ = false;
    lastViewMs_ = 0.0;
    return {};
}

Result<void> LiveModel::traceWanted(const std::function<bool()>& goesOn) {
    MACULA_TRY(const trace::Statistics before, tracer_.statistics());
    if (before.samplesPerPixel < options_.samplesPerPixel) {
        const auto missing = options_.samplesPerPixel - static_cast<std::uint32_t>(before.samplesPerPixel);
        MACULA_TRY(const bool isWhole, tracer_.trace(missing, goesOn));
        if (!isWhole || !goesOn()) return {};
    }
    MACULA_TRY(isWantedTraced_, tracer_.develop(goesOn));
    return {};
}

Result<void> LiveModel::takeWanted() {
    MACULA_TRY(TracedView view, readToLearnFrom(tracer_, *wanted_));
    wanted_.reset();
    isWantedTraced_ = false;
    ++views_;
    MACULA_TRY([[maybe_unused]] const Offered offered, model_->offer(std::move(view)));
    stepsAtLastView_ = model_->report().training.steps;
    trainedMs_ = 0.0;
    return {};
}

Result<void> LiveModel::learnFrom(trace::PathTracer& tracer, const trace::View& view, std::uint32_t samples) {
    MACULA_CHECK(canBeDrawn());
    if (!model_) return {};  // it is resuming
    if (std::int64_t(view.width) * view.height > kMostPixelsToLearn) return {};
    if (lookedAt_ && lookedAt_->camera == view.camera && samples < kMoreSamples * lookedAt_->samples)
        return {};
    lookedAt_ = {view.camera, samples};
    const TimelineStage stage("model: learn from screen");
    const auto tryToLearn = [&]() -> Result<void> {
        MACULA_TRY(TracedView picture, readToLearnFrom(tracer, view.camera));
        MACULA_TRY(const Offered offered, model_->offer(std::move(picture), false));
        if (offered == Offered::learnt) stage_ = ModelStage::learning;
        return {};
    };
    try {
        const Result<void> learnt = tryToLearn();
        return isOutOfMemory(learnt) ? Result<void>() : learnt;
    } catch (const std::bad_alloc&) {
        if (device_->lost()) throw;
        return {};
    }
}

Result<const splat::DevicePicture*> LiveModel::draw(const Camera& camera, const glm::ivec2& sizePx,
                                                    double nearMm) {
    MACULA_CHECK(canBeDrawn());
    const auto tryDraw = [&]() -> Result<const splat::DevicePicture*> {
        // What was learnt since is made drawable by work(): a frame does not wait for that.
        if (model_ && !painter_) MACULA_TRY_VOID(makeDrawable());
        MACULA_TRY(const splat::RasterView view, splat::rasterView(camera, sizePx, drawn_->originMm, nearMm));
        return painter_->drawOnDevice(view);
    };
    auto picture = tryDraw();
    if (!picture && picture.error().code == ErrorCode::outOfMemory) giveUp(ModelStage::noRoom);
    return picture;
}

std::shared_ptr<const splat::Splats> LiveModel::shown() const {
    if (painter_) return drawn_;
    return model_ ? model_->shown().splats : nullptr;
}

std::optional<PeripheralReport> LiveModel::report() const {
    return model_ ? std::optional(model_->report()) : std::nullopt;
}

ModelNews LiveModel::news() const {
    ModelNews news{.stage = stage_, .origin = origin_};
    if (stage_ == ModelStage::resuming) {
        news.splats = static_cast<std::uint32_t>(drawn_->size());
        news.steps = stepsOfStored_;
        news.isSharp = isSharp();
    }
    if (!model_) return news;
    const PeripheralReport report = model_->report();
    news.splats = static_cast<std::uint32_t>(model_->shown().splats->size());
    news.steps = report.training.steps;
    news.views = report.views + report.heldOut;
    news.isSharp = isSharp();
    return news;
}

bool LiveModel::isSharp() const {
    if (!canBeDrawn()) return false;
    if (!model_) return stepsOfStored_ >= kStepsOfSharpModels;
    const PeripheralReport report = model_->report();
    return report.isSharp.value_or(report.training.steps >= kStepsOfSharpModels);
}

}  // namespace macula::hybrid
