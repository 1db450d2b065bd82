// What a live model (live_model.h) draws: splats on the device, with a gain that makes them as bright as
// traced pictures.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/brightness_gauge.h"
#include "pipeline/splat/draw/device_picture.h"
#include "pipeline/splat/draw/model_painter.h"

namespace macula::hybrid {

using SharedSplats = std::shared_ptr<const splat::Splats>;

// Used by one thread at a time, the one that uses the device.
class DrawnModel {
  public:
    bool canDraw() const { return painter_.has_value(); }
    bool isOf(const SharedSplats& splats) const { return painter_ && splats == splats_; }
    const SharedSplats& splats() const { return splats_; }  // even if they cannot be drawn
    double gain() const { return gain_; }

    // Makes these splats drawable; without a whole `gauge` the gain stays.
    Result<void> show(const std::shared_ptr<gpu::Device>& device, const SharedSplats& splats,
                      const BrightnessGauge* gauge);
    Result<void> show(const std::shared_ptr<gpu::Device>& device, const SharedSplats& splats, double gain);
    void setGain(double gain) { gain_ = gain; }
    // After this the model cannot be drawn until the next show().
    void stopDrawing() { painter_.reset(); }
    void forget();

    // Only if canDraw(): as LiveModel::draw; then the Rasterizer::depths of that picture.
    Result<const splat::DevicePicture*> draw(const Camera& camera, const glm::ivec2& sizePx, double nearMm);
    const gpu::Buffer& depths() const { return painter_->depthsOnDevice(); }

  private:
    SharedSplats splats_;  // those of the painter, if there is one
    std::optional<splat::ModelPainter> painter_;
    double gain_ = 1.0;
};

}  // namespace macula::hybrid
