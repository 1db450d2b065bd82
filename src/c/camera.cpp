#include "c/camera.h"

#include "c/last_error.h"

namespace macula::c {

namespace {

glm::dvec3 vectorOf(const double (&numbers)[3]) {
    return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

Result<Camera> cameraOf(const macula_camera& given) {
    Camera camera{.positionMm = vectorOf(given.position_mm),
                  .targetMm = vectorOf(given.target_mm),
                  .up = vectorOf(given.up),
                  .parallelHeightMm = given.parallel_height_mm};
    if (given.vertical_fov_deg != 0.0) camera.verticalFovDeg = given.vertical_fov_deg;
    // A negative height is a mistake, not a camera in perspective.
    if (!(camera.parallelHeightMm >= 0.0))
        return badArgument(Text("The height of a picture with parallel rays is not usable."),
                           Text("Give millimetres above 0, or 0 for a camera with an eye."));
    MACULA_TRY_VOID(basis(camera));
    return camera;
}

macula_camera toldOf(const Camera& camera) {
    macula_camera told{};
    told.size = sizeof told;
    for (int axis = 0; axis < 3; ++axis) {
        told.position_mm[axis] = camera.positionMm[axis];
        told.target_mm[axis] = camera.targetMm[axis];
        told.up[axis] = camera.up[axis];
    }
    told.vertical_fov_deg = camera.verticalFovDeg;
    told.parallel_height_mm = camera.parallelHeightMm;
    return told;
}

}  // namespace macula::c
