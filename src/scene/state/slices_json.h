// How slices are shown, and what was measured on them, as JSON:
//   "slices": { "window": { "center": 40, "width": 400, "function": "LINEAR_EXACT" },
//               "slab": { "thicknessMm": 5, "projection": "maximum" },
//               "inverted": true, "asAcquired": true, "crosshairMm": [x, y, z] }
//   "measurements": [
//     { "kind": "distance", "label": "L3", "pointsMm": [[x, y, z], [x, y, z]], "normal": [x, y, z] },
//     { "kind": "angle", "pointsMm": [[x, y, z], [x, y, z], [x, y, z]], "normal": [x, y, z] },
//     { "kind": "ellipse", "centreMm": [x, y, z], "right": [x, y, z], "down": [x, y, z],
//       "radiiMm": [r, r], "normal": [x, y, z] } ]
// in patient LPS mm. Of "slices" everything may be left out, and of a measurement its label. A window without
// "function" is LINEAR (PS3.3 C.11.2.1.3). Keys that are not known are refused.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "scene/state/study_state.h"
#include "slices/measurement.h"

namespace macula {
class JsonNode;
}

namespace macula::app {

inline constexpr std::size_t kMostMeasurements = 1000;
inline constexpr std::size_t kLongestLabelBytes = 200;  // in UTF-8
inline constexpr double kThickestSlabMm = 1e4;

// What is not as by default. What the reader would refuse, such as what is not finite, is left out too: a
// text that cannot be read would lose all of a state. So is the explanation of a window, words of the file
// that may name anybody.
nlohmann::ordered_json toJson(const SliceState& state);

// Null where the reader would refuse it; without its explanation.
nlohmann::ordered_json windowJson(const DisplayWindow& window);
DisplayWindow windowFrom(const JsonNode& node);

// A measurement as above, whatever it is like.
nlohmann::ordered_json toJson(const slices::Measurement& measurement);
// Those that the reader takes, at most kMostMeasurements; labels are cut at kLongestLabelBytes.
nlohmann::ordered_json measurementsJson(std::span<const slices::Measurement> measurements);

// The node's document tells what is wrong with it. Directions are made unit vectors, and `down`
// perpendicular to `right`; those that are so already stay the same, to the bit.
SliceState sliceStateFrom(const JsonNode& node);
std::vector<slices::Measurement> measurementsFrom(const JsonNode& node);

}  // namespace macula::app
