// Estimates the peripheral model of a newly chosen drawing from the model learnt last
// (hybrid::SplatEstimate). So a full-size picture follows the user who edits a curve or moves a clip, before
// the tracer has the new drawing.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/estimate/splat_estimate.h"
#include "pipeline/hybrid/frame/compositor.h"
#include "pipeline/splat/draw/model_painter.h"
#include "scene/drawing/drawing.h"

namespace macula::live {

// Used by one thread at a time: the one that uses the device.
class EstimatedModel {
  public:
    explicit EstimatedModel(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    // From now on estimates are made from the voxels alone, in the light of the drawing: the volume has no
    // model yet. Does nothing if canTell() already accepts the drawing, or would not accept it afterwards.
    void begin(const std::shared_ptr<const Volume>& volume, const scene::Drawing& drawing);
    // From now on estimates are made from this model, which was learnt from that drawing of the volume. Its
    // light times `gain` is as bright as traced pictures (LiveModel::gain).
    void learnt(const std::shared_ptr<const Volume>& volume, const scene::Drawing& drawing,
                std::shared_ptr<const splat::Splats> model, double gain);
    // Whether an estimate of that drawing is possible: another curve, clip or both, of the same volume under
    // the same lights. False for gradient opacity, second volumes and coloured segments.
    bool canTell(const std::shared_ptr<const Volume>& volume, const scene::Drawing& drawing) const;
    // Makes the estimate; does nothing if it exists already. Requires canTell(). Fails with outOfMemory.
    Result<void> make(const scene::Drawing& drawing);
    bool isOf(const std::shared_ptr<const Volume>& volume, const scene::Drawing& drawing) const;
    // Drops the estimate, and frees its memory on the device.
    void forget();

    // The splats and depths of the drawing last passed to make(), as LiveModel::draw gives them; gain() is as
    // LiveModel::gain.
    Result<hybrid::DrawnSplats> draw(const Camera& eye, const glm::ivec2& sizePx);
    double gain() const { return gain_; }
    std::size_t splatCount() const { return splats_ ? splats_->size() : 0; }

  private:
    bool hasLearnt() const { return model_ && model_->size() > 0; }
    bool isInLightOf(const scene::Drawing& drawing) const;
    hybrid::ShownMatter shownMatter(const scene::Drawing& drawing);

    std::shared_ptr<gpu::Device> device_;
    std::shared_ptr<const Volume> volume_;
    scene::Drawing learntOf_;
    std::shared_ptr<const splat::Splats> model_;  // without splats: none was learnt
    double gain_ = 1.0;
    std::shared_ptr<const hybrid::CoarseMatter> matter_;  // matter of volume_; made when first needed
    std::optional<hybrid::SplatEstimate> estimate_;       // changes model_; made when first needed
    Mask masked_;                                         // the mask of bits_
    std::shared_ptr<const MaskBits> bits_;
    scene::Drawing shown_;  // the drawing of splats_
    std::shared_ptr<const splat::Splats> splats_;
    std::optional<splat::ModelPainter> painter_;
};

}  // namespace macula::live
