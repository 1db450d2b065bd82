#include "live/frame/foveal_frame.h"

#include <chrono>
#include <utility>

#include "base/log.h"
#include "base/timeline.h"
#include "live/frame/picture_course.h"
#include "pipeline/hybrid/frame/fovea_size.h"

namespace macula::live {

Result<void> FovealFrame::make() {
    auto made = hybrid::HybridFrame::create(device_.device(), device_.traced()->tracer());
    if (!made) return made.error();
    frame_.emplace(*std::move(made));
    return {};
}

bool FovealFrame::hasDisplayOf(const trace::Settings& settings) const {
    return frame_->exposure() == settings.exposure && frame_->toneMap() == settings.toneMap;
}

double FovealFrame::msPerSample() const {
    return frame_->foveaMsPerSample().value_or(hybrid::guessedFoveaMsPerSample(*device_.device()));
}

bool FovealFrame::wantsFovea(const FrameInput& input) const {
    if (!hasRoom_ || isParallel(input.camera)) return false;
    if (input.interacting) return input.live.hasFovea && frame_->wantsFovea(input.camera, input.gaze);
    const double wholeMs = double(input.width) * input.height * msPerSample();
    return wholeMs > hybrid::kRestFoveaBudgetMs &&
           frame_->wouldGrow(input.camera, hybrid::kRestFoveaBudgetMs, input.gaze);
}

bool FovealFrame::hasTimeForFovea(const FrameInput& input) const {
    return frame_->foveaBudgetMs(input.live.foveaMs) >= hybrid::kLeastFoveaBudgetMs;
}

hybrid::FoveaAim FovealFrame::nextFovea(const FrameInput& input) const {
    const trace::View whole{.camera = input.camera, .width = input.width, .height = input.height};
    const bool isLarger = !input.interacting && frame_->isFoveaOf(input.camera, input.gaze);
    if (input.interacting)
        return hybrid::affordableFovea(whole, input.gaze, msPerSample(),
                                       frame_->foveaBudgetMs(input.live.foveaMs), input.live.fovea);
    return hybrid::affordableFovea(whole, input.gaze, msPerSample(),
                                   isLarger ? hybrid::kRestFoveaBudgetMs : hybrid::kFoveaBudgetMs);
}

Result<bool> FovealFrame::traceFovea(const FrameInput& input, const Interrupts& interrupts) {
    using Clock = std::chrono::steady_clock;
    const TimelineStage stage(nameOf(Step::traceFovea));
    const Clock::time_point start = Clock::now();
    const auto keepGoing = [&] {
        const auto spentMs = [&] {
            return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        };
        return !interrupts.stopping() && (!interrupts.newInput() || spentMs() < input.live.betweenFramesMs);
    };
    const auto traceSome = [&]() -> Result<bool> {
        if (!frame_->isTracing() || frame_->hasLeftAim(input.camera))
            MACULA_TRY_VOID(frame_->aim(nextFovea(input)));
        return frame_->traceFovea(keepGoing);
    };
    Result<bool> isThere = traceSome();
    if (isThere || isThere.error().code != ErrorCode::outOfMemory) return isThere;
    doWithoutFovea();
    return false;
}

Result<void> FovealFrame::adopt(trace::PathTracer& tracer, const hybrid::FoveaAim& aim) {
    const Result<void> kept = frame_->adopt(tracer, aim);
    if (!kept && kept.error().code != ErrorCode::outOfMemory) return kept.error();
    if (!kept) doWithoutFovea();
    return {};
}

void FovealFrame::doWithoutFovea() {
    log::warning("There is no room on the device for a traced fovea.");
    frame_->forgetFovea();
    hasRoom_ = false;
}

Result<const gpu::Image*> FovealFrame::draw(const hybrid::FrameRequest& request,
                                            const hybrid::Periphery& periphery) {
    MACULA_TRY(last_, frame_->draw(request, periphery));
    mixesModel_ = request.fadingIn && request.fadingIn->light.variances != nullptr;
    return std::exchange(last_.pictures, {}).front();
}

void FovealFrame::forgetLast() {
    last_ = {};
    mixesModel_ = false;
}

}  // namespace macula::live
