#include "pipeline/hybrid/model/drawn_model.h"

#include <utility>

namespace macula::hybrid {

Result<void> DrawnModel::show(const std::shared_ptr<gpu::Device>& device, const SharedSplats& splats,
                              const BrightnessGauge* gauge) {
    if (isOf(splats)) return {};
    painter_.reset();
    splats_ = splats;
    MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(device, *splats_));
    if (gauge != nullptr && gauge->isWhole()) {
        MACULA_TRY(gain_, gauge->gainOf(painter, splats_->originMm));
    }
    painter_.emplace(std::move(painter));
    return {};
}

Result<void> DrawnModel::show(const std::shared_ptr<gpu::Device>& device, const SharedSplats& splats,
                              double gain) {
    MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(device, *splats));
    painter_.emplace(std::move(painter));
    splats_ = splats;
    gain_ = gain;
    return {};
}

void DrawnModel::forget() {
    painter_.reset();
    splats_.reset();
    gain_ = 1.0;
}

Result<const splat::DevicePicture*> DrawnModel::draw(const Camera& camera, const glm::ivec2& sizePx,
                                                     double nearMm) {
    MACULA_TRY(const splat::RasterView view, splat::rasterView(camera, sizePx, splats_->originMm, nearMm));
    return painter_->drawOnDevice(view);
}

}  // namespace macula::hybrid
