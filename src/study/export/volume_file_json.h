// The header of a volume file as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/volume.h"
#include "formats/volume_file.h"

namespace macula::study {

// Format, grid and assumptions; also unit and range of values, unless `volume` is null because it does not
// fit in memory.
nlohmann::ordered_json toJson(const formats::VolumeFileInfo& info, const Volume* volume);

}  // namespace macula::study
