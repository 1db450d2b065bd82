#include "pipeline/hybrid/model/taught_model.h"

#include <chrono>
#include <limits>
#include <new>
#include <utility>

#include "base/elapsed.h"
#include "base/timeline.h"
#include "pipeline/hybrid/views/view_tracing.h"

namespace macula::hybrid {

namespace {

using Clock = std::chrono::steady_clock;

// The model learns again from a picture on screen that has so many times the samples: half the noise.
constexpr std::uint32_t kMoreSamples = 4;

// Wraps `goesOn`, and notes in the pace how long each piece of work between two calls took.
std::function<bool()> measuredBy(LearningPace& pace, LearningPart part, const std::function<bool()>& goesOn) {
    return [&pace, part, &goesOn, last = Clock::now()]() mutable {
        constexpr double kAskedTwiceMs = 0.01;
        const double ms = msSince(std::exchange(last, Clock::now()));
        if (ms > kAskedTwiceMs) pace.took(part, ms);
        return goesOn();
    };
}

}  // namespace

Result<void> TaughtModel::resume(const PeripheralState& state) {
    MACULA_TRY(model_, PeripheralModel::resume(device_, state, options_.model));
    // The pictures of the gauge do not count: the model did not ask for them.
    wanted_.resume(state.asked, model_->report().training.steps);
    gauge_.emplace(state.seenMm);  // traced again, while the learnt splats can be drawn
    drawn_.setGain(state.gain);
    return {};
}

Result<bool> TaughtModel::traceGauge(const Box& seenMm, trace::PathTracer& tracer,
                                     const trace::Settings& settings, const std::function<bool()>& goesOn) {
    if (!gauge_) gauge_.emplace(seenMm);
    if (gauge_->isWhole()) return true;
    const TimelineStage stage("model: gauge");
    MACULA_TRY_VOID(gauge_->traceSome(tracer, settings, goesOn));
    // The next part cannot be interrupted, and takes long if it compiles kernels: let a frame come first.
    return gauge_->isWhole() && goesOn();
}

// Splats from points alone are too bright, and too opaque where matter is thin. The trainer corrects that in
// some 40 steps with the six pictures of the gauge.
Result<void> TaughtModel::begin(const ModelStart& start) {
    MACULA_TRY(model_, PeripheralModel::begin(device_, start, options_.model));
    for (const TracedView& picture : gauge_->pictures()) {
        MACULA_TRY([[maybe_unused]] const Offered offered, model_->offer(picture, false));
    }
    return {};
}

Result<bool> TaughtModel::takeFirstSteps(std::uint64_t steps, double budgetMs,
                                         const std::function<bool()>& goesOn) {
    const TimelineStage stage("model: first steps");
    const auto isDone = [&] { return model_->report().training.steps >= steps; };
    if (!isDone() && !model_->isPaused())
        MACULA_TRY_VOID(model_->step(budgetMs, [&] { return goesOn() && !isDone(); }));
    if (!isDone() && !model_->isPaused()) return false;
    MACULA_TRY_VOID(makeDrawable());
    return true;
}

void TaughtModel::forget() {
    model_.reset();
    drawn_.forget();
    lookedAt_.reset();
    wanted_ = {};
    gauge_.reset();
}

Result<const splat::DevicePicture*> TaughtModel::draw(const Camera& camera, const glm::ivec2& sizePx,
                                                      double nearMm) {
    if (model_ && !drawn_.canDraw()) MACULA_TRY_VOID(makeDrawable());
    return drawn_.draw(camera, sizePx, nearMm);
}

// Makes the newest model drawable, as bright as traced pictures are.
Result<void> TaughtModel::makeDrawable() {
    return drawn_.show(device_, model_->shown().splats, gauge_ ? &*gauge_ : nullptr);
}

Result<TaughtModel::Learnt> TaughtModel::learnSome(trace::PathTracer& tracer, const trace::Settings& settings,
                                                   const std::function<bool()>& goesOn) {
    const auto part = [&](LearningPart what) { return doPart(what, tracer, settings, goesOn); };
    if (!gauge_->isWhole()) {
        const TimelineStage stage("model: gauge");
        MACULA_TRY_VOID(gauge_->traceSome(tracer, settings, goesOn));
        if (!gauge_->isWhole()) return Learnt::something;
        drawn_.stopDrawing();
        MACULA_TRY_VOID(makeDrawable());
        return Learnt::something;
    }
    if (!wanted_.isAsked() && wantsView()) MACULA_TRY_VOID(part(LearningPart::ask));
    if (wanted_.isAsked()) {
        if (!wanted_.isTraced()) MACULA_TRY_VOID(part(LearningPart::trace));
        if (wanted_.isTraced()) MACULA_TRY_VOID(part(LearningPart::take));
        return Learnt::something;
    }
    MACULA_TRY_VOID(part(LearningPart::step));
    MACULA_TRY_VOID(part(LearningPart::show));
    return model_->isPaused() && !wantsView() ? Learnt::all : Learnt::trained;
}

Result<void> TaughtModel::doPart(LearningPart part, trace::PathTracer& tracer,
                                 const trace::Settings& settings, const std::function<bool()>& goesOn) {
    const TimelineStage stage(nameOf(part));
    const auto start = Clock::now();
    switch (part) {
        // step and trace can be interrupted, but only between two calls of `goesOn`.
        case LearningPart::step: {
            // Only `goesOn` ends it: it must be called even after a step that took too long, to note its
            // time.
            Result<void> done =
                model_->step(std::numeric_limits<double>::infinity(), measuredBy(pace_, part, goesOn));
            wanted_.tookToTrain(msSince(start));
            return done;
        }
        case LearningPart::trace: {
            Result<void> done =
                wanted_.trace(tracer, options_.samplesPerPixel, measuredBy(pace_, part, goesOn));
            wanted_.tookToTrace(msSince(start));
            return done;
        }
        case LearningPart::show: {
            if (isShownDrawn()) return {};
            MACULA_TRY_VOID(makeDrawable());
            break;
        }
        case LearningPart::ask: {
            MACULA_TRY_VOID(wanted_.ask(*model_, tracer, settings, options_));
            break;
        }
        case LearningPart::take: {
            MACULA_TRY_VOID(wanted_.take(*model_, tracer));
            break;
        }
    }
    pace_.took(part, msSince(start));
    return {};
}

// While a hand moves, a learnt model is shown, and a traced view taken, only if there is time for it; if not,
// shorter parts such as training steps go first.
std::optional<LearningPart> TaughtModel::nextWithin(double leftMs) const {
    if (!gauge_->isWhole() || !drawn_.canDraw()) return std::nullopt;
    const auto fitting = [&](LearningPart part) {
        return pace_.fits(part, leftMs) ? std::optional(part) : std::nullopt;
    };
    std::optional<LearningPart> next;
    if (!isShownDrawn()) next = fitting(LearningPart::show);
    if (!next && wanted_.isAsked())
        next = fitting(wanted_.isTraced() ? LearningPart::take : LearningPart::trace);
    if (!next && !wanted_.isAsked() && wantsView()) next = fitting(LearningPart::ask);
    if (!next && !model_->isPaused()) next = fitting(LearningPart::step);
    return next;
}

Result<void> TaughtModel::learnWithin(double leftMs, trace::PathTracer& tracer,
                                      const trace::Settings& settings,
                                      const std::function<bool()>& keepGoing) {
    const auto start = Clock::now();
    bool isDone = false;
    while (const std::optional<LearningPart> next = nextWithin(leftMs - msSince(start))) {
        isDone = true;
        const auto goesOn = [&] { return pace_.fits(*next, leftMs - msSince(start)) && keepGoing(); };
        MACULA_TRY_VOID(doPart(*next, tracer, settings, goesOn));
        if (!keepGoing()) return {};
    }
    if (!isDone) refuseStep();
    return {};
}

void TaughtModel::refuseStep() {
    if (model_ && !model_->isPaused()) pace_.refusedStep();
}

Result<bool> TaughtModel::learnFrom(trace::PathTracer& tracer, const trace::View& view,
                                    std::uint32_t samples) {
    if (lookedAt_ && lookedAt_->camera == view.camera && samples < kMoreSamples * lookedAt_->samples)
        return false;
    lookedAt_ = {view.camera, samples};
    const TimelineStage stage("model: learn from screen");
    const auto tryToLearn = [&]() -> Result<bool> {
        MACULA_TRY(TracedView picture, readToLearnFrom(tracer, view.camera));
        MACULA_TRY(const Offered offered, model_->offer(std::move(picture), false));
        return offered == Offered::learnt;
    };
    try {
        Result<bool> learnt = tryToLearn();
        if (!learnt && learnt.error().code == ErrorCode::outOfMemory) return false;
        return learnt;
    } catch (const std::bad_alloc&) {
        if (device_->lost()) throw;
        return false;
    }
}

}  // namespace macula::hybrid
