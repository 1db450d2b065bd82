#include "evaluate/splat_periphery.h"

namespace macula::evaluate {

hybrid::Periphery peripheryFor(splat::ModelPainter& painter, const glm::dvec3& originMm, const Camera& now) {
    return {.draw = [&painter, originMm, now](const Camera& eye,
                                              const glm::ivec2& sizePx) -> Result<hybrid::DrawnSplats> {
        MACULA_TRY(const splat::RasterView view, splat::rasterView(now, sizePx, originMm));
        MACULA_TRY(const splat::DevicePicture* picture, painter.drawOnDevice(view));
        return hybrid::DrawnSplats{picture, eye == now ? &painter.depthsOnDevice() : nullptr};
    }};
}

}  // namespace macula::evaluate
