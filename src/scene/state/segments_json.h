// How segmentations are shown, as JSON:
//   "segmentations": [
//     { "object": "<SHA-256 of the SOP Instance UID>", "shown": true,
//       "segments": [ { "number": 1, "visible": false, "rgb": [221, 130, 101], "opacity": 0.4,
//                       "in3d": "alone", "colouredIn3d": true, "opacityIn3d": 0.5 } ] } ]
// Only "object" and "number" are required; "in3d" is "asIs", "alone" or "hidden". Labels stay in the
// segmentation, because they may identify a person. Unknown keys are refused.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "scene/segments/segmentation_settings.h"

namespace macula {
class JsonNode;
}

namespace macula::scene {

inline constexpr std::size_t kMostSegmentations = 1000;
inline constexpr std::size_t kMostSegments = 65535;  // of one segmentation

// Leaves out what the reader would refuse, because that would make the whole state unreadable.
nlohmann::ordered_json segmentationsJson(std::span<const SegmentationSettings> choices);

// Errors go to the status of the node's document.
std::vector<SegmentationSettings> segmentationsFrom(const JsonNode& node);

}  // namespace macula::scene
