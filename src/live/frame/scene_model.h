// The peripheral model of the scene that a renderer shows, and a shelf for models of earlier scenes.
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

// Names scenes, has the keeper look for their models, and owns the model that is shown. The shelf and the
// names outlive the device, the model does not: call saveAndDrop() before the device is dropped.
//
// Used by the render thread alone.
class SceneModel {
  public:
    // `keeper` stores models between runs; null: none are stored.
    explicit SceneModel(std::shared_ptr<SceneKeeper> keeper) : keeper_(std::move(keeper)) {}

    // Whether the scene can have a model: that holds its light, so the lights must stay with the patient.
    static bool isPossible(const FrameInput& input);

    std::string nameOf(const FrameInput& input) {
        return names_.of(input.study, input.drawing, input.volume);
    }
    std::string nameOf(std::uint64_t study, const PhaseScene& scene) {
        return names_.of(study, scene.drawing, scene.volume);
    }
    // Has the keeper read the stored model while the volume is brought to the device.
    void lookFor(const FrameInput& input);
    // Whether a model of that scene was put on the shelf.
    bool isOnShelf(const std::string& name) const { return shelf_ && shelf_->find(name); }
    bool hasShelf() const { return shelf_ != nullptr; }
    const std::shared_ptr<hybrid::ModelShelf>& shelf() const { return shelf_; }  // null: hasShelf() is false
    const std::shared_ptr<SceneKeeper>& keeper() const { return keeper_; }

    // Makes the model and the shelf if they are missing.
    Result<void> make(const std::shared_ptr<gpu::Device>& device, const trace::PathTracer& beside);
    // As LiveModel::show, for the scene of the input, whose name this is. Requires make().
    Result<void> show(const std::string& name, const FrameInput& input);
    hybrid::LiveModel* live() { return model_ ? &*model_ : nullptr; }  // null: there is none
    const hybrid::LiveModel* live() const { return model_ ? &*model_ : nullptr; }
    // The drawing and the volume of the model's key.
    const scene::Drawing& drawing() const { return of_; }
    bool isOf(const std::shared_ptr<const Volume>& volume) const { return ofVolume_.lock() == volume; }

    // Forgets why this scene has no model: the next one may have one.
    void forgetWhyNone() { whyNone_ = hybrid::ModelStage::none; }
    void giveUp(hybrid::ModelStage why);
    // These drop the model, and throw nothing. putAwayAndDrop: puts all it has learnt on the shelf, and has
    // the keeper store it. saveAndDrop: only what is on the host, because the last work of the device may be
    // lost or incomplete.
    void putAwayAndDrop() { dropAfter(&hybrid::LiveModel::hide); }
    void saveAndDrop() { dropAfter(&hybrid::LiveModel::save); }
    // Models of another study are of no use.
    void dropShelf() { shelf_.reset(); }

    hybrid::ModelNews news() const;
    std::optional<hybrid::PeripheralReport> report() const;
    // Fills in the model, if it is that of the input's scene.
    Result<void> snapshot(const FrameInput& input, ModelSnapshot& taken);

  private:
    void dropAfter(void (hybrid::LiveModel::*keep)());

    std::optional<hybrid::LiveModel> model_;
    hybrid::ModelStage whyNone_ = hybrid::ModelStage::none;  // why model_ is empty
    scene::Drawing of_;
    std::weak_ptr<const Volume> ofVolume_;
    std::shared_ptr<hybrid::ModelShelf> shelf_;  // models of this study, of each phase
    std::shared_ptr<SceneKeeper> keeper_;
    std::string lookedFor_;  // the scene name last passed to the keeper
    SceneIds names_;
};

}  // namespace macula::live
