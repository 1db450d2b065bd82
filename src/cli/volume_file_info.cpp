#include "cli/volume_file_info.h"

#include <nlohmann/json.hpp>

#include "cli/grid_json.h"
#include "dicom/volume_file.h"

namespace macula::cli {

Result<void> showVolumeFile(const std::filesystem::path& path, bool json) {
    MACULA_TRY(const dicom::VolumeFileInfo info, dicom::readVolumeFileInfo(path));
    nlohmann::ordered_json grid = gridToJson(info.size, info.worldFromVoxel);
    if (json) {
        nlohmann::ordered_json file = {{"format", info.format}, {"values", info.values}};
        file.update(grid);
        file["sheared"] = isSheared(info.worldFromVoxel);
        file["assumptions"] = info.assumptions;
        fmt::print("{}\n", nlohmann::ordered_json{{"volumeFile", file}}.dump(4));
        return {};
    }
    const auto mm = grid["spacingMm"].get<std::vector<double>>();
    fmt::print("{}  {}  {} x {} x {}  {:.4g} x {:.4g} x {:.4g} mm  {}\n", info.format, info.values,
               info.size.x, info.size.y, info.size.z, mm[0], mm[1], mm[2],
               orientationOf(info.worldFromVoxel));
    if (isSheared(info.worldFromVoxel)) fmt::print("  the axes are not perpendicular (sheared)\n");
    for (const std::string& assumption : info.assumptions) fmt::print("  assumed: {}\n", assumption);
    return {};
}

}  // namespace macula::cli
