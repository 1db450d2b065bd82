// The camera as a JSON file:
//   { "positionMm": [x, y, z], "targetMm": [x, y, z], "up": [x, y, z], "verticalFovDeg": 30,
//     "parallelHeightMm": 300 }
// in patient LPS mm. The first four keys are required; "parallelHeightMm" makes the rays parallel and is the
// height of the picture. Any other key is an error.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/camera.h"
#include "base/result.h"

namespace macula {
class JsonNode;
}

namespace macula::scene {

Result<Camera> readCamera(const std::filesystem::path& path);

// Reads the camera from a JSON object; the status() of its document holds any error. The camera may still be
// invalid: see basis().
Camera cameraFrom(const JsonNode& node);
nlohmann::ordered_json toJson(const Camera& camera);

}  // namespace macula::scene
