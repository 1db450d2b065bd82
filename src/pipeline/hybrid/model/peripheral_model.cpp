#include "pipeline/hybrid/model/peripheral_model.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/timeline.h"
#include "pipeline/hybrid/model/refinement.h"
#include "pipeline/hybrid/model/training_rounds.h"
#include "pipeline/hybrid/views/held_out.h"
#include "pipeline/hybrid/views/training_views.h"

namespace macula::hybrid {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr std::size_t kFewViews = 12;      // fewer may not be enough to learn from
constexpr std::uint64_t kManySteps = 120;  // after which a model from points is no longer mottled
constexpr std::uint64_t kLeastSteps = 10;  // between judgings: fewer make no measurable difference

}  // namespace

std::string_view describe(Pause pause) {
    switch (pause) {
        case Pause::none:
            return "It is learning.";
        case Pause::noViews:
            return "There is no picture to learn from yet.";
        case Pause::flat:
            return "It has learnt what its pictures can teach it.";
        case Pause::notJudged:
            return "It has learnt for as long as is usual; there are too few pictures to tell more.";
        case Pause::outOfMemory:
            return "The graphics device has no memory left to learn with.";
    }
    return {};
}

// The number of steps after which judging costs at most judgingShare of the pixels drawn for training.
std::uint64_t PeripheralModel::stepsBetweenJudging() const {
    const double each = meanPixelsOfViews(trainer_);
    const double steps = std::ceil(heldOut_.pixels() / std::max(options_.judgingShare * each, 1.0));
    return std::max(kLeastSteps, static_cast<std::uint64_t>(std::min(steps, 1e6)));
}

Result<void> PeripheralModel::step(double budgetMs, const std::function<bool()>& keepGoing) {
    if (isPaused()) return {};
    const auto start = Clock::now();
    const auto goesOn = [&] {
        return 1000.0 * secondsSince(start) < budgetMs && (!keepGoing || keepGoing());
    };
    const auto work = [&]() -> Result<void> {
        if (isTorn_) MACULA_TRY_VOID(trainer_.goBack());
        isTorn_ = false;
        do {
            MACULA_TRY_VOID(isJudging_ ? judgeNext() : learn(goesOn));
        } while (!isPaused() && goesOn());
        return {};
    };
    Result<void> done = work();
    if (!done && done.error().code == ErrorCode::outOfMemory) {
        pause_ = Pause::outOfMemory;
        isTorn_ = true;
    }
    return done;
}

// Trains until it is time to judge.
Result<void> PeripheralModel::learn(const std::function<bool()>& goesOn) {
    MACULA_TRY_VOID(beginRoundIfDue());
    const std::uint64_t every = stepsBetweenJudging();
    const std::uint64_t left = every - trainer_.report().steps % every;
    const auto start = Clock::now();
    const Result<splat::TrainingReport> trained = trainer_.step(left, goesOn);
    trainingSeconds_ += secondsSince(start);
    if (!trained) return trained.error();
    isJudging_ = trained->steps % every == 0;
    heldOut_.beginJudging();
    return {};
}

// Compares one held-out picture in each call, so that no call takes long; the model does not change until all
// are compared.
Result<void> PeripheralModel::judgeNext() {
    if (!heldOut_.isJudged()) {
        const TimelineStage stage("model: judging");
        const auto start = Clock::now();
        MACULA_TRY_VOID(heldOut_.judgeNext(trainer_));
        judgingSeconds_ += secondsSince(start);
        trainingSeconds_ += secondsSince(start);
    }
    if (!heldOut_.isJudged()) return {};
    isJudging_ = false;
    if (!heldOut_.empty()) trend_.add(trainingSeconds_, heldOut_.meanErrors().trained);
    MACULA_TRY_VOID(showIfBetter());
    noteSharpness();
    return pauseOrSettle();
}

void PeripheralModel::wake() {
    pause_ = Pause::none;
    trend_.forget();
}

