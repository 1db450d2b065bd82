#include "evaluate/frame_makers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "evaluate/measurement.h"
#include "evaluate/shown_picture.h"
#include "pipeline/gpu/transfer.h"

namespace macula::evaluate {

namespace {

constexpr int kTrials = 2;  // the second has nearly the final size

}  // namespace

Result<TracedFrames> TracedFrames::create(std::shared_ptr<gpu::Device> device,
                                          const trace::PathTracer& beside, int bounces,
                                          const Progress& progress) {
    MACULA_TRY(trace::PathTracer tracer, beside.ofSameScene());
    return TracedFrames(std::move(device), std::move(tracer), bounces, progress);
}

Result<TracedFrames::Traced> TracedFrames::traceTwice(const Camera& camera, const TracingBudget& budget) {
    MACULA_TRY([[maybe_unused]] const Traced warm, trace(camera, budget));
    return trace(camera, budget);
}

Result<TracedFrames::Traced> TracedFrames::trace(const Camera& camera, const TracingBudget& budget) {
    const auto keepGoing = [this] { return !progress_->cancelled(); };
    tracer_.forgetViews();
    MACULA_TRY_VOID(
        tracer_.setSettings({.bounces = bounces_, .seed = ++count_, .denoising = trace::Denoising::on}));
    MACULA_TRY_VOID(tracer_.setView({.camera = camera, .width = budget.sizePx.x, .height = budget.sizePx.y}));
    MACULA_TRY_VOID(device_->waitForAll());
    Traced traced;
    Watch watch;
    MACULA_TRY([[maybe_unused]] const bool isWhole, tracer_.trace(budget.samplesPerPixel, keepGoing));
    if (progress_->cancelled()) return cancelledError();
    MACULA_TRY_VOID(device_->waitForAll());
    traced.traceMs = watch.lap().wallMs;
    MACULA_TRY([[maybe_unused]] const bool isDeveloped, tracer_.develop(keepGoing));
    if (progress_->cancelled()) return cancelledError();
    MACULA_TRY(const gpu::Image* picture, tracer_.display(glm::vec3(0.0f)));
    MACULA_TRY_VOID(device_->waitForAll());
    traced.otherMs = watch.lap().wallMs;
    MACULA_TRY(const auto rgba, gpu::read<std::uint8_t>(*picture));
    traced.shown = imageOf(rgba, budget.sizePx);
    return traced;
}

Result<TracedFrames::Costed> TracedFrames::make(const Camera& camera, const glm::ivec2& sizePx,
                                                std::uint32_t samplesPerPixel) {
    const TracingBudget budget{.sizePx = sizePx, .samplesPerPixel = samplesPerPixel};
    MACULA_TRY(Traced traced, traceTwice(camera, budget));
    return Costed{.frame = {.shown = std::move(traced.shown),
                            .ms = traced.traceMs + traced.otherMs,
                            .samplesPerPixel = samplesPerPixel},
                  .cost = costOfWhole(traced.traceMs, traced.otherMs, budget, sizePx)};
}

Result<MadeFrame> TracedFrames::makeIn(double budgetMs, const TracingCost& cost, const Camera& camera,
                                       const glm::ivec2& sizePx) {
    TracingBudget budget = affordable(cost, budgetMs, sizePx);
    // A small picture takes more time per pixel than a whole one, so the first guess is too large.
    for (int trial = 0; trial < kTrials; ++trial) {
        MACULA_TRY(const Traced tried, traceTwice(camera, budget));
        budget = affordable(costOfWhole(tried.traceMs, tried.otherMs, budget, sizePx), budgetMs, sizePx);
    }
    MACULA_TRY(const Traced traced, traceTwice(camera, budget));
    return MadeFrame{.shown = scaledTo(traced.shown, sizePx),
                     .ms = traced.traceMs + traced.otherMs,
                     .samplesPerPixel = budget.samplesPerPixel,
                     .resolutionShare = resolutionShareOf(budget, sizePx)};
}

Result<SplatFrames> SplatFrames::create(std::shared_ptr<gpu::Device> device, const trace::PathTracer& beside,
                                        int bounces, const splat::Splats& splats, const Progress& progress) {
    MACULA_TRY(hybrid::HybridFrame frame, hybrid::HybridFrame::create(device, beside));
    MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(device, splats));
    return SplatFrames(std::move(device), std::move(frame), std::move(painter), splats, bounces, progress);
}

