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
#include "live/frame/render_device.h"
#include "live/frame/render_reports.h"
#include "live/frame/scene_model.h"

namespace macula::live {

// Without memory for the model, the estimate or the fovea each is given up alone, and the others go on.
//
// Used by the render thread alone. The input is the renderer's newest one. Methods that draw or work require
// a device that is ready, and the scene of the input on it.
class ModelPictures {
  public:
    // `keeper` as in SceneModel.
    ModelPictures(RenderDevice& device, RenderReports& reports, std::shared_ptr<SceneKeeper> keeper)
        : device_(device), reports_(reports), frame_(device), model_(std::move(keeper)) {}

    // What has changed.
    void otherStudy();   // puts the model away, and drops all that is of the study
    void roomChanged();  // the memory in use on the device
    void lookFor(const FrameInput& input) { model_.lookFor(input); }
    // Puts the model on the shelf, to free its memory.
    void hide();
    // After a failure: of the model, what is on the host is kept.
    void failed();
    // Before the device is dropped: as failed(), and nothing is left on it.
    void dropDevice();
    void putAway() { model_.putAway(); }

    // From here on no picture of the model of before is drawn any more. Makes an estimate where the scene's
    // own model is not there yet.
    Result<void> apply(const FrameInput& input);
    // Before the tracer has any of an edited scene: makes an estimate of it. False: none can be drawn, or
    // there is more than an estimate.
    Result<bool> estimateEdit(const FrameInput& input);
    // Frees the estimate once the model is fit.
    void forgetNeedlessEstimate();

    bool hasModel() const { return model_.live() != nullptr; }
    bool canDraw() const { return frame_.isThere() && model_.live() && model_.live()->canBeDrawn(); }
    bool canModelBeDrawn() const { return model_.live() && model_.live()->canBeDrawn(); }
    bool hasFit() const;
    // Whether splats are those of an estimate, which is better than a model that is not fit yet.
    bool drawsEstimate(const FrameInput& input) const;
    // Whether no model is drawn of another patient, preset, clip or light than those of the input.
    bool isModelOf(const FrameInput& input);

    bool hasWork() const { return model_.live() && model_.live()->hasWork(); }
    // As LiveModel::work and LiveModel::workWithin. Require hasModel().
    Result<void> work(double budgetMs, const std::function<bool()>& keepGoing);
    Result<void> workWithin(double leftMs, const std::function<bool()>& keepGoing);
    // Takes the traced picture of all pixels as the fovea of the first frames of the next motion, and has the
    // model learn from it.
    Result<void> keepForMotion(const FrameInput& input);

    bool wantsFovea(const FrameInput& input) const;
    bool hasTimeForFovea(const FrameInput& input) const { return frame_.hasTimeForFovea(input); }
    Result<bool> traceFovea(const FrameInput& input, const Interrupts& interrupts) {
        return frame_.traceFovea(input, interrupts);
    }

    // The splats with the fovea over them, and the traced picture of all pixels with that share. Where the
    // model was given up while it fades, that picture alone: it is of what is wanted.
    Result<const gpu::Image*> draw(const FrameInput& input, float tracedShare);
    // The traced picture. Where splats are better they stay, until the noise cannot be seen: what is shown
    // does not get worse.
    Result<const gpu::Image*> drawTraced(const FrameInput& input);
    const hybrid::Frame& lastFrame() const { return frame_.last(); }
    bool mixesModel() const { return frame_.mixesModel(); }

    // Goes on without the model or the estimate; returns the error if the device was lost. Whatever keeps
    // them from being made or drawn does not keep anybody from tracing.
    Result<void> withoutModel(const FrameInput& input, const Error& error);
    Result<void> withoutEstimate(const Error& error);

    void tellOfModel(const FrameInput& input) { reports_.tellOfModel(input.study, news()); }
    hybrid::ModelNews news() const { return model_.news(); }
    std::optional<hybrid::PeripheralReport> report() const { return model_.report(); }
    // Fills in what is drawn now, if it is of the input.
    Result<void> snapshot(const FrameInput& input, ModelSnapshot& taken);

  private:
    Result<void> applyModel(const FrameInput& input);
    void noteLearnt(const FrameInput& input);
    Result<void> makeEstimate(const FrameInput& input);
    Result<void> guarded(const std::function<Result<void>()>& work);
    bool isLoss(const Error& error) const;
    hybrid::Periphery periphery(const FrameInput& input);

    // Destroyed in reverse: the keeper and the shelf of the model first, then what is on the device.
    RenderDevice& device_;
    RenderReports& reports_;
    FovealFrame frame_;
    std::optional<EstimatedModel> estimate_;  // reset when the study or volume changes
    bool estimateHasRoom_ = true;             // false: no memory for one until that in use changes
    SceneModel model_;
};

}  // namespace macula::live
