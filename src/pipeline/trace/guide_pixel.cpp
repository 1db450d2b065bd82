#include "pipeline/trace/guide_pixel.h"

#include "pipeline/trace/scene.h"

namespace macula::trace {

Result<shared::GuidePush> guidePush(const View& now, const View& before) {
    MACULA_TRY(const CameraBasis eye, basis(before.camera));
    const FoveaInPlane fovea = foveaInPlane(before);
    return shared::GuidePush{.oursMm = now.camera.positionMm - before.camera.positionMm,
                             .right = eye.right * fovea.halfSize.x,
                             .up = eye.up * fovea.halfSize.y,
                             .forward = eye.forward,
                             .planeHalfSize = fovea.halfSize,
                             .gaze = fovea.gaze,
                             .foveaRadius = static_cast<float>(fovea.radius),
                             .foveaMagnification = static_cast<float>(fovea.magnification),
                             .parallelMm = static_cast<float>(fovea.parallelMm),
                             .firstRow = 0};
}

}  // namespace macula::trace
