#include "app/state/saved_grid.h"

#include <cmath>
#include <vector>

#include "pipeline/volume/json_reader.h"

namespace macula::app {

namespace {

constexpr JsonRange kOfTransform{-1e6, 1e6};
constexpr JsonRange kOfSize{1.0, 65536.0};
constexpr double kSamePlaceMm = 0.01;

}  // namespace

SavedGrid savedGridOf(const Volume& volume) {
    return {.size = volume.size(), .worldFromVoxel = volume.worldFromVoxel()};
}

bool liesAt(const Volume& volume, const SavedGrid& grid) {
    if (volume.size() != grid.size) return false;
    // Both maps are affine: what agrees at four corners agrees between them.
    const glm::dvec3 last(grid.size - 1);
    for (const glm::dvec3& corner :
         {glm::dvec3(0.0), glm::dvec3(last.x, 0, 0), glm::dvec3(0, last.y, 0), glm::dvec3(0, 0, last.z)}) {
        const glm::dvec3 apart =
            transformPoint(volume.worldFromVoxel(), corner) - transformPoint(grid.worldFromVoxel, corner);
        if (!(glm::length(apart) <= kSamePlaceMm)) return false;
    }
    return true;
}

nlohmann::ordered_json toJson(const SavedGrid& grid) {
    nlohmann::ordered_json json{{"size", {grid.size.x, grid.size.y, grid.size.z}}};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            json["worldFromVoxel"].push_back(grid.worldFromVoxel[column][row]);
    return json;
}

SavedGrid savedGridFrom(const JsonNode& node) {
    node.allowOnly({"size", "worldFromVoxel"});
    SavedGrid grid;
    const std::vector<double> size = node["size"].numbers(3, kOfSize);
    for (int axis = 0; axis < 3; ++axis)
        grid.size[axis] = static_cast<int>(std::lround(size[std::size_t(axis)]));
    const std::vector<double> rows = node["worldFromVoxel"].numbers(16, kOfTransform);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            grid.worldFromVoxel[column][row] = rows[4 * std::size_t(row) + std::size_t(column)];
    return grid;
}

}  // namespace macula::app