Result<MadeFrame> SplatFrames::bare(const Camera& camera, const glm::ivec2& sizePx) {
    return make(camera, sizePx, 0);
}

Result<MadeFrame> SplatFrames::withFovea(const Camera& camera, const glm::ivec2& sizePx,
                                         std::uint32_t samplesPerPixel) {
    return make(camera, sizePx, samplesPerPixel);
}

Result<MadeFrame> SplatFrames::make(const Camera& camera, const glm::ivec2& sizePx,
                                    std::uint32_t samplesPerPixel) {
    const hybrid::Periphery periphery = peripheryFor(painter_, splats_->originMm, camera, camera);
    const hybrid::FoveaAim aim{.whole = {.camera = camera, .width = sizePx.x, .height = sizePx.y},
                               .sidePx = foveaSidePx(sizePx, camera.verticalFovDeg),
                               .samplesPerPixel = samplesPerPixel};
    const auto drawOnce = [&]() -> Result<hybrid::Frame> {
        if (samplesPerPixel > 0) MACULA_TRY_VOID(frame_.aim(aim));
        MACULA_TRY_VOID(evaluate::traceFovea(frame_, *progress_));
        MACULA_TRY(hybrid::Frame drawn,
                   frame_.draw({.eyes = {camera}, .sizePx = sizePx, .display = {}}, periphery));
        MACULA_TRY_VOID(device_->waitForAll());
        return drawn;
    };
    MadeFrame made{.samplesPerPixel = samplesPerPixel};
    for (const bool isMeasured : {false, true}) {
        if (progress_->cancelled()) return cancelledError();
        MACULA_TRY_VOID(frame_.setScene({.bounces = bounces_}));  // forgets fovea and views
        MACULA_TRY_VOID(device_->waitForAll());
        Watch watch;
        MACULA_TRY(const hybrid::Frame frame, drawOnce());
        made.ms = watch.lap().wallMs;
        if (!isMeasured) continue;
        if (samplesPerPixel > 0) made.foveaTimes = frame_.foveaTimes();
        MACULA_TRY(made.foveaWeights, foveaWeightsOf(frame, sizePx));
        MACULA_TRY(const auto rgba, gpu::read<std::uint8_t>(*frame.pictures.front()));
        made.shown = imageOf(rgba, sizePx);
    }
    return made;
}

namespace {

constexpr double kTickMs = 1e-3;  // resolution of a clock: a measured 0 means at most this
constexpr double kMostSamples = 4096.0;

double pixels(const glm::ivec2& sizePx) {
    return double(sizePx.x) * double(sizePx.y);
}

}  // namespace

TracingBudget affordable(const TracingCost& cost, double budgetMs, const glm::ivec2& sizePx) {
    const double perSampleMs = std::max(cost.perSampleMs, kTickMs);
    const double samples = std::floor((budgetMs - cost.fixedMs) / perSampleMs);
    if (samples >= 1.0)
        return {.sizePx = sizePx,
                .samplesPerPixel = static_cast<std::uint32_t>(std::min(samples, kMostSamples))};
    const double share = std::sqrt(std::max(budgetMs, 0.0) / (std::max(cost.fixedMs, 0.0) + perSampleMs));
    const auto side = [&](int wholePx) {
        const auto reducedPx = static_cast<int>(std::floor(share * double(wholePx)));
        return std::clamp(reducedPx, std::min(kLeastSidePx, wholePx), wholePx);
    };
    return {.sizePx = {side(sizePx.x), side(sizePx.y)}, .samplesPerPixel = 1};
}

double resolutionShareOf(const TracingBudget& budget, const glm::ivec2& sizePx) {
    return std::sqrt(pixels(budget.sizePx) / pixels(sizePx));
}

