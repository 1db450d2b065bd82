#include "evaluate/moving_frames.h"

#include <utility>

#include "evaluate/measurement.h"
#include "evaluate/shown_picture.h"
#include "evaluate/splat_periphery.h"
#include "pipeline/gpu/transfer.h"

namespace macula::evaluate {

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
    while (frame_.isTracing()) {
        if (progress_->cancelled()) return cancelledError();
        MACULA_TRY([[maybe_unused]] const bool isThere,
                   frame_.traceFovea([this] { return !progress_->cancelled(); }));
    }
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

}  // namespace macula::evaluate
