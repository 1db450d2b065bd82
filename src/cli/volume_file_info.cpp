#include "cli/volume_file_info.h"

#include <nlohmann/json.hpp>

#include "base/phantom.h"
#include "cli/shared/json_text.h"
#include "formats/volume_file.h"
#include "study/export/grid_json.h"

namespace macula::cli {

namespace {

// `volume` is null where memory does not suffice for it.
void show(const formats::VolumeFileInfo& info, const Volume* volume, bool isJson) {
    const nlohmann::ordered_json json = study::toJson(info, volume);
    if (isJson) {
        fmt::print("{}\n", jsonText(nlohmann::ordered_json{{"volumeFile", json}}));
        return;
    }
    const auto mm = json["spacingMm"].get<std::vector<double>>();
    fmt::print("{}  {}  {} x {} x {}  {:.4g} x {:.4g} x {:.4g} mm{}  {}\n", info.format, info.values,
               info.size.x, info.size.y, info.size.z, mm[0], mm[1], mm[2],
               info.isCalibrated ? "" : ", not calibrated", study::orientationOf(info.worldFromVoxel));
    if (volume != nullptr && volume->valueRange()) {
        fmt::print("  values {:g} to {:g}{}{}\n", volume->valueRange()->low, volume->valueRange()->high,
                   volume->unitName().empty() ? "" : " ", volume->unitName());
    }
    if (study::isSheared(info.worldFromVoxel)) fmt::print("  the axes are not perpendicular (sheared)\n");
    for (const Text& assumption : info.assumptions) fmt::print("  assumed: {}\n", assumption.english());
}

}  // namespace

Result<void> showVolumeFile(const std::filesystem::path& path, bool json, Progress& progress) {
    MACULA_TRY(formats::VolumeFileInfo info, formats::readVolumeFileInfo(path));
    const auto volume = formats::readVolumeFile(path, progress);
    if (!volume && volume.error().code != ErrorCode::outOfMemory) return volume.error();
    if (volume) info.assumptions = (*volume)->provenance().assumptions;
    show(info, volume ? volume->get() : nullptr, json);
    return {};
}

void showPhantom(bool json) {
    const Volume volume = phantom::make();
    show({.format = "built-in phantom",
          .values = "uint16",
          .size = volume.size(),
          .worldFromVoxel = volume.worldFromVoxel(),
          .assumptions = volume.provenance().assumptions},
         &volume, json);
}

}  // namespace macula::cli