TracingCost costOfWhole(double traceMs, double otherMs, const TracingBudget& budget,
                        const glm::ivec2& sizePx) {
    MACULA_CHECK(budget.samplesPerPixel > 0);
    const double larger = pixels(sizePx) / pixels(budget.sizePx);
    return {.fixedMs = otherMs * larger, .perSampleMs = traceMs * larger / double(budget.samplesPerPixel)};
}

Result<MovingFrames> MovingFrames::create(std::shared_ptr<gpu::Device> device,
                                          const trace::PathTracer& beside, const splat::Splats& splats,
                                          const glm::ivec2& sizePx, const Progress& progress) {
    MACULA_TRY(hybrid::HybridFrame frame, hybrid::HybridFrame::create(device, beside));
    MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(device, splats));
    return MovingFrames(std::move(device), std::move(frame), std::move(painter), splats, sizePx, progress);
}

Result<double> MovingFrames::traceFovea(const Camera& eye, const TracedFovea& fovea) {
    fovea_.reset();
    MACULA_TRY_VOID(frame_.setScene({.bounces = fovea.bounces}));  // forgets fovea and views
    const hybrid::FoveaAim aim{.whole = {.camera = eye, .width = sizePx_.x, .height = sizePx_.y},
                               .fieldDeg = fovea.fieldDeg,
                               .sidePx = foveaSidePx(sizePx_, eye.verticalFovDeg, fovea.fieldDeg),
                               .samplesPerPixel = fovea.samplesPerPixel,
                               .denoising = fovea.isDenoised ? trace::Denoising::on : trace::Denoising::off};
    MACULA_TRY_VOID(device_->waitForAll());
    Watch watch;
    MACULA_TRY_VOID(frame_.aim(aim));
    MACULA_TRY_VOID(evaluate::traceFovea(frame_, *progress_));
    MACULA_TRY_VOID(device_->waitForAll());
    fovea_ = Traced{eye, fovea.samplesPerPixel};
    return watch.lap().wallMs;
}

Result<MadeFrame> MovingFrames::draw(const Camera& now, bool isWarped) {
    const Camera& shownTo = isWarped || !fovea_ ? now : fovea_->eye;
    const hybrid::Periphery periphery = peripheryFor(painter_, splats_->originMm, shownTo, now);
    const hybrid::FrameRequest request{.eyes = {shownTo}, .sizePx = sizePx_, .display = {}};
    MACULA_TRY([[maybe_unused]] const hybrid::Frame first, frame_.draw(request, periphery));
    MACULA_TRY_VOID(device_->waitForAll());
    Watch watch;
    MACULA_TRY(const hybrid::Frame second, frame_.draw(request, periphery));
    MACULA_TRY_VOID(device_->waitForAll());
    MadeFrame made{.ms = watch.lap().wallMs, .samplesPerPixel = fovea_ ? fovea_->samplesPerPixel : 0};
    MACULA_TRY(const auto rgba, gpu::read<std::uint8_t>(*second.pictures.front()));
    made.shown = imageOf(rgba, sizePx_);
    return made;
}

hybrid::Periphery peripheryFor(splat::ModelPainter& painter, const glm::dvec3& originMm,
                               const Camera& shownTo, const Camera& now) {
    return {.draw = [&painter, originMm, shownTo, now](
                        const Camera& eye, const glm::ivec2& sizePx) -> Result<hybrid::DrawnSplats> {
        const Camera& from = eye == shownTo ? now : eye;
        MACULA_TRY(const splat::RasterView view, splat::rasterView(from, sizePx, originMm));
        MACULA_TRY(const splat::DevicePicture* picture, painter.drawOnDevice(view));
        return hybrid::DrawnSplats{picture, eye == from ? &painter.depthsOnDevice() : nullptr};
    }};
}

Result<void> traceFovea(hybrid::HybridFrame& frame, const Progress& progress) {
    while (frame.isTracing()) {
        if (progress.cancelled()) return cancelledError();
        MACULA_TRY([[maybe_unused]] const bool isThere,
                   frame.traceFovea([&] { return !progress.cancelled(); }));
    }
    return {};
}

}  // namespace macula::evaluate
