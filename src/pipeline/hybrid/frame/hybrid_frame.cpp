#include "pipeline/hybrid/frame/hybrid_frame.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/hybrid/frame/texel_room.h"

namespace macula::hybrid {

namespace {

// A frame that follows a hand waits for one dispatch.
constexpr double kDispatchMs = 12.0;
constexpr double kTurnsKeptMs = 300.0;
constexpr double kMostWallPerTracing = 20.0;  // a hand may pause for minutes

double msBetween(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

}  // namespace

Result<HybridFrame> HybridFrame::create(const std::shared_ptr<gpu::Device>& device,
                                        const trace::PathTracer& beside) {
    MACULA_TRY(trace::PathTracer tracer, beside.ofSameScene());
    tracer.setDispatchMs(kDispatchMs);
    MACULA_TRY(Reprojection reprojection, Reprojection::create(device));
    MACULA_TRY(Trust trust, Trust::create(device));
    return HybridFrame(device, std::move(tracer), std::move(reprojection), std::move(trust));
}

Result<void> HybridFrame::setScene(const trace::Settings& settings) {
    MACULA_CHECK(trace::isPathTraced(settings.look));
    fovea_.reset();
    aim_.reset();
    settings_ = settings;
    // Guides need a few more voxels. Asking for them later would restart an unfinished picture.
    settings_.denoising = trace::Denoising::on;
    settings_.errorThreshold = 0.0;
    tracer_.forgetViews();
    MACULA_TRY_VOID(tracer_.setSettings(settings_));
    // seenMm() needs a view, no matter which. This one is as large as the last picture, so that the next
    // picture can use the same film.
    const bool isFirst = count_ == 0;
    MACULA_TRY_VOID(
        tracer_.setView({.width = isFirst ? 64 : view_.width, .height = isFirst ? 64 : view_.height}));
    MACULA_TRY(seenMm_, tracer_.seenMm());
    return {};
}

Result<void> HybridFrame::aim(const FoveaAim& aim) {
    aim_.reset();
    MACULA_TRY(view_, trace::fovealWindow(aim.whole, aim.gaze, aim.fieldDeg, aim.sidePx));
    trace::Settings settings = settings_;
    settings.seed += count_++;
    settings.denoising = aim.denoising;
    MACULA_TRY_VOID(tracer_.setSettings(settings));
    MACULA_TRY_VOID(tracer_.setView(view_));
    aim_ = aim;
    begun_ = Clock::now();
    spentMs_ = 0.0;
    timesSoFar_ = {};
    return {};
}

Result<bool> HybridFrame::traceFovea(const std::function<bool()>& keepGoing) {
    MACULA_CHECK(aim_.has_value());
    const Clock::time_point start = Clock::now();
    const auto goOn = [&]() -> Result<bool> {
        MACULA_TRY(const trace::Statistics before, tracer_.statistics());
        if (before.samplesPerPixel < aim_->samplesPerPixel) {
            const auto missing = aim_->samplesPerPixel - static_cast<std::uint32_t>(before.samplesPerPixel);
            MACULA_TRY(const bool isTraced, tracer_.trace(missing, keepGoing));
            timesSoFar_.traceMs += msBetween(start, Clock::now());
            if (!isTraced || !keepGoing()) return false;
        }
        const Clock::time_point traced = Clock::now();
        Result<bool> isDeveloped = tracer_.develop(keepGoing);
        timesSoFar_.developMs += msBetween(traced, Clock::now());
        return isDeveloped;
    };
    Result<bool> isWhole = goOn();
    spentMs_ += msBetween(start, Clock::now());
    if (!isWhole || !*isWhole) return isWhole;
    fovea_.reset();
    const Clock::time_point developed = Clock::now();
    MACULA_TRY(CapturedPicture picture, reprojection_.capture(tracer_, view_, seenMm_));
    timesSoFar_.captureMs = msBetween(developed, Clock::now());
    times_ = timesSoFar_;
    fovea_.emplace(Fovea{std::move(picture), *aim_, begun_, false, spentMs_});
    msPerSample_ = spentMs_ / (double(aim_->sidePx) * double(aim_->sidePx) * double(aim_->samplesPerPixel));
    wallPerTracing_ = std::clamp(msBetween(begun_, Clock::now()) / spentMs_, 1.0, kMostWallPerTracing);
    aim_.reset();
    return true;
}

Result<void> HybridFrame::adopt(trace::PathTracer& tracer, const FoveaAim& aim) {
    fovea_.reset();
    aim_.reset();  // the unfinished picture belongs to an earlier motion
    const trace::View& view = aim.whole;
    const glm::dvec2 wholePx(view.width, view.height);
    // Cuts off as many pixels on both sides.
    const glm::ivec2 besidePx((glm::dvec2(1.0) - extentOf(aim, true).half) * wholePx * 0.5);
    MACULA_TRY(
        CapturedPicture picture,
        reprojection_.capture(tracer, view, seenMm_, glm::ivec2(view.width, view.height) - 2 * besidePx));
    fovea_.emplace(Fovea{std::move(picture), aim, Clock::now(), true});
    return {};
}

// An adopted fovea is centred in the view, and reaches to where a traced one around the gaze would end.
HybridFrame::Extent HybridFrame::extentOf(const FoveaAim& aim, bool isAdopted) {
    const double halfOfFrame = std::tan(0.5 * glm::radians(aim.whole.camera.verticalFovDeg));
    const double fovea = std::tan(0.5 * glm::radians(aim.fieldDeg)) / halfOfFrame;  // part of half the height
    const glm::dvec2 half = fovea * glm::dvec2(double(aim.whole.height) / aim.whole.width, 1.0);
    if (!isAdopted) return {.middle = aim.gaze, .half = half};
    return {.middle = glm::dvec2(0.0), .half = glm::min(glm::abs(aim.gaze) + half, glm::dvec2(1.0))};
}

// An eye that looks half a fovea away from its middle sees its edge.
bool HybridFrame::isWithinFovea(const glm::dvec2& gaze) const {
    const Extent there = extentOf(fovea_->aim, fovea_->isAdopted);
    const glm::dvec2 spare = glm::min(0.5 * extentOf(fovea_->aim, false).half, there.half);
    const glm::dvec2 reaches = glm::abs(gaze - there.middle) + spare;
    // Beyond the frame's own edge there is nothing to show.
    return glm::all(glm::lessThanEqual(glm::min(reaches, glm::dvec2(1.0)), there.half + 1e-9));
}

bool HybridFrame::isFoveaOf(const Camera& eye, const glm::dvec2& gaze) const {
    return fovea_ && fovea_->aim.whole.camera == eye && isWithinFovea(gaze);
}

// How many times larger than in the traced picture an eye sees the middle of the scene.
double HybridFrame::magnificationFor(const Camera& eye) const {
    const Camera& traced = fovea_->aim.whole.camera;
    const auto sizeFrom = [this](const Camera& from) {
        const double leastMm = 0.05 * seenMm_.diagonal();  // inside the scene all is near
        return 1.0 / (std::tan(0.5 * glm::radians(from.verticalFovDeg)) *
                      std::max({glm::length(from.positionMm - seenMm_.centre()), leastMm, 1e-6}));
    };
    return sizeFrom(eye) / sizeFrom(traced);
}

bool HybridFrame::wantsFovea(const Camera& eye, const glm::dvec2& gaze) const {
    if (!fovea_ || !isWithinFovea(gaze)) return true;
    if (isFoveaOf(eye, gaze)) return false;
    return !fovea_->isAdopted ||
           degreesAround(fovea_->picture.camera.positionMm, eye.positionMm) > kGoodForDeg ||
           magnificationFor(eye) > kMostMagnified;
}

bool HybridFrame::wouldGrow(const Camera& eye, double budgetMs, const glm::dvec2& gaze) const {
    const bool isWhole = fovea_ && fovea_->aim.fieldDeg > trace::kFovealFieldDeg - 1e-6;
    return !isFoveaOf(eye, gaze) || (!fovea_->isAdopted && !isWhole && fovea_->tracingMs < 0.5 * budgetMs);
}

double HybridFrame::degreesAround(const glm::dvec3& aMm, const glm::dvec3& bMm) const {
    const glm::dvec3 a = aMm - seenMm_.centre();
    const glm::dvec3 b = bMm - seenMm_.centre();
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

bool HybridFrame::hasLeftAim(const Camera& eye) const {
    return aim_ && degreesAround(view_.camera.positionMm, eye.positionMm) > kMostTurnDeg;
}

bool HybridFrame::showsFoveaTo(const Camera& eye) const {
    return fovea_ && !isParallel(eye) &&
           degreesAround(fovea_->picture.camera.positionMm, eye.positionMm) <= kMostTurnDeg;
}

void HybridFrame::noteTurn(const glm::dvec3& eyeMm) {
    const Clock::time_point now = Clock::now();
    turns_.push_back({now, lastEyeMm_ ? degreesAround(*lastEyeMm_, eyeMm) : 0.0});
    while (msBetween(turns_.front().at, now) > kTurnsKeptMs) turns_.pop_front();
    lastEyeMm_ = eyeMm;
}

double HybridFrame::foveaBudgetMs(double mostMs) const {
    double degrees = 0.0;
    for (const Turn& turn : turns_) degrees += turn.degrees;
    if (!(degrees > 0.0)) return mostMs;
    // Half of the turn passes while the fovea is traced, and half while it is shown.
    const double leftMs = 0.5 * kMostTurnDeg * kTurnsKeptMs / degrees;
    return std::min(mostMs, leftMs / wallPerTracing_);
}

// Once for each fovea: the splats change little while it is shown.
Result<void> HybridFrame::weighFovea(const Periphery& periphery) {
    if (fovea_->isWeighed) return {};
    const CapturedPicture& picture = fovea_->picture;
    MACULA_TRY(const DrawnSplats splats, periphery.draw(picture.camera, picture.sizePx));
    if (splats.depthSums == nullptr) return {};
    const gpu::Buffer& lights = picture.lights.texels.buffer();
    const trace::TracedLight light{
        .values = &lights, .counts = &lights, .areMeans = true, .variances = &picture.variances};
    MACULA_TRY_VOID(trust_.weigh(light, *splats.picture, periphery.gain, picture.trusts));
    fovea_->isWeighed = true;
    return {};
}

// Gives a fovea full trust again: these splats are not a likeness to weigh it against.
Result<void> HybridFrame::trustFovea() {
    if (!fovea_->isWeighed) return {};
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "trust"));
    recorder.fill(fovea_->picture.trusts.buffer(), std::bit_cast<std::uint32_t>(1.0f));
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    fovea_->isWeighed = false;
    return {};
}

Result<void> HybridFrame::addFadingIn(Layers& layers, const FadingIn& fadingIn) {
    layers.traced = &fadingIn.light;
    layers.tracedShare = fadingIn.share;
    if (fadingIn.light.variances == nullptr) return {};
    const std::uint64_t pixels = std::uint64_t(layers.sizePx.x) * std::uint64_t(layers.sizePx.y);
    MACULA_TRY_VOID(makeRoom(trusts_, device_, "trust in a traced picture", VK_FORMAT_R32_SFLOAT, pixels));
    MACULA_TRY_VOID(trust_.weigh(fadingIn.light, *layers.splats, layers.splatGain, *trusts_));
    layers.tracedTrusts = &*trusts_;
    return {};
}

Result<Frame> HybridFrame::draw(const FrameRequest& request, const Periphery& periphery) {
    MACULA_CHECK(!request.eyes.empty());
    MACULA_CHECK(request.eyes.size() == 1 || !request.fadingIn);
    MACULA_CHECK(request.sizesPx.empty() || request.sizesPx.size() == request.eyes.size());
    while (compositors_.size() < request.eyes.size()) {
        MACULA_TRY(Compositor compositor, Compositor::create(device_));
        compositors_.push_back(std::move(compositor));
    }
    noteTurn(request.eyes.front().positionMm);
    const bool hidesFovea = request.fadingIn && request.fadingIn->share >= 1.0f;
    const auto showsFovea = [&](const Camera& eye) { return !hidesFovea && showsFoveaTo(eye); };
    if (std::any_of(request.eyes.begin(), request.eyes.end(), showsFovea))
        MACULA_TRY_VOID(periphery.isLikeness ? weighFovea(periphery) : trustFovea());
    Frame frame;
    for (std::size_t i = 0; i < request.eyes.size(); ++i) {
        const Camera& eye = request.eyes[i];
        const glm::ivec2 sizePx = request.sizesPx.empty() ? request.sizePx : request.sizesPx[i];
        MACULA_TRY(const DrawnSplats splats, periphery.draw(eye, sizePx));
        Layers layers{.splats = splats.picture, .sizePx = sizePx, .splatGain = periphery.gain};
        ReprojectedPicture fovea;
        if (showsFovea(eye)) {
            MACULA_TRY(fovea, reprojection_.reproject(
                                  fovea_->picture, eye, sizePx, seenMm_, kEdgeFade,
                                  splats.depthSums != nullptr ? std::optional(splats) : std::nullopt));
            layers.fovea = &fovea;
            frame.foveaWeights = &fovea.weights->buffer();
        }
        if (request.fadingIn) MACULA_TRY_VOID(addFadingIn(layers, *request.fadingIn));
        MACULA_TRY(const gpu::Image* picture, compositors_[i].compose(layers, request.display));
        frame.pictures.push_back(picture);
    }
    if (showsFovea(request.eyes.front())) {
        frame.foveaAgeMs = msBetween(fovea_->begun, Clock::now());
        frame.foveaSamples = fovea_->aim.samplesPerPixel;
        const glm::ivec2 firstPx = request.sizesPx.empty() ? request.sizePx : request.sizesPx.front();
        const glm::dvec2 part = reprojectedRegion(fovea_->picture.camera, fovea_->picture.sizePx,
                                                  request.eyes.front(), firstPx, seenMm_)
                                    .sizePx;
        frame.foveaShare = std::min(1.0, part.x * part.y / (double(firstPx.x) * firstPx.y));
    }
    return frame;
}

}  // namespace macula::hybrid
