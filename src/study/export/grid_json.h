// Where the voxels of a volume lie, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/frames.h"

namespace macula::app {

// size, spacingMm, orientation, worldFromVoxel (rows; patient LPS mm).
nlohmann::ordered_json gridToJson(const glm::ivec3& size, const glm::dmat4& worldFromVoxel);

// Where columns, rows and slices run to: "LPS".
std::string orientationOf(const glm::dmat4& worldFromVoxel);

// The axes are not perpendicular, by more than 0.05 degrees: slices of a tilted gantry.
bool isSheared(const glm::dmat4& worldFromVoxel);

}  // namespace macula::app
