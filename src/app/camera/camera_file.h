// The camera as a JSON file:
//   { "positionMm": [x, y, z], "targetMm": [x, y, z], "up": [x, y, z], "verticalFovDeg": 30 }
// in patient LPS mm. All four keys are needed, and no others are known.
#pragma once

#include <filesystem>

#include "base/camera.h"
#include "base/result.h"

namespace macula::app {

Result<Camera> readCamera(const std::filesystem::path& path);

}  // namespace macula::app
