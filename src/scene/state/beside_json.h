// BesideState as JSON:
//   "beside": { "series": "<SHA-256>", "link": "registered", "secondFromStudy": [16 numbers, row by row],
//               "boundMm": 0.8, "doubtful": true, "view": "over",
//               "window": {as slices_json.h}, "opacity": 0.6, "colours": "hotIron" }
// The transform is in patient LPS mm. Only "series" must be there.
#pragma once

#include <nlohmann/json.hpp>

#include "scene/second/beside_state.h"

namespace macula {
class JsonNode;
}

namespace macula::app {

// Null where the reader would refuse it.
nlohmann::ordered_json toJson(const BesideState& state);

// The node's document tells what is wrong with it.
BesideState besideStateFrom(const JsonNode& node);

}  // namespace macula::app
