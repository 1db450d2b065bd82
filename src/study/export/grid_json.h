// The grid of a volume as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/frames.h"

namespace macula::study {

// size, spacingMm, orientation, worldFromVoxel (rows; patient LPS mm).
nlohmann::ordered_json gridToJson(const glm::ivec3& size, const glm::dmat4& worldFromVoxel);

// The patient directions of increasing column, row and slice: "LPS".
std::string orientationOf(const glm::dmat4& worldFromVoxel);

// Whether two axes are more than 0.05 degrees off a right angle, as with a tilted gantry.
bool isSheared(const glm::dmat4& worldFromVoxel);

}  // namespace macula::study
