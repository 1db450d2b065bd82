#include "live/frame/model_pictures.h"

#include <new>
#include <string>
#include <utility>

#include "base/log.h"
#include "base/timeline.h"

namespace macula::live {

namespace {

// Samples per pixel from which a picture on screen is worth learning from: with fewer it is too noisy, and
// more would add little to what the model knows by then.
constexpr std::uint32_t kLearntFromSamples = 4;

}  // namespace

void ModelPictures::otherStudy() {
    frame_.drop();
    estimate_.reset();
    phases_.forget();
    model_.putAwayAndDrop();
    model_.dropShelf();
}

void ModelPictures::roomChanged() {
    frame_.roomChanged();
    phases_.roomChanged();
    estimateHasRoom_ = true;
    hybrid::LiveModel* model = model_.live();
    if (model && model->news().stage == hybrid::ModelStage::noRoom) model->hide();
}

void ModelPictures::hide() {
    if (hybrid::LiveModel* model = model_.live()) model->hide();
}

void ModelPictures::failed() {
    frame_.drop();
    phases_.dropDevice();
    model_.saveAndDrop();
}

void ModelPictures::dropDevice() {
    frame_.drop();
    estimate_.reset();
    phases_.dropDevice();
    model_.saveAndDrop();
}

bool ModelPictures::hasFit() const {
    return canDrawModel() && hybrid::isFitToBeShown(model_.live()->news());
}

bool ModelPictures::drawsEstimate(const FrameInput& input) const {
    return frame_.isThere() && estimate_ && input.usesModel && !hasFit() &&
           estimate_->isOf(input.volume, input.drawing);
}

bool ModelPictures::isModelOf(const FrameInput& input) {
    return model_.live()->key() == model_.nameOf(input);
}

bool ModelPictures::isLoss(const Error& error) const {
    return device_.isLost() || error.code == ErrorCode::deviceLost;
}

Result<void> ModelPictures::withoutModel(const FrameInput& input, const Error& error) {
    if (isLoss(error)) return error;
    log::warning("There is no peripheral model of this: {}", error.message.english());
    model_.giveUp(error.code == ErrorCode::outOfMemory ? hybrid::ModelStage::noRoom
                                                       : hybrid::ModelStage::failed);
    frame_.drop();
    tellOfModel(input);
    return {};
}

Result<void> ModelPictures::withoutEstimate(const Error& error) {
    if (isLoss(error)) return error;
    log::warning("There is no estimate of this: {}", error.message.english());
    estimate_->forget();
    estimateHasRoom_ = false;
    return {};
}

Result<void> ModelPictures::apply(const FrameInput& input) {
    isPlayed_ = false;
    MACULA_TRY_VOID(applyModel(input));
    return makeEstimate(input);
}

Result<void> ModelPictures::applyModel(const FrameInput& input) {
    const TimelineStage stage("set model");
    model_.forgetWhyNone();
    if (!SceneModel::isPossible(input)) {
        hide();
        frame_.drop();
        return {};
    }
    if (const Result<void> made = model_.make(device_.device(), device_.traced()->tracer()); !made)
        return withoutModel(input, made.error());
    const hybrid::LiveModel& model = *model_.live();
    const std::string name = model_.nameOf(input);
    if (name == model.key() && !model.canBeDrawn() && !model.hasWork()) return {};  // it was given up
    const bool isNew = !frame_.isThere();
    if (isNew) {
        if (const Result<void> made = frame_.make(); !made) return withoutModel(input, made.error());
    }
    if (isNew || name != model.key() || !frame_.hasDisplayOf(input.drawing.settings)) {
        if (const Result<void> set = frame_.setScene(input.drawing.settings); !set)
            return withoutModel(input, set.error());
    }
    phases_.release(name);
    if (const Result<void> shown = model_.show(name, input); !shown)
        return withoutModel(input, shown.error());
    tellOfModel(input);
    return {};
}

// Keeps the last model that was fit, which estimates are made from, before another scene replaces it.
void ModelPictures::noteLearnt(const FrameInput& input) {
    if (!estimate_) estimate_.emplace(device_.device());
    if (hasFit() && !isModelOf(input) && model_.isOf(input.volume)) {
        const hybrid::LiveModel& model = *model_.live();
        estimate_->learnt(input.volume, model_.drawing(), model.shown(), model.gain());
    }
    estimate_->begin(input.volume, input.drawing);
}

// Makes an estimate of the input's scene, unless its model is fit to be shown.
Result<void> ModelPictures::makeEstimate(const FrameInput& input) {
    if (!frame_.isThere() || !hasModel() || !estimate_ || !estimateHasRoom_ || hasFit() ||
        !SceneModel::isPossible(input))
        return {};
    if (!estimate_->canTell(input.volume, input.drawing)) return {};
    const Result<void> made = guarded([&] { return estimate_->make(input.drawing); });
    return made ? Result<void>() : withoutEstimate(made.error());
}

Result<bool> ModelPictures::estimateEdit(const FrameInput& input) {
    noteLearnt(input);
    if (!frame_.isThere() || !hasModel() || !model_.hasShelf()) return false;
    const std::string name = model_.nameOf(input);
    if (name == model_.live()->key() || model_.isOnShelf(name)) return false;
    hide();
    MACULA_TRY_VOID(makeEstimate(input));
    if (!drawsEstimate(input)) return false;
    frame_.forgetFovea();
    return true;
}

void ModelPictures::forgetNeedlessEstimate() {
    if (estimate_ && hasFit()) estimate_->forget();
}

// Runs work that may use up the memory of the host, and returns that as an error.
Result<void> ModelPictures::guarded(const std::function<Result<void>()>& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        if (device_.isLost()) throw;
        return Error{ErrorCode::outOfMemory, Text("There is not enough memory for it."), {}, {}};
    }
}

