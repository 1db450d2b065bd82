// How slices are shown, and what was measured on them, as JSON:
//   "slices": { "window": { "center": 40, "width": 400, "function": "LINEAR_EXACT" },
//               "slab": { "thicknessMm": 5, "projection": "maximum" },
//               "inverted": true, "asAcquired": true, "crosshairMm": [x, y, z], "turn": [w, x, y, z],
//               "curveMm": [[x, y, z], …], "colours": "hotIron" }
//   "measurements": [
//     { "kind": "distance", "label": "L3", "pointsMm": [[x, y, z], [x, y, z]], "normal": [x, y, z] },
//     { "kind": "angle", "pointsMm": [[x, y, z], [x, y, z], [x, y, z]], "normal": [x, y, z] },
//     { "kind": "ellipse", "centreMm": [x, y, z], "right": [x, y, z], "down": [x, y, z],
//       "radiiMm": [r, r], "normal": [x, y, z] } ]
// in patient LPS mm. All keys of "slices" are optional, and so is the label of a measurement. A window
// without "function" is LINEAR (PS3.3 C.11.2.1.3). "turn" is a quaternion. Unknown keys are refused.
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

namespace macula::scene {

inline constexpr std::size_t kMostMeasurements = 1000;
inline constexpr std::size_t kLongestLabelBytes = 200;  // in UTF-8
inline constexpr double kThickestSlabMm = 1e4;
inline constexpr std::size_t kMostCurvePoints = 1000;

// Writes what differs from the default. Leaves out what the reader would refuse, such as numbers that are not
// finite, because that would make the whole state unreadable; and the explanation of a window, which is text
// from the file that may identify a person.
nlohmann::ordered_json toJson(const SliceState& state);

// Null if the reader would refuse it. Without the window's explanation.
nlohmann::ordered_json windowJson(const DisplayWindow& window);
DisplayWindow windowFrom(const JsonNode& node);

// A measurement as above, even if the reader would refuse it.
nlohmann::ordered_json toJson(const slices::Measurement& measurement);
// The measurements that the reader accepts, at most kMostMeasurements; cuts labels at kLongestLabelBytes.
nlohmann::ordered_json measurementsJson(std::span<const slices::Measurement> measurements);

// Errors go to the status of the node's document. Directions and turns are normalised, and `down` is made
// perpendicular to `right`; directions that already are keep every bit.
SliceState sliceStateFrom(const JsonNode& node);
std::vector<slices::Measurement> measurementsFrom(const JsonNode& node);

}  // namespace macula::scene
