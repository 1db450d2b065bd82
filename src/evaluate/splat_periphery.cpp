#include "evaluate/splat_periphery.h"

namespace macula::evaluate {

hybrid::Periphery peripheryFor(splat::ModelPainter& painter, const glm::dvec3& originMm,
                               const Camera& shownTo, const Camera& now) {
    return {.draw = [&painter, originMm, shownTo, now](
                        const Camera& eye, const glm::ivec2& sizePx) -> Result<hybrid::DrawnSplats> {
        const Camera& from = eye == shownTo ? now : eye;
        MACULA_TRY(const splat::RasterView view, splat::rasterView(from, sizePx, originMm));
        MACULA_TRY(const splat::DevicePicture* picture, painter.drawOnDevice(view));
        return hybrid::DrawnSplats{picture, eye == from ? &painter.depthsOnDevice() : nullptr};
    }};
}

}  // namespace macula::evaluate
