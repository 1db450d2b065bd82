// A set of voxels as a byte for each voxel of a box. Only for the filters of this folder.
#pragma once

#include <glm/glm.hpp>

#include "base/voxel_set.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

struct DenseBox {
    glm::ivec3 low{0};
    Grid grid;  // of the box: its axes are those of the volume
    Mask mask;

    static DenseBox of(const VoxelSet& set, const glm::ivec3& low, const glm::ivec3& high,
                       const glm::dvec3& spacingMm) {
        DenseBox box{.low = low, .grid = {high - low + 1, spacingMm}, .mask = {}};
        box.mask.resize(box.grid.count());
        set.forEach([&](const glm::ivec3& voxel) { box.mask[box.indexOf(voxel)] = 1; });
        return box;
    }
    std::size_t indexOf(const glm::ivec3& voxel) const {
        const glm::ivec3 at = voxel - low;
        return grid.index(at.x, at.y, at.z);
    }
    // The voxels for which isIn(index) holds, cropped.
    template <class IsIn>
    VoxelSet setWhere(const IsIn& isIn) const {
        VoxelSet set(low, low + grid.size - 1);
        std::size_t n = 0;
        for (int k = 0; k < grid.size.z; ++k)
            for (int j = 0; j < grid.size.y; ++j)
                for (int i = 0; i < grid.size.x; ++i)
                    if (isIn(n++)) set.add(low + glm::ivec3(i, j, k));
        return set.cropped();
    }
};

}  // namespace macula::segment