Result<void> ModelPictures::work(double budgetMs, const std::function<bool()>& keepGoing) {
    return guarded([&] { return model_.live()->work(budgetMs, keepGoing); });
}

Result<void> ModelPictures::workWithin(double leftMs, const std::function<bool()>& keepGoing) {
    return guarded([&] { return model_.live()->workWithin(leftMs, keepGoing); });
}

// Once the picture is not denoised any more its guides may be gone: then the earlier fovea has to do.
Result<void> ModelPictures::keepForMotion(const FrameInput& input) {
    const TimelineStage stage("keep for motion");
    // A parallel camera shows splats alone: reprojection and learning need a perspective one.
    if (!canDrawModel() || !frame_.hasRoomForFovea() || isParallel(input.camera)) return {};
    TracedPictures& traced = *device_.traced();
    MACULA_TRY(const trace::Statistics statistics, traced.statistics());
    if (!statistics.denoised) return {};
    const trace::View view{.camera = input.camera, .width = traced.width(), .height = traced.height()};
    const auto samples = static_cast<std::uint32_t>(statistics.meanSamplesPerPixel);
    MACULA_TRY_VOID(
        frame_.adopt(traced.tracer(), {.whole = view, .gaze = input.gaze, .samplesPerPixel = samples}));
    if (samples < kLearntFromSamples) return {};
    if (const Result<void> learnt = model_.live()->learnFrom(traced.tracer(), view, samples); !learnt)
        return withoutModel(input, learnt.error());
    return {};
}

bool ModelPictures::wantsFovea(const FrameInput& input) const {
    return canDrawModel() && !drawsEstimate(input) && frame_.wantsFovea(input);
}

hybrid::Periphery ModelPictures::periphery(const FrameInput& input) {
    if (drawsEstimate(input))
        return {.draw = [this](const Camera& eye,
                               const glm::ivec2& sizePx) { return estimate_->draw(eye, sizePx); },
                .gain = static_cast<float>(estimate_->gain()),
                .isLikeness = false};
    hybrid::LiveModel& model = *model_.live();
    return {.draw = [&model](const Camera& eye, const glm::ivec2& sizePx) -> Result<hybrid::DrawnSplats> {
                MACULA_TRY(const splat::DevicePicture* picture, model.draw(eye, sizePx));
                return hybrid::DrawnSplats{picture, &model.drawnDepths()};
            },
            .gain = static_cast<float>(model.gain()),
            .isLikeness = true};
}

hybrid::FrameRequest ModelPictures::requestFor(const FrameInput& input) {
    return {.eyes = {input.camera},
            .sizePx = {input.width, input.height},
            .display = {.background = input.background,
                        .exposure = float(input.drawing.settings.exposure),
                        .toneMap = input.drawing.settings.toneMap}};
}

