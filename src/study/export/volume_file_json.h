// What a file that is one volume holds, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/volume.h"
#include "formats/volume_file.h"

namespace macula::app {

// Format, grid, and what was assumed; with `volume`, which may be null where memory does not suffice for it,
// its unit and range of values too.
nlohmann::ordered_json toJson(const formats::VolumeFileInfo& info, const Volume* volume);

}  // namespace macula::app
