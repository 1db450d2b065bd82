// How slices are shown, as JSON:
//   "slices": { "window": { "center": 40, "width": 400, "function": "LINEAR_EXACT" },
//               "slab": { "thicknessMm": 5, "projection": "maximum" },
//               "inverted": true, "asAcquired": true, "crosshairMm": [x, y, z], "turn": [w, x, y, z],
//               "curveMm": [[x, y, z], …], "colours": "hotIron" }
// in patient LPS mm. All keys are optional. A window without "function" is LINEAR (PS3.3 C.11.2.1.3). "turn"
// is a quaternion. Unknown keys are refused.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "scene/state/study_state.h"

namespace macula {
class JsonNode;
}

namespace macula::scene {

inline constexpr double kThickestSlabMm = 1e4;
inline constexpr std::size_t kMostCurvePoints = 1000;

// Writes what differs from the default. Leaves out what the reader would refuse, such as numbers that are not
// finite, because that would make the whole state unreadable; and the explanation of a window, which is text
// from the file that may identify a person.
nlohmann::ordered_json toJson(const SliceState& state);

// Null if the reader would refuse it. Without the window's explanation.
nlohmann::ordered_json windowJson(const DisplayWindow& window);
DisplayWindow windowFrom(const JsonNode& node);

// Errors go to the status of the node's document. Turns are normalised; those that already are keep every
// bit.
SliceState sliceStateFrom(const JsonNode& node);

}  // namespace macula::scene
