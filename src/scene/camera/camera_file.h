// The camera as a JSON file:
//   { "positionMm": [x, y, z], "targetMm": [x, y, z], "up": [x, y, z], "verticalFovDeg": 30,
//     "parallelHeightMm": 300 }
// in patient LPS mm. The first four keys are needed; the last makes the rays parallel, and says how high the
// picture is. No others are known.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/camera.h"
#include "base/result.h"

namespace macula {
class JsonNode;
}

namespace macula::app {

Result<Camera> readCamera(const std::filesystem::path& path);

// The object in a document, whose status() tells what is wrong with it. The numbers may still be no camera:
// see basis().
Camera cameraFrom(const JsonNode& node);
nlohmann::ordered_json toJson(const Camera& camera);

}  // namespace macula::app
