// The grid of a volume, and the header of a volume file, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/frames.h"
#include "base/volume.h"
#include "formats/volume_file.h"

namespace macula::study {

// size, spacingMm, orientation, worldFromVoxel (rows; patient LPS mm).
nlohmann::ordered_json gridToJson(const glm::ivec3& size, const glm::dmat4& worldFromVoxel);

// The patient directions of increasing column, row and slice: "LPS".
std::string orientationOf(const glm::dmat4& worldFromVoxel);

// Whether two axes are more than 0.05 degrees off a right angle, as with a tilted gantry.
bool isSheared(const glm::dmat4& worldFromVoxel);

// Format, grid and assumptions; also unit and range of values, unless `volume` is null because it does not
// fit in memory.
nlohmann::ordered_json toJson(const formats::VolumeFileInfo& info, const Volume* volume);

}  // namespace macula::study
