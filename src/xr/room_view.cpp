#include "xr/room_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/log.h"
#include "pipeline/hybrid/frame/fovea_size.h"
#include "pipeline/trace/device_scene.h"

namespace macula::xr {

namespace {

using Clock = std::chrono::steady_clock;

// Distance in a picture of -1 to 1: if the gaze moves farther, an unfinished fovea is abandoned.
constexpr double kLooksElsewhere = 0.25;
constexpr int kLeastSidePx = 32;
constexpr double kWidestFieldDeg = 150.0;
constexpr std::size_t kMostSizes = 2;  // of pictures at a time: eyes and insets
// A frame waits for the running dispatch, and the headset for the frame.
constexpr double kDispatchMs = 8.0;
constexpr std::uint64_t kScene = 1;  // the room has only one study

std::uint32_t samplesIn(RoomQuality quality, std::uint32_t ofBalanced) {
    return std::max(ofBalanced * mostSamplesOf(quality) / mostSamplesOf(RoomQuality::balanced), 1u);
}

Result<void> checkDrawing(const scene::Drawing& drawing) {
    if (!trace::isPathTraced(drawing.settings.look))
        return Error{ErrorCode::usage, Text("In a headset only path-traced pictures can be shown."), "",
                     Text("Choose the cinematic or the clear look.")};
    if (drawing.lights->frame != trace::LightFrame::patient)
        return Error{ErrorCode::usage,
                     Text("These lights hang on the camera, and in a headset there are two eyes."), "",
                     Text("Choose lights that stay in place; macula presets lists them.")};
    return {};
}

}  // namespace

Result<RoomView> RoomView::create(const std::shared_ptr<gpu::Device>& device, RoomScene scene,
                                  std::shared_ptr<hybrid::ModelShelf> shelf, const RoomOptions& options) {
    MACULA_CHECK(scene.volume && scene.drawing.transferFunction && scene.drawing.lights);
    MACULA_TRY_VOID(checkDrawing(scene.drawing));
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    MACULA_TRY_VOID(tracer.scene().setVolume(scene.volume));
    MACULA_TRY_VOID(tracer.scene().setClip(scene.drawing.clip ? *scene.drawing.clip : Clip{}));
    if (scene.drawing.additions) MACULA_TRY_VOID(tracer.scene().setAdditions(*scene.drawing.additions));
    MACULA_TRY_VOID(tracer.scene().setTransferFunction(*scene.drawing.transferFunction));
    MACULA_TRY_VOID(tracer.scene().setEnvironment(trace::Environment::fromRig(*scene.drawing.lights)));
    MACULA_TRY_VOID(tracer.setSettings(scene.drawing.settings));
    MACULA_TRY_VOID(tracer.setView({.width = 64, .height = 64}));  // seenMm() needs a view
    MACULA_TRY(hybrid::HybridFrame hybrid, hybrid::HybridFrame::create(device, tracer));
    hybrid::LiveModelOptions modelOptions = options.model.value_or(hybrid::liveModelOptions(*device));
    if (!modelOptions.dispatchMs) modelOptions.dispatchMs = kDispatchMs;
    MACULA_TRY(hybrid::LiveModel model,
               hybrid::LiveModel::create(device, tracer, std::move(shelf), nullptr, modelOptions));
    RoomView view(device, std::move(scene), options, std::move(tracer), std::move(hybrid), std::move(model));
    view.shown_ = view.state();
    MACULA_TRY_VOID(view.applyScene());
    return view;
}

Result<void> RoomView::applyScene() {
    aimed_.reset();
    MACULA_TRY(seenMm_, tracer_.seenMm());
    if (seenMm_.low.x > seenMm_.high.x)
        return Error{ErrorCode::inputNotUsable, Text("Nothing of this study can be seen."), "",
                     Text("Choose another preset, or another clip.")};
    MACULA_TRY_VOID(hybrid_.setScene(scene_.drawing.settings));
    if (options_.learns && !isForALook_)
        MACULA_TRY_VOID(model_.show(names_.of(kScene, scene_.drawing), scene_.drawing.settings));
    return {};
}

Result<hybrid::DrawnSplats> RoomView::drawSplats(const Camera& eye, const glm::ivec2& sizePx) {
    if (drawsModel()) {
        auto picture = model_.draw(eye, sizePx, nearMm_);
        if (picture) return hybrid::DrawnSplats{*picture, &model_.drawnDepths()};
        if (picture.error().code != ErrorCode::outOfMemory) return picture.error();
        if (!std::exchange(hasSaidNoRoom_, true))
            log::warning("There is no room for the peripheral model beside the pictures of the headset.");
    }
    for (const splat::DevicePicture& nothing : nothing_)
        if (nothing.width == sizePx.x && nothing.height == sizePx.y)
            return hybrid::DrawnSplats{&nothing, nullptr};
    if (nothing_.size() >= kMostSizes) nothing_.erase(nothing_.begin());
    const std::vector<glm::vec4> pixels(std::size_t(sizePx.x) * std::size_t(sizePx.y), glm::vec4(0.0f));
    MACULA_TRY(splat::DevicePicture made,
               splat::DevicePicture::upload(device_, "nothing learnt", sizePx.x, sizePx.y, pixels));
    nothing_.push_back(std::move(made));
    return hybrid::DrawnSplats{&nothing_.back(), nullptr};
}

hybrid::Periphery RoomView::periphery() {
    return {.draw = [this](const Camera& eye, const glm::ivec2& sizePx) { return drawSplats(eye, sizePx); },
            .gain = static_cast<float>(model_.gain()),
            .isLikeness = drawsModel() && hybrid::isFitToBeShown(model_.news())};
}

RoomState RoomView::state() const {
    return {.transferFunction = scene_.drawing.transferFunction,
            .clip = scene_.drawing.clip,
            .quality = scene_.quality};
}

Result<RoomPictures> RoomView::draw(const EyePictures& eyes, const EyePictures* insets,
                                    const RoomLook& look) {
    hybrid::FrameRequest request;
    for (const EyePictures* pictures : {&eyes, insets}) {
        if (!pictures) continue;
        for (const EyePicture& eye : pictures->eyes) {
            request.eyes.push_back(eye.camera);
            request.sizesPx.push_back(pictures->sizePx);
        }
    }
    request.sizePx = eyes.sizePx;
    request.display.exposure = static_cast<float>(scene_.drawing.settings.exposure * look.light);
    request.display.toneMap = scene_.drawing.settings.toneMap;
    request.display.keepsCoverage = look.keepsCoverage;
    if (look.depths && !depths_) {
        MACULA_TRY(depths_, hybrid::EyeDepths::create(device_));
    }
    RoomPictures pictures;
    hybrid::Periphery splats = periphery();
    // The depths of splats are valid until the next eye is drawn. The fovea also draws splats, but is not an
    // eye.
    splats.draw = [&](const Camera& eye, const glm::ivec2& sizePx) -> Result<hybrid::DrawnSplats> {
        MACULA_TRY(const hybrid::DrawnSplats drawn, drawSplats(eye, sizePx));
        const bool isEye = std::find(request.eyes.begin(), request.eyes.end(), eye) != request.eyes.end();
        if (look.depths && drawn.depthSums != nullptr && isEye) {
            MACULA_TRY(const gpu::Buffer* depths, depths_->make(pictures.depths.size(), drawn, *look.depths));
            pictures.depths.push_back(depths);
        }
        return drawn;
    };
    MACULA_TRY(pictures.frame, hybrid_.draw(request, splats));
    if (pictures.depths.size() != request.eyes.size()) pictures.depths.clear();
    return pictures;
}

Work RoomView::nextWork() const {
    // The first picture is a traced one.
    return wants(Work::model) && hybrid_.hasFovea() && !wasTurnOfModel_ ? Work::model : Work::fovea;
}

Result<void> RoomView::work(Work work, const EyePictures& eyes, const WorkRequest& request) {
    const auto end = Clock::now() + std::chrono::duration<double, std::milli>(request.budgetMs);
    const std::function<bool()> keepGoing = [end] { return Clock::now() < end; };
    wasTurnOfModel_ = work == Work::model;
    return wasTurnOfModel_ ? model_.work(request.budgetMs, keepGoing) : traceFovea(eyes, request, keepGoing);
}

Result<void> RoomView::traceFovea(const EyePictures& eyes, const WorkRequest& request,
                                  const std::function<bool()>& keepGoing) {
    const bool isOverModel = drawsModel();
    const glm::dvec2& gaze = request.gaze;
    const std::uint32_t mostSamples = samplesIn(shown_.quality, request.mostSamples);
    const bool isSameKind = aimed_ && aimed_->isOverModel == isOverModel;
    // The coarse picture of the whole view would cover the model's splats.
    if (aimed_ && !isSameKind) hybrid_.forgetFovea();
    const bool looksElsewhere =
        isSameKind && isOverModel && glm::length(aimed_->gaze - gaze) > kLooksElsewhere;
    if (!hybrid_.isTracing() || !isSameKind || looksElsewhere || hybrid_.hasLeftAim(eyes.centre)) {
        const bool isSame = isSameKind && aimed_->aim.whole.camera == eyes.centre && aimed_->gaze == gaze &&
                            hybrid_.isFoveaOf(eyes.centre, aimed_->aim.gaze);
        Aimed next{
            .aim = isSame ? aimed_->aim : newFovea(eyes, request), .gaze = gaze, .isOverModel = isOverModel};
        if (isSame) {
            // While neither head nor eyes move, traces again with twice the samples, up to `mostSamples`.
            if (next.aim.samplesPerPixel >= mostSamples) return {};
            next.aim.samplesPerPixel *= 2;
        }
        MACULA_TRY_VOID(hybrid_.aim(next.aim));
        aimed_ = next;
    }
    MACULA_TRY([[maybe_unused]] const bool isThere, hybrid_.traceFovea(keepGoing));
    return {};
}

// While there is no model, a coarse picture of the whole view, straight ahead.
hybrid::FoveaAim RoomView::newFovea(const EyePictures& eyes, const WorkRequest& request) const {
    const double msPerSample = hybrid_.foveaMsPerSample().value_or(hybrid::guessedFoveaMsPerSample(*device_));
    const double budgetMs =
        std::max(foveaShareOf(shown_.quality) * hybrid_.foveaBudgetMs(hybrid::kFoveaBudgetMs),
                 hybrid::kLeastFoveaBudgetMs);
    const glm::ivec2 finePx =
        glm::ivec2(glm::round(glm::dvec2(eyes.sizePx) * std::max(request.fineness, 1.0)));
    if (drawsModel())
        return hybrid::affordableFovea({.camera = eyes.centre, .width = finePx.x, .height = finePx.y},
                                       request.gaze, msPerSample, budgetMs);
    const trace::View whole{.camera = eyes.centre, .width = eyes.sizePx.x, .height = eyes.sizePx.y};
    const double halfHeight = std::tan(0.5 * glm::radians(eyes.centre.verticalFovDeg));
    const double half = halfHeight * std::max(1.0, double(eyes.sizePx.x) / eyes.sizePx.y);
    const int mostPx = std::max(eyes.sizePx.x, eyes.sizePx.y);
    const int affordablePx = static_cast<int>(std::sqrt(budgetMs / msPerSample));
    return {.whole = whole,
            .gaze = glm::dvec2(0.0),
            .fieldDeg = std::min(2.0 * glm::degrees(std::atan(half)), kWidestFieldDeg),
            .sidePx = std::clamp(affordablePx, std::min(kLeastSidePx, mostPx), mostPx)};
}

Result<void> RoomView::apply(const RoomState& state) {
    const bool isOtherPreset = state.transferFunction != shown_.transferFunction;
    const bool isOtherClip = state.clip != shown_.clip;
    shown_ = state;
    if (isOtherClip) MACULA_TRY_VOID(tracer_.scene().setClip(state.clip ? *state.clip : Clip{}));
    if (isOtherPreset) MACULA_TRY_VOID(tracer_.scene().setTransferFunction(*state.transferFunction));
    return applyScene();
}

Result<bool> RoomView::show(const RoomState& state, Lasts lasts) {
    const bool isForALook = lasts == Lasts::forALook;
    if (state == shown_ && isForALook == isForALook_) return true;
    if (!state.transferFunction || !validate(*state.transferFunction)) return false;
    if (state.clip && !validate(*state.clip)) return false;
    RoomState finer = shown_;
    finer.quality = state.quality;
    if (state == finer && isForALook == isForALook_) {  // quality changes neither scene nor model
        shown_.quality = state.quality;
        if (!isForALook) scene_.quality = state.quality;
        return true;
    }
    const scene::Drawing before = scene_.drawing;
    const RoomQuality qualityBefore = scene_.quality;
    const RoomState shownBefore = shown_;
    const bool wasForALook = isForALook_;
    isForALook_ = isForALook;
    if (!isForALook) {
        scene_.drawing.transferFunction = state.transferFunction;
        scene_.drawing.clip = state.clip;
        scene_.quality = state.quality;
    }
    const Result<void> applied = apply(state);
    if (applied) return true;
    scene_.drawing = before;
    scene_.quality = qualityBefore;
    isForALook_ = wasForALook;
    if (applied.error().code != ErrorCode::inputNotUsable) return applied.error();
    MACULA_TRY_VOID(apply(shownBefore));
    return false;
}

Result<bool> RoomView::cut(const HalfSpace& kept) {
    Clip clip = scene_.drawing.clip ? *scene_.drawing.clip : Clip{};
    if (clip.planes.size() >= Clip::kMostPlanes) return false;
    clip.planes.push_back(kept);
    RoomState next = state();
    next.clip = std::make_shared<const Clip>(std::move(clip));
    return show(next);
}

}  // namespace macula::xr
