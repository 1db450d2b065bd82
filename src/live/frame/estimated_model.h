// Estimates the peripheral model of a drawing that was only just chosen from the model that was learnt last
// (hybrid::SplatEstimate), so that the picture follows a hand that edits a curve or moves a clip, at full
// size, before the tracer has any of it.
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

namespace macula::app {

// Used by one thread at a time, the one that uses the device.
class EstimatedModel {
  public:
    explicit EstimatedModel(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    // Nothing was learnt of the volume yet: estimates are made from it alone, in the lights of the drawing.
    // Does nothing if canTell() allows the drawing already, or would not allow it afterwards either.
    void begin(const std::shared_ptr<const Volume>& volume, const Drawing& drawing);
    // From now on estimates are made from this model, which was learnt of that drawing of the volume and is
    // as bright as traced pictures times `gain`.
    void learnt(const std::shared_ptr<const Volume>& volume, const Drawing& drawing,
                std::shared_ptr<const splat::Splats> model, double gain);
    // Whether it can tell what that drawing looks like: another curve, clip or both of the same volume, in
    // the same lights. Gradient opacity, second volumes and coloured segments are not estimated.
    bool canTell(const std::shared_ptr<const Volume>& volume, const Drawing& drawing) const;
    // Makes the estimate of a drawing that canTell() allows; does nothing if it is there. outOfMemory.
    Result<void> make(const Drawing& drawing);
    bool isOf(const std::shared_ptr<const Volume>& volume, const Drawing& drawing) const;
    // Drops the estimate, and frees its memory on the device.
    void forget();

    // The splats and their depths, as LiveModel::draw, and LiveModel::gain: of what make() was asked for
    // last.
    Result<hybrid::DrawnSplats> draw(const Camera& eye, const glm::ivec2& sizePx);
    double gain() const { return gain_; }
    std::size_t splatCount() const { return splats_ ? splats_->size() : 0; }

  private:
    bool hasLearnt() const { return model_ && model_->size() > 0; }
    bool isInLightOf(const Drawing& drawing) const;
    hybrid::ShownMatter shownMatter(const Drawing& drawing);

    std::shared_ptr<gpu::Device> device_;
    std::shared_ptr<const Volume> volume_;
    Drawing learntOf_;
    std::shared_ptr<const splat::Splats> model_;  // of no splats: nothing was learnt
    double gain_ = 1.0;
    std::shared_ptr<const hybrid::CoarseMatter> matter_;  // of volume_, once it was needed
    std::optional<hybrid::SplatEstimate> estimate_;       // of model_, likewise
    Mask masked_;                                         // that bits_ are of
    std::shared_ptr<const MaskBits> bits_;
    Drawing shown_;  // of splats_
    std::shared_ptr<const splat::Splats> splats_;
    std::optional<splat::ModelPainter> painter_;
};

}  // namespace macula::app
