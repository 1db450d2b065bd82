// SecondVolumeState as JSON, in patient LPS mm; only "series" is required, and "volume" counts from 1:
//   "beside": { "series": "<SHA-256>", "volume": 2, "volumeKey": "…", "pair": "<SHA-256>",
//               "link": "registered", "secondFromStudy": [16 numbers, row by row], "boundMm": 0.8,
//               "doubtful": true, "rivalMm": 15, "view": "over", "window": {as slices_json.h},
//               "linksWindow": true, "opacity": 0.6, "colours": "hotIron", "in3d": true, "preset": {…},
//               "isodoses": {as isodoses_json.h} }
#pragma once

#include <nlohmann/json.hpp>

#include "scene/second/second_volume_state.h"

namespace macula {
class JsonNode;
}

namespace macula::scene {

// Null if the reader would refuse it.
nlohmann::ordered_json toJson(const SecondVolumeState& state);

// Errors go to the status of the node's document. studyStateFromJson reads "preset".
SecondVolumeState secondVolumeStateFrom(const JsonNode& node);

}  // namespace macula::scene
