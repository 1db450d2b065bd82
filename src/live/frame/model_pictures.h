// The pictures that a renderer draws of splats: of the scene's peripheral model, or of an estimate of it,
// with a traced fovea, and mixed with traced light.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "base/result.h"
#include "live/frame/estimated_model.h"
#include "live/frame/foveal_frame.h"
#include "live/frame/frame_input.h"
#include "live/frame/interrupts.h"
#include "live/frame/phase_models.h"
#include "live/frame/render_device.h"
#include "live/frame/render_reports.h"
#include "live/frame/scene_model.h"

namespace macula::live {

// If memory is lacking for the model, the estimate or the fovea, only that one is given up.
//
// Used by the render thread alone. `input` is always the renderer's newest. Methods that draw or work require
// a device that is ready, and the scene of the input on it; an estimate does not need the scene.
class ModelPictures {
  public:
    // `keeper` as in SceneModel.
    ModelPictures(RenderDevice& device, RenderReports& reports, std::shared_ptr<SceneKeeper> keeper)
        : device_(device), reports_(reports), frame_(device), model_(std::move(keeper)) {}

    // What has changed.
    void otherStudy();   // puts the model away, and drops what belongs to the study
    void roomChanged();  // the memory in use on the device
    void lookFor(const FrameInput& input) { model_.lookFor(input); }
    // Puts the model on the shelf, to free its memory.
    void hide();
    // After a failure: drops the model, and keeps only those parts of it that are on the host.
    void failed();
    // Before the device is dropped: as failed(), and nothing is left on it.
    void dropDevice();
    void putAway() {
        phases_.putAway();
        model_.putAwayAndDrop();
    }

    // Sets the model of the input's scene; from now on the previous one is not drawn any more. Makes an
    // estimate if the new model is not fit to be shown yet.
    Result<void> apply(const FrameInput& input);
    // Makes an estimate of an edited scene before the tracer has that scene. Returns false if no estimate can
    // be drawn, or if the scene has a model.
    Result<bool> estimateEdit(const FrameInput& input);
    // Frees the estimate once the model is fit.
    void forgetNeedlessEstimate();

    bool hasModel() const { return model_.live() != nullptr; }
    bool canDrawModel() const { return frame_.isThere() && model_.live() && model_.live()->canBeDrawn(); }
    bool isModelDrawable() const { return model_.live() && model_.live()->canBeDrawn(); }
    bool hasFit() const;
    // Whether splats are drawn from an estimate: it is better than a model that is not fit yet.
    bool drawsEstimate(const FrameInput& input) const;
    // Whether the model is that of the input's scene: of the same patient, preset, clip and lights.
    bool isModelOf(const FrameInput& input);

    bool hasWork() const { return model_.live() && model_.live()->hasWork(); }
    // As LiveModel::work and LiveModel::workWithin. Require hasModel().
    Result<void> work(double budgetMs, const std::function<bool()>& keepGoing);
    Result<void> workWithin(double leftMs, const std::function<bool()>& keepGoing);
    // Makes the traced picture of all pixels the fovea of the first frames of the next motion, and has the
    // model learn from it.
    Result<void> keepForMotion(const FrameInput& input);

    bool wantsFovea(const FrameInput& input) const;
    bool hasTimeForFovea(const FrameInput& input) const { return frame_.hasTimeForFovea(input); }
    Result<bool> traceFovea(const FrameInput& input, const Interrupts& interrupts) {
        return frame_.traceFovea(input, interrupts);
    }

    // The splats with the fovea over them, blended with the traced picture of all pixels by `tracedShare`. If
    // the model was given up during the fade, the traced picture alone.
    Result<const gpu::Image*> draw(const FrameInput& input, float tracedShare);
    // The traced picture; as long as its noise may be visible, with splats where those are less noisy. So the
    // change from splats to the traced picture never makes the picture worse.
    Result<const gpu::Image*> drawTraced(const FrameInput& input);
    const hybrid::Frame& lastFrame() const { return frame_.last(); }
    bool mixesModel() const { return frame_.mixesModel(); }

    // Give up the model or the estimate, so that tracing goes on without it. Return the error only if the
    // device was lost.
    Result<void> withoutModel(const FrameInput& input, const Error& error);
    Result<void> withoutEstimate(const Error& error);

    // Phases that are played, and learnt in the background (phase_models.h).
    // Whether the splats of the input's phase can be drawn in place of a traced picture.
    bool canPlay(const FrameInput& input);
    // Requires canPlay(). The scene of the input need not be on the device.
    Result<const gpu::Image*> drawPlayed(const FrameInput& input);
    bool isPlayed() const { return isPlayed_; }  // the last picture that was drawn
    Result<void> withoutPlayed(const Error& error);
    bool hasPhaseWork(const FrameInput& input);
    // As work(), for a phase that is not on screen. Gives the phase up if it cannot be learnt; an error is a
    // lost device.
    Result<void> learnPhases(const FrameInput& input, double budgetMs,
                             const std::function<bool()>& keepGoing);

    void tellOfModel(const FrameInput& input) { reports_.tellOfModel(input.study, news()); }
    hybrid::ModelNews news() const;  // of the played phase, while one is on screen
    std::optional<hybrid::PeripheralReport> report() const { return model_.report(); }
    // Fills in the model that can be drawn now, if it is that of the input's scene.
    Result<void> snapshot(const FrameInput& input, ModelSnapshot& taken);

  private:
    Result<void> applyModel(const FrameInput& input);
    void noteLearnt(const FrameInput& input);
    Result<void> makeEstimate(const FrameInput& input);
    Result<void> guarded(const std::function<Result<void>()>& work);
    bool isLoss(const Error& error) const;
    hybrid::Periphery periphery(const FrameInput& input);
    static hybrid::FrameRequest requestFor(const FrameInput& input);
    void notePhase(const FrameInput& input);

    // Destroyed in reverse: the keeper and the shelf of the model first, then what is on the device.
    RenderDevice& device_;
    RenderReports& reports_;
    FovealFrame frame_;
    std::optional<EstimatedModel> estimate_;  // reset when the study or volume changes
    bool estimateHasRoom_ = true;             // false: no memory for an estimate, until roomChanged()
    SceneModel model_;
    PhaseModels phases_{device_, reports_, model_};
    bool isPlayed_ = false;
};

}  // namespace macula::live
