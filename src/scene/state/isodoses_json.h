// Isodoses as JSON:
//   { "shown": true, "unit": "percent", "reference": 60, "levels": [{"level": 95, "rgb": [255, 150, 0]}] }
// The unit is "percent" or "dose"; only "levels" is required.
#pragma once

#include <nlohmann/json.hpp>

#include "scene/second/isodoses.h"

namespace macula {
class JsonNode;
}

namespace macula::scene {

nlohmann::ordered_json toJson(const Isodoses& isodoses);

// Errors go to the status of the node's document.
Isodoses isodosesFrom(const JsonNode& node);

}  // namespace macula::scene
