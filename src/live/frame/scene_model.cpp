#include "live/frame/scene_model.h"

#include <exception>
#include <utility>

#include "base/log.h"

namespace macula::live {

namespace {

constexpr std::uint64_t kShelfBytes = std::uint64_t(1) << 30;

}  // namespace

bool SceneModel::isPossible(const FrameInput& input) {
    return input.usesModel && trace::isPathTraced(input.drawing.settings.look) &&
           input.drawing.lights->frame == trace::LightFrame::patient;
}

void SceneModel::lookFor(const FrameInput& input) {
    // Phases that are played are sought by PhaseModels: a disk must not read ten of them a second.
    if (!keeper_ || !isComplete(input) || !isPossible(input) || input.playsPhases) return;
    std::string name = nameOf(input);
    if (name == lookedFor_) return;
    lookedFor_ = std::move(name);
    if (!isOnShelf(lookedFor_)) keeper_->willShow(lookedFor_, input.volume, input.drawing);
}

Result<void> SceneModel::make(const std::shared_ptr<gpu::Device>& device, const trace::PathTracer& beside) {
    if (!shelf_) shelf_ = std::make_shared<hybrid::ModelShelf>(kShelfBytes);
    if (model_) return {};
    auto made = hybrid::LiveModel::create(device, beside, shelf_, keeper_, hybrid::liveModelOptions(*device));
    if (!made) return made.error();
    model_.emplace(*std::move(made));
    return {};
}

Result<void> SceneModel::show(const std::string& name, const FrameInput& input) {
    MACULA_TRY_VOID(model_->show(name, input.drawing.settings));
    of_ = input.drawing;
    ofVolume_ = input.volume;
    return {};
}

void SceneModel::giveUp(hybrid::ModelStage why) {
    if (model_)
        model_->giveUp(why);
    else
        whyNone_ = why;
}

void SceneModel::dropAfter(void (hybrid::LiveModel::*keep)()) {
    try {
        if (model_) ((*model_).*keep)();
    } catch (const std::exception&) {
        log::warning("There was no memory to keep the peripheral model.");
    }
    model_.reset();
}

hybrid::ModelNews SceneModel::news() const {
    return model_ ? model_->news() : hybrid::ModelNews{.stage = whyNone_};
}

std::optional<hybrid::PeripheralReport> SceneModel::report() const {
    return model_ ? model_->report() : std::nullopt;
}

Result<void> SceneModel::snapshot(const FrameInput& input, ModelSnapshot& taken) {
    if (model_->key() != nameOf(input)) return {};
    taken.splats = model_->shown();
    taken.gain = model_->gain();
    if (input.requestsTraining) {
        MACULA_TRY(taken.state, model_->state());
    }
    return {};
}

}  // namespace macula::live
