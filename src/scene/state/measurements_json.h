// What was measured on slices, as keys of a study's state:
//   "measurements": [
//     { "kind": "distance", "label": "L3", "pointsMm": [[x, y, z], [x, y, z]], "normal": [x, y, z] },
//     { "kind": "angle", "pointsMm": [[x, y, z], [x, y, z], [x, y, z]], "normal": [x, y, z] },
//     { "kind": "ellipse", "centreMm": [x, y, z], "right": [x, y, z], "down": [x, y, z],
//       "radiiMm": [r, r], "normal": [x, y, z] } ],
//   "furtherMeasurements": [
//     { "kind": "bidirectional", "node": true, "pointsMm": [4 points: one axis, then the other], "normal": …
//     }, { "kind": "cobb angle", "pointsMm": [4 points: one line, then the other], "normal": … }, { "kind":
//     "arrow", "pointsMm": [tip, tail], "normal": … }, { "kind": "outline", "pointsMm": [3 to 1000 points],
//     "normal": … }, { "kind": "line", "pointsMm": [2 to 1000 points], "normal": … } ],
//   "measurementOrder": [2, 0, 1]
// in patient LPS mm. Labels, "node" and all three keys are optional. Unknown keys of a measurement are
// refused. A Macula before 1.0 knows only the first key, in which any other kind would make the whole state
// unreadable; it keeps the other two as they are. The order says at which place of both lists, one after the
// other, each measurement is; without it they are in that order, and also where it does not fit the lists,
// which such a Macula may have changed.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "slices/measurement.h"

namespace macula {
class JsonNode;
}

namespace macula::scene {

inline constexpr std::size_t kMostMeasurements = 1000;
inline constexpr std::size_t kMostDrawnPoints = 1000;   // of an outline or a line
inline constexpr std::size_t kLongestLabelBytes = 200;  // in UTF-8

// A measurement as above, even if the reader would refuse it.
nlohmann::ordered_json toJson(const slices::Measurement& measurement);

// Adds the keys where there is something to write: the measurements that the reader accepts, at most
// kMostMeasurements; cuts labels at kLongestLabelBytes.
void addMeasurements(std::span<const slices::Measurement> measurements, nlohmann::ordered_json& state);

// Of the state's object. Errors go to the status of the node's document. Directions are normalised, and
// `down` is made perpendicular to `right`; directions that already are keep every bit.
std::vector<slices::Measurement> measurementsFrom(const JsonNode& state);

}  // namespace macula::scene
