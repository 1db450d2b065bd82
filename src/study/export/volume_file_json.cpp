#include "study/export/volume_file_json.h"

#include <nlohmann/json.hpp>

#include "base/english.h"
#include "study/export/grid_json.h"

namespace macula::study {

nlohmann::ordered_json toJson(const formats::VolumeFileInfo& info, const Volume* volume) {
    nlohmann::ordered_json json = {{"format", info.format}, {"values", info.values}};
    json.update(gridToJson(info.size, info.worldFromVoxel));
    json["calibrated"] = info.isCalibrated;
    json["sheared"] = isSheared(info.worldFromVoxel);
    if (volume != nullptr) {
        json["unit"] = volume->unitName();
        if (const auto& range = volume->valueRange()) json["valueRange"] = {range->low, range->high};
    }
    json["assumptions"] = inEnglish(info.assumptions);
    return json;
}

}  // namespace macula::study