Result<void> PeripheralModel::beginRoundIfDue() {
    const double views = double(trainer_.viewCount());
    if (notes_.roundViews == 0) notes_.roundViews = trainer_.viewCount();
    const splat::TrainingReport now = trainer_.report();
    if (!isSettled(trainer_.lastGood().options, now.steps) || trainer_.viewCount() <= notes_.roundViews ||
        views < (1.0 + options_.newViewsForRound) * double(notes_.roundViews))
        return {};
    notes_.roundViews = trainer_.viewCount();
    const auto more = static_cast<std::uint32_t>(
        std::min(options_.splatsGrow * double(now.splats), double(options_.mostSplats)));
    const std::uint32_t room = std::max(more, notes_.first.capacity);
    MACULA_TRY(bool hasBegun, beginRound(room));
    noRoom_ = !hasBegun;
    if (!hasBegun) {
        const auto present = std::max(trainer_.lastGood().options.capacity, now.splats);
        MACULA_TRY(hasBegun, beginRound(std::min(present, room)));
    }
    // A round that could not begin is tried again after as many more views, not at every step: otherwise the
    // model would never pause.
    if (hasBegun) ++rounds_;
    return {};
}

Result<bool> PeripheralModel::beginRound(std::uint32_t capacity) {
    // A round has few new views, and a shown model should soon improve again, so rates rise only so much.
    constexpr double kWarmer = 3.0;
    const RefinementOptions round{.iterations = options_.roundSteps, .capacity = capacity, .warmer = kWarmer};
    return goOnWith(comparedAsJudged(refinementTraining(notes_.first, trainer_.report(), round)),
                    std::max(options_.shDegree, trainer_.lastGood().splats.shDegree));
}

// Returns false if the device has no memory for it; then training continues as before.
Result<bool> PeripheralModel::goOnWith(const splat::TrainerOptions& options, int shDegree) {
    const Result<void> done = trainer_.goOnWith(options, shDegree);
    if (!done && done.error().code != ErrorCode::outOfMemory) return done.error();
    trend_.forget();
    return done.ok();
}

// Shows the trained model, unless it has become worse than the best one.
Result<void> PeripheralModel::showIfBetter() {
    const HeldOutErrors mean = heldOut_.meanErrors();
    // With few views the model overfits to them, and gets worse for other views.
    if (!heldOut_.canJudge() && trainer_.viewCount() < kFewViews) return {};
    // Compares with the best shown model, not with the last: small losses would add up.
    if (mean.trained > (1.0 + options_.shownMayBeWorse) * mean.best) return {};
    const bool isBest = mean.trained <= mean.best;
    MACULA_TRY(splat::Splats now, trainer_.snapshot());
    shown_ = std::make_shared<const splat::Splats>(std::move(now));
    ++generation_;
    if (isBest) best_ = shown_;
    heldOut_.judgedIsShown(isBest);
    return {};
}

// Once sharp, a model stays sharp: pictures that are held out later should not take it off the screen. A
// model from points is mottled, which could be read as pathology, until it has learnt from views that it
// asked for; by then more pictures are held out than at the start.
void PeripheralModel::noteSharpness() {
    const HeldOutErrors mean = heldOut_.meanErrors();
    const bool hasLearnt =
        isTaught_ || heldOut_.size() > kLeastHeldOut || trainer_.report().steps >= kManySteps;
    if (heldOut_.canJudge() && hasLearnt && mean.shown <= mean.coarse) wasSharp_ = true;
}

Result<void> PeripheralModel::pauseOrSettle() {
    const splat::TrainerOptions& now = trainer_.lastGood().options;
    const std::uint64_t steps = trainer_.report().steps;
    const bool settled = isSettled(now, steps);
    if (!heldOut_.canJudge()) {
        if (settled) pause_ = Pause::notJudged;
        return {};
    }
    if (!trend_.isFlat()) return {};
    if (settled) {
        pause_ = Pause::flat;
        return {};
    }
    MACULA_TRY_VOID(
        goOnWith(settling(now, steps, options_.settlingSteps), trainer_.lastGood().splats.shDegree));
    return {};
}

PeripheralReport PeripheralModel::report() const {
    PeripheralReport report{.pause = pause_,
                            .training = trainer_.report(),
                            .trainingSeconds = trainingSeconds_,
                            .judgingSeconds = judgingSeconds_,
                            .views = trainer_.viewCount(),
                            .heldOut = heldOut_.size(),
                            .fallPerSecond = trend_.fallPerSecond(),
                            .rounds = rounds_,
                            .noRoom = noRoom_};
    if (heldOut_.empty()) return report;
    const HeldOutErrors mean = heldOut_.meanErrors();
    report.error = mean.trained;
    report.shownError = mean.shown;
    if (heldOut_.canJudge()) report.isSharp = wasSharp_;
    return report;
}

}  // namespace macula::hybrid
