// The peripheral model of the scene that a renderer shows, and where models go that are put away.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "live/frame/frame_input.h"
#include "live/frame/render_events.h"
#include "live/frame/scene_ids.h"
#include "live/frame/scene_keeper.h"
#include "pipeline/hybrid/model/live_model.h"
#include "pipeline/hybrid/model/model_shelf.h"

namespace macula::live {

// Names scenes, has their models looked for, and owns the one that is shown. Shelf and names outlive the
// device; the model does not: save() it before the device is dropped.
//
// Used by the render thread alone.
class SceneModel {
  public:
    // `keeper` stores models between runs; null: none are stored.
    explicit SceneModel(std::shared_ptr<SceneKeeper> keeper) : keeper_(std::move(keeper)) {}

    // Whether the drawing can have a model, which holds its light: only lights that stay with the patient
    // can.
    static bool isPossible(const FrameInput& input);

    std::string nameOf(const FrameInput& input) { return names_.of(input.study, input.drawing); }
    // Has the keeper read the stored model while the volume is brought to the device.
    void lookFor(const FrameInput& input);
    // Whether a model of that scene was put on the shelf.
    bool isOnShelf(const std::string& name) const { return shelf_ && shelf_->find(name); }
    bool hasShelf() const { return shelf_ != nullptr; }

    // Makes the model and its shelf where they are missing.
    Result<void> make(const std::shared_ptr<gpu::Device>& device, const trace::PathTracer& beside);
    // As LiveModel::show. Requires make().
    Result<void> show(const std::string& name, const scene::Drawing& drawing);
    hybrid::LiveModel* live() { return model_ ? &*model_ : nullptr; }  // null: there is none
    const hybrid::LiveModel* live() const { return model_ ? &*model_ : nullptr; }
    // The drawing of the model's key.
    const scene::Drawing& drawing() const { return of_; }

    // There may be a model of the next scene, whatever became of this one.
    void forgetWhyNone() { whyNone_ = hybrid::ModelStage::none; }
    void giveUp(hybrid::ModelStage why);
    // These drop the model, and throw nothing. putAway: what it has learnt goes to the shelf and to the
    // keeper. save: only what is on the host does, because what the device did last may be lost or half of a
    // step.
    void putAway() { dropAfter(&hybrid::LiveModel::hide); }
    void save() { dropAfter(&hybrid::LiveModel::save); }
    // Models of another volume are of no use.
    void dropShelf() { shelf_.reset(); }

    hybrid::ModelNews news() const;
    std::optional<hybrid::PeripheralReport> report() const;
    // Fills in the model, if it is of the input.
    Result<void> snapshot(const FrameInput& input, ModelSnapshot& taken);

  private:
    void dropAfter(void (hybrid::LiveModel::*keep)());

    std::optional<hybrid::LiveModel> model_;
    hybrid::ModelStage whyNone_ = hybrid::ModelStage::none;  // why model_ is empty
    scene::Drawing of_;
    std::shared_ptr<hybrid::ModelShelf> shelf_;  // models of this volume
    std::shared_ptr<SceneKeeper> keeper_;
    std::string lookedFor_;  // the scene name last passed to the keeper
    SceneIds names_;
};

}  // namespace macula::live
