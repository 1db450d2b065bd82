#include "pipeline/hybrid/model/live_model.h"

#include <chrono>
#include <utility>

#include "base/check.h"
#include "base/elapsed.h"
#include "base/log.h"
#include "base/timeline.h"

namespace macula::hybrid {

namespace {

using Clock = std::chrono::steady_clock;

// After so many steps most models are sharp; used when too few pictures are held out to judge it.
constexpr std::uint64_t kStepsOfSharpModels = 120;

bool isOutOfMemory(const Result<void>& done) {
    return !done && done.error().code == ErrorCode::outOfMemory;
}

}  // namespace

LiveModel::LiveModel(const std::shared_ptr<gpu::Device>& device, trace::PathTracer tracer,
                     std::shared_ptr<ModelShelf> shelf, std::shared_ptr<ModelStore> store,
                     const LiveModelOptions& options)
    : options_(options),
      tracer_(std::move(tracer)),
      archive_(std::move(shelf), std::move(store), options),
      taught_(device, options) {}

Result<LiveModel> LiveModel::create(const std::shared_ptr<gpu::Device>& device,
                                    const trace::PathTracer& beside, std::shared_ptr<ModelShelf> shelf,
                                    std::shared_ptr<ModelStore> store, const LiveModelOptions& options) {
    MACULA_CHECK(shelf != nullptr);
    MACULA_TRY(trace::PathTracer tracer, beside.ofSameScene());
    if (options.dispatchMs) tracer.setDispatchMs(*options.dispatchMs);
    return LiveModel(device, std::move(tracer), std::move(shelf), std::move(store), options);
}

Result<void> LiveModel::show(const std::string& key, const trace::Settings& settings,
                             std::shared_ptr<const splat::Splats> neighbour) {
    MACULA_CHECK(!key.empty() && trace::isPathTraced(settings.look));
    if (key == key_) return {};
    hide();
    key_ = key;
    settings_ = settings;
    settings_.denoising = trace::Denoising::little;
    settings_.errorThreshold = 0.0;
    Result<void> done = tryShow(std::move(neighbour));
    if (isOutOfMemory(done)) {
        giveUp(ModelStage::noRoom);
        return {};
    }
    if (!done) hide();
    return done;
}

Result<void> LiveModel::tryShow(std::shared_ptr<const splat::Splats> neighbour) {
    MACULA_TRY_VOID(tracer_.setSettings(settings_));
    stage_ = ModelStage::searching;
    if (const std::shared_ptr<const PeripheralState> kept = archive_.shelved(key_))
        return goOnWith(*kept, ModelOrigin::shelf);
    origin_ = neighbour ? ModelOrigin::neighbour : ModelOrigin::points;
    if (neighbour) search_.startWith(std::move(neighbour), false);
    if (!archive_.hasStore()) return {};
    archive_.beginAsking();
    // If the store answers at once, the first frame already shows the model.
    const StoredModel stored = archive_.stored(key_);
    return stored.answer == StoredModel::Answer::pending ? Result<void>() : takeFromStore(stored);
}

Result<void> LiveModel::goOnWith(const PeripheralState& state, ModelOrigin origin) {
    MACULA_TRY_VOID(taught_.resume(state));
    archive_.noteResumed(taught_.model(), state.gain);
    origin_ = origin;
    stage_ = ModelStage::learning;
    return {};
}

void LiveModel::beginWithPoints(ModelOrigin origin) {
    taught_.drawn().forget();
    origin_ = origin;
    stage_ = ModelStage::searching;
}

// Returns between waits, because the caller has other work.
Result<void> LiveModel::askStore(const std::function<bool()>& goesOn) {
    const TimelineStage stage("model: store");
    const auto stored =
        archive_.answer(key_, taught_.drawn().canDraw(), stage_ == ModelStage::searching, goesOn);
    return stored ? takeFromStore(*stored) : Result<void>();
}

Result<void> LiveModel::takeFromStore(const StoredModel& stored) {
    using Answer = StoredModel::Answer;
    if (stored.answer != Answer::drawable && stored.answer != Answer::whole) {
        archive_.endAsking();
        // The drawn model is no longer in the store, or the rest of its file could not be read.
        if (stage_ == ModelStage::resuming) beginWithPoints(ModelOrigin::points);
    }
    switch (stored.answer) {
        case Answer::pending:  // has taken too long
        case Answer::none:
            return {};
        case Answer::damaged:
            beginWithPoints(ModelOrigin::damagedPoints);
            return {};
        case Answer::warm:
        case Answer::stale:
            origin_ = stored.answer == Answer::warm ? ModelOrigin::otherLights : ModelOrigin::otherTrainer;
            search_.startWith(stored.splats);
            return {};
        case Answer::drawable:
            return drawStored(stored);
        case Answer::whole: {
            archive_.holdWhole(stored);                                 // the store gives it once
            if (!taught_.drawn().canDraw()) return drawStored(stored);  // show it first
            Result<void> done = goOnWith(*stored.state, ModelOrigin::stored);
            if (!done && done.error().code != ErrorCode::inputNotUsable) return done;
            archive_.dropWhole();
            archive_.endAsking();
            if (done) return done;
            log::warning("The stored peripheral model cannot be gone on with.");
            beginWithPoints(ModelOrigin::damagedPoints);
            return {};
        }
    }
    return {};
}

Result<void> LiveModel::drawStored(const StoredModel& stored) {
    MACULA_TRY_VOID(taught_.showStored(stored));
    stepsOfStored_ = stored.steps;
    origin_ = ModelOrigin::stored;
    stage_ = ModelStage::resuming;
    if (!archive_.isAsking()) archive_.beginAsking();
    return {};
}

void LiveModel::hide() {
    putAway();
    end(ModelStage::none);
    key_.clear();
}

// Only a model that has taken its first steps goes on the shelf: anything less is quickly made again.
void LiveModel::putAway() {
    archive_.putWholeOnShelf();
    if (!taught_.exists() || !canBeDrawn()) return;
    Result<PeripheralState> state = taught_.model().state();
    archive_.put(state ? *std::move(state) : taught_.model().lastGood(), gain());
}

void LiveModel::save() {
    archive_.putWholeOnShelf();
    if (taught_.exists() && canBeDrawn()) archive_.put(taught_.model().lastGood(), gain());
}

Result<std::shared_ptr<const PeripheralState>> LiveModel::state() const {
    using State = std::shared_ptr<const PeripheralState>;
    if (archive_.whole()) return State(archive_.whole()->state);
    if (!taught_.exists() || !canBeDrawn()) return State();
    MACULA_TRY(PeripheralState state, taught_.model().state());
    state.gain = gain();
    return State(std::make_shared<const PeripheralState>(std::move(state)));
}

void LiveModel::giveUp(ModelStage stage) {
    putAway();
    end(stage);
}

void LiveModel::end(ModelStage stage) {
    taught_.forget();
    search_.forget();
    archive_.forget();
    origin_ = ModelOrigin::none;
    stage_ = stage;
}

Result<void> LiveModel::work(double budgetMs, const std::function<bool()>& keepGoing) {
    MACULA_CHECK(hasWork());
    const auto start = Clock::now();
    const auto goesOn = [&] { return msSince(start) < budgetMs && keepGoing(); };
    return withoutRoom(archive_.isAsking()               ? askStore(goesOn)
                       : stage_ == ModelStage::searching ? searchSome(budgetMs, goesOn)
                                                         : learnSome(goesOn));
}

Result<void> LiveModel::withoutRoom(Result<void> done) {
    if (!isOutOfMemory(done)) return done;
    log::warning("There is no room on the device for the peripheral model to learn.");
    // The model can still be drawn as it is.
    if (taught_.exists() && canBeDrawn())
        stage_ = ModelStage::resting;
    else
        giveUp(ModelStage::noRoom);
    return {};
}

Result<void> LiveModel::searchSome(double budgetMs, const std::function<bool()>& goesOn) {
    if (taught_.exists()) return takeFirstSteps(budgetMs, goesOn);
    MACULA_TRY(const ModelSearch::Found found, search_.findSome(tracer_, options_.points, goesOn));
    if (found == ModelSearch::Found::nothing) end(ModelStage::nothingToSee);
    if (found != ModelSearch::Found::all) return {};
    MACULA_TRY(const bool isMeasured, taught_.traceGauge(search_.seenMm(), tracer_, settings_, goesOn));
    if (!isMeasured) return {};
    const TimelineStage stage("model: begin");
    Result<void> begun = taught_.begin(search_.start(key_));
    if (taught_.exists()) search_.forgetStart();
    return begun;
}

Result<void> LiveModel::takeFirstSteps(double budgetMs, const std::function<bool()>& goesOn) {
    // A model that was trained under other lights has the right geometry: it needs no first steps.
    const bool isWarm = origin_ == ModelOrigin::otherLights || origin_ == ModelOrigin::otherTrainer;
    MACULA_TRY(const bool areDone,
               taught_.takeFirstSteps(isWarm ? 0 : options_.stepsBeforeShown, budgetMs, goesOn));
    if (areDone) stage_ = ModelStage::learning;
    return {};
}

Result<void> LiveModel::learnSome(const std::function<bool()>& goesOn) {
    using Learnt = TaughtModel::Learnt;
    MACULA_TRY(const Learnt learnt, taught_.learnSome(tracer_, settings_, goesOn));
    if (learnt == Learnt::something) return {};
    if (learnt == Learnt::all) {
        stage_ = ModelStage::resting;
        putAway();
    }
    archive_.putSometimes(taught_.model(), gain());
    return {};
}

Result<void> LiveModel::workWithin(double leftMs, const std::function<bool()>& keepGoing) {
    MACULA_CHECK(hasWork());
    if (stage_ == ModelStage::learning && !archive_.isAsking())
        return withoutRoom(taught_.learnWithin(leftMs, tracer_, settings_, keepGoing));
    taught_.refuseStep();
    return {};
}

Result<void> LiveModel::learnFrom(trace::PathTracer& tracer, const trace::View& view, std::uint32_t samples) {
    MACULA_CHECK(canBeDrawn());
    if (!taught_.exists()) return {};  // still resuming
    if (std::int64_t(view.width) * view.height > kMostPixelsToLearn) return {};
    MACULA_TRY(const bool hasLearnt, taught_.learnFrom(tracer, view, samples));
    if (hasLearnt) stage_ = ModelStage::learning;
    return {};
}

Result<const splat::DevicePicture*> LiveModel::draw(const Camera& camera, const glm::ivec2& sizePx,
                                                    double nearMm) {
    MACULA_CHECK(canBeDrawn());
    auto picture = taught_.draw(camera, sizePx, nearMm);
    if (!picture && picture.error().code == ErrorCode::outOfMemory) giveUp(ModelStage::noRoom);
    return picture;
}

std::shared_ptr<const splat::Splats> LiveModel::shown() const {
    if (taught_.drawn().canDraw()) return taught_.drawn().splats();
    return taught_.exists() ? taught_.model().shown().splats : nullptr;
}

std::optional<PeripheralReport> LiveModel::report() const {
    return taught_.exists() ? std::optional(taught_.model().report()) : std::nullopt;
}

ModelNews LiveModel::news() const {
    ModelNews news{.stage = stage_, .origin = origin_};
    if (stage_ == ModelStage::resuming) {
        news.splats = static_cast<std::uint32_t>(taught_.drawn().splats()->size());
        news.steps = stepsOfStored_;
        news.isSharp = isSharp();
    }
    if (!taught_.exists()) return news;
    const PeripheralReport report = taught_.model().report();
    news.splats = static_cast<std::uint32_t>(taught_.model().shown().splats->size());
    news.steps = report.training.steps;
    news.views = report.views + report.heldOut;
    news.isSharp = isSharp();
    return news;
}

bool LiveModel::isSharp() const {
    if (!canBeDrawn()) return false;
    if (!taught_.exists()) return stepsOfStored_ >= kStepsOfSharpModels;
    const PeripheralReport report = taught_.model().report();
    return report.isSharp.value_or(report.training.steps >= kStepsOfSharpModels);
}

}  // namespace macula::hybrid
