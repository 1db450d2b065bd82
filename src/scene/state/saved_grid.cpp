#include "scene/state/saved_grid.h"

namespace macula::scene {

namespace {

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

}  // namespace macula::scene