Result<const gpu::Image*> ModelPictures::draw(const FrameInput& input, float tracedShare) {
    frame_.forgetLast();
    isPlayed_ = false;
    TracedPictures& traced = *device_.traced();
    if (!canDrawModel() && !drawsEstimate(input)) return traced.display(input.background);
    const hybrid::Periphery splats = periphery(input);
    hybrid::FrameRequest request = requestFor(input);
    if (tracedShare > 0.0f) {
        MACULA_TRY(const trace::TracedLight light, traced.light());
        request.fadingIn = {.light = light, .share = tracedShare};
    }
    Result<const gpu::Image*> drawn = frame_.draw(request, splats);
    // Better without the fovea than without the model.
    if (!drawn && drawn.error().code == ErrorCode::outOfMemory && canDrawModel() && frame_.hasFovea()) {
        frame_.doWithoutFovea();
        drawn = frame_.draw(request, splats);
    }
    return drawn;
}

Result<const gpu::Image*> ModelPictures::drawTraced(const FrameInput& input) {
    frame_.forgetMix();
    isPlayed_ = false;
    TracedPictures& traced = *device_.traced();
    if (!traced.isNoisy() || !(hasFit() || drawsEstimate(input))) return traced.display(input.background);
    Result<const gpu::Image*> weighed = draw(input, 1.0f);
    if (weighed) return weighed;
    // Mixing may need more memory than drawing the model alone in motion, so the model stays then.
    if (drawsEstimate(input)) {
        MACULA_TRY_VOID(withoutEstimate(weighed.error()));
    } else if (weighed.error().code != ErrorCode::outOfMemory) {
        MACULA_TRY_VOID(withoutModel(input, weighed.error()));
    }
    return traced.display(input.background);
}

// The frame must have the display of the input already: to set it, the tracer needs the scene.
bool ModelPictures::canPlay(const FrameInput& input) {
    return SceneModel::isPossible(input) && frame_.isThere() && frame_.hasDisplayOf(input.drawing.settings) &&
           phases_.canDraw(input);
}

Result<const gpu::Image*> ModelPictures::drawPlayed(const FrameInput& input) {
    frame_.forgetLast();
    frame_.forgetFovea();  // of another phase
    isPlayed_ = true;
    MACULA_TRY(const hybrid::Periphery splats, phases_.periphery(input));
    return frame_.draw(requestFor(input), splats);
}

Result<void> ModelPictures::withoutPlayed(const Error& error) {
    isPlayed_ = false;
    if (isLoss(error)) return error;
    log::warning("A learnt phase could not be drawn: {}", error.message.english());
    phases_.doWithoutDrawing();
    return {};
}

bool ModelPictures::hasPhaseWork(const FrameInput& input) {
    if (!isComplete(input) || !SceneModel::isPossible(input) || !model_.hasShelf()) {
        phases_.rest();
        return false;
    }
    notePhase(input);
    return phases_.hasWork(input, hasModel() ? model_.live()->key() : std::string());
}

Result<void> ModelPictures::learnPhases(const FrameInput& input, double budgetMs,
                                        const std::function<bool()>& keepGoing) {
    const Result<void> done = guarded([&] { return phases_.work(input, budgetMs, keepGoing); });
    if (done || isLoss(done.error())) return done;
    log::warning("A phase could not be learnt: {}", done.error().message.english());
    phases_.giveUp(input, done.error());
    return {};
}

// The model on screen is that of its phase: it need not be learnt twice.
void ModelPictures::notePhase(const FrameInput& input) {
    if (!input.phases || !hasFit()) return;
    const hybrid::LiveModel& model = *model_.live();
    phases_.note(input, model.key(),
                 {.splats = model.shown(), .gain = model.gain(), .steps = model.news().steps});
}

hybrid::ModelNews ModelPictures::news() const {
    return isPlayed_ ? phases_.newsOfDrawn() : model_.news();
}

Result<void> ModelPictures::snapshot(const FrameInput& input, ModelSnapshot& taken) {
    if (!isComplete(input) || !canDrawModel()) return {};
    return model_.snapshot(input, taken);
}

}  // namespace macula::live
