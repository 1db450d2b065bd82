// A macula_camera, as a Camera.
#pragma once

#include <macula.h>

#include "base/camera.h"
#include "base/result.h"

namespace macula::c {

// usage if the numbers do not make a camera.
Result<Camera> cameraOf(const macula_camera& given);
macula_camera toldOf(const Camera& camera);

}  // namespace macula::c
