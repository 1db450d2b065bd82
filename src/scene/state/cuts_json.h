// What was cut away from where somebody looked, and clips under a name, as JSON:
//   "cuts": { "eye": { "normal": [x, y, z], "offsetMm": 12, "fromMiddleMm": 3, "followsCamera": true },
//             "scissors": [ { "camera": {as camera_file.h}, "outline": [x, y, x, y, …],
//                             "removes": "outside" } ] }
//   "namedClips": [ { "name": "lungs", "clip": {as presets/clip}, "cuts": {as above} } ]
// in patient LPS mm, outlines in half heights of the picture. Without "removes" it is the inside. Everything
// but the outline and its camera, normal and offset, and names may be left out. Keys that are not known are
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

namespace macula::app {

// What is there. What the reader would refuse is left out: a text that cannot be read would lose all of a
// state. Names are cut at kLongestClipNameBytes.
nlohmann::ordered_json toJson(const Cuts& cuts);
nlohmann::ordered_json namedClipsJson(const std::vector<NamedClip>& clips);

// The node's document tells what is wrong with it. Normals are made unit vectors; those that are so already
// stay the same, to the bit.
Cuts cutsFrom(const JsonNode& node);

// Of valid JSON. inputNotUsable when it is no list of clips with names; `where` is for the error.
Result<std::vector<NamedClip>> namedClipsFrom(const nlohmann::ordered_json& all, const std::string& where);

}  // namespace macula::app
