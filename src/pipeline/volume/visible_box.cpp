#include "pipeline/volume/visible_box.h"

#include <limits>

#include "base/check.h"

namespace macula {

Box visibleBoxMm(const Volume& volume, const BrickGrid& grid, const Medium& medium) {
    MACULA_CHECK_EQ(medium.bounds.size(), grid.ranges.size());
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    Box box{glm::dvec3(kNowhere), glm::dvec3(-kNowhere)};
    const glm::dmat4& worldFromVoxel = volume.worldFromVoxel();
    const glm::dmat3 axes(worldFromVoxel);
    const glm::dmat3 lengths(glm::abs(axes[0]), glm::abs(axes[1]), glm::abs(axes[2]));
    const glm::dvec3 end = glm::dvec3(volume.size()) - 0.5;
    for (int z = 0; z < grid.size.z; ++z) {
        for (int y = 0; y < grid.size.y; ++y) {
            for (int x = 0; x < grid.size.x; ++x) {
                if (!(medium.bounds[grid.index(x, y, z)] > 0.0f)) continue;
                // Cells from voxel 8b - 1 on, and half a voxel beyond the outer ones.
                const glm::dvec3 first = double(kBrickVoxels) * glm::dvec3(x, y, z) - 1.0;
                const glm::dvec3 low = glm::max(first, glm::dvec3(-0.5));
                const glm::dvec3 high = glm::min(first + double(kBrickVoxels), end);
                const glm::dvec3 centre = transformPoint(worldFromVoxel, 0.5 * (low + high));
                const glm::dvec3 half = lengths * (0.5 * (high - low));
                box.low = glm::min(box.low, centre - half);
                box.high = glm::max(box.high, centre + half);
            }
        }
    }
    return box;
}

}  // namespace macula
