// How segmentations are shown, as JSON:
//   "segmentations": [
//     { "object": "<SHA-256 of the SOP Instance UID>", "shown": true,
//       "segments": [ { "number": 1, "visible": false, "rgb": [221, 130, 101], "opacity": 0.4,
//                       "in3d": "alone" } ] } ]
// Everything but "object" and "number" may be left out; "in3d" is "asIs", "alone" or "hidden". Labels are in
// the segmentation, and not here: they may name anybody. Keys that are not known are refused.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "scene/segments/segmentation_choice.h"

namespace macula {
class JsonNode;
}

namespace macula::app {

inline constexpr std::size_t kMostSegmentations = 1000;
inline constexpr std::size_t kMostSegments = 65535;  // of one

// What the reader would refuse is left out: a text that cannot be read would lose all of a state.
nlohmann::ordered_json segmentationsJson(std::span<const SegmentationChoice> choices);

// The node's document tells what is wrong with it.
std::vector<SegmentationChoice> segmentationsFrom(const JsonNode& node);

}  // namespace macula::app
