#include "pipeline/volume/voxel_gradient.h"

#include <algorithm>

namespace macula {

double gradientPerMmAt(const Volume& volume, const EntryMap& map, const glm::ivec3& voxel) {
    glm::dvec3 perVoxel(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 low = voxel;
        glm::ivec3 high = voxel;
        low[axis] = std::max(voxel[axis] - 1, 0);
        high[axis] = std::min(voxel[axis] + 1, volume.size()[axis] - 1);
        perVoxel[axis] = 0.5 * (double(map.entryOf(volume.stored(high.x, high.y, high.z))) -
                                double(map.entryOf(volume.stored(low.x, low.y, low.z))));
    }
    // The inverse transpose turns a gradient over voxels into one over mm.
    const glm::dmat3 voxelFromWorld = glm::inverse(glm::dmat3(volume.worldFromVoxel()));
    return volume.unitsFromStored().slope * glm::length(glm::transpose(voxelFromWorld) * perVoxel);
}

double steepPart(double gradientPerMm, double halfPerMm) {
    // As a ratio: the square of a large gradient could be infinite.
    const double ratio = halfPerMm / gradientPerMm;
    return gradientPerMm > 0.0 ? 1.0 / (1.0 + ratio * ratio) : 0.0;
}

}  // namespace macula
