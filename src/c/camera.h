// A macula_camera, as a Camera.
#pragma once

#include <macula.h>

#include "base/camera.h"
#include "base/result.h"

namespace macula::c {

// usage for what is no camera.
Result<Camera> cameraOf(const macula_camera& given);
macula_camera toldOf(const Camera& camera);

}  // namespace macula::c
