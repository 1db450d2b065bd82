#include "pipeline/hybrid/model/wanted_view.h"

#include <algorithm>
#include <utility>

#include "pipeline/hybrid/views/view_tracing.h"

namespace macula::hybrid {

void WantedView::resume(std::size_t views, std::uint64_t steps) {
    views_ = views;
    stepsAtLastView_ = steps;
}

bool WantedView::isDue(const PeripheralModel& model, const LiveModelOptions& options) const {
    if (views_ >= options.views) return false;
    const PeripheralReport report = model.report();
    const std::uint64_t since = report.training.steps - std::min(report.training.steps, stepsAtLastView_);
    const bool isDue = since >= options.mostStepsBetweenViews || trainedMs_ >= lastViewMs_;
    return report.pause == Pause::noViews ||
           (since >= options.stepsBetweenViews && (isDue || model.isPaused()));
}

Result<void> WantedView::ask(PeripheralModel& model, trace::PathTracer& tracer,
                             const trace::Settings& settings, const LiveModelOptions& options) {
    MACULA_TRY(const std::optional<CandidatePose> wanted, model.wantedView());
    if (!wanted) {
        views_ = options.views;
        return {};
    }
    trace::Settings own = settings;
    // Without a new seed the model would learn the same noise from all views.
    own.seed += static_cast<std::uint32_t>(views_);
    tracer.forgetViews();
    MACULA_TRY_VOID(tracer.setSettings(own));
    const bool isRough = model.report().training.steps < options.roughSteps;
    const glm::ivec2 sizePx = isRough ? glm::ivec2(options.roughSidePx) : options.model.wanted.sizePx;
    MACULA_TRY_VOID(tracer.setView({.camera = wanted->camera, .width = sizePx.x, .height = sizePx.y}));
    wanted_ = wanted->camera;
    isTraced_ = false;
    lastViewMs_ = 0.0;
    return {};
}

Result<void> WantedView::trace(trace::PathTracer& tracer, std::uint32_t samplesPerPixel,
                               const std::function<bool()>& goesOn) {
    MACULA_TRY(const trace::Statistics before, tracer.statistics());
    if (before.samplesPerPixel < samplesPerPixel) {
        const auto missing = samplesPerPixel - static_cast<std::uint32_t>(before.samplesPerPixel);
        MACULA_TRY(const bool isWhole, tracer.trace(missing, goesOn));
        if (!isWhole || !goesOn()) return {};
    }
    MACULA_TRY(isTraced_, tracer.develop(goesOn));
    return {};
}

Result<void> WantedView::take(PeripheralModel& model, trace::PathTracer& tracer) {
    MACULA_TRY(TracedView view, readToLearnFrom(tracer, *wanted_));
    wanted_.reset();
    isTraced_ = false;
    ++views_;
    MACULA_TRY([[maybe_unused]] const Offered offered, model.offer(std::move(view)));
    stepsAtLastView_ = model.report().training.steps;
    trainedMs_ = 0.0;
    return {};
}

}  // namespace macula::hybrid
