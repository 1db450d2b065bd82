// Cuts along the viewing direction and with scissors, and named clips, as JSON:
//   "cuts": { "eye": { "normal": [x, y, z], "offsetMm": 12, "fromMiddleMm": 3, "followsCamera": true },
//             "scissors": [ { "camera": {as camera_file.h}, "outline": [x, y, x, y, …],
//                             "removes": "outside" } ] }
//   "namedClips": [ { "name": "lungs", "clip": {as presets/clip}, "cuts": {as above} } ]
// Lengths are in patient LPS mm, outlines in half heights of the picture. Without "removes", scissors remove
// the inside. Required are the outline and its camera, normal and offset, and names. Unknown keys are
// refused.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/clip/cuts.h"

namespace macula {
class JsonNode;
}

namespace macula::scene {

// Writes only what is set. Leaves out what the reader would refuse, because that would make the whole state
// unreadable. Names are cut at kLongestClipNameBytes.
nlohmann::ordered_json toJson(const Cuts& cuts);
nlohmann::ordered_json namedClipsJson(const std::vector<NamedClip>& clips);

// Errors go to the status of the node's document. Normals are normalised; unit vectors keep every bit.
Cuts cutsFrom(const JsonNode& node);

// `all` is valid JSON. Error: inputNotUsable if it is not a list of named clips; the error names `where`.
Result<std::vector<NamedClip>> namedClipsFrom(const nlohmann::ordered_json& all, const std::string& where);

}  // namespace macula::scene
