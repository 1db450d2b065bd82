// Voxels by their values: between two of them, or connected with a point.
#pragma once

#include <cstddef>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "base/voxel_set.h"

namespace macula::segment {

// The voxels whose value, in units, lies in the range, both ends included; of `within` alone, unless it is
// null. Padding and NaN never do. The set is cropped. Uses all cores. Errors: usage for a range that is not
// finite or has no values; cancelled; outOfMemory.
Result<VoxelSet> voxelsBetween(const Volume& volume, const ValueRange& range, const VoxelSet* within,
                               Progress& progress);

struct GrowRequest {
    glm::ivec3 seed{0};                // a voxel of the volume
    double tolerance = 0.0;            // in units, at least 0
    bool corners = false;              // connected over edges and corners, too (26); otherwise over faces (6)
    std::size_t mostVoxels = 0;        // stops there; 0: no limit
    const VoxelSet* within = nullptr;  // grows in these voxels alone; null: in the whole volume
};

struct Grown {
    VoxelSet voxels;          // cropped; always has the seed
    ValueRange range;         // the mean of the 3 x 3 x 3 voxels around the seed, and the tolerance around it
    bool isCutShort = false;  // it reached mostVoxels: the nearest ones, counted in steps from the seed
};

// The voxels of `range` that are connected with the seed. Padding and NaN are in no range. Takes a bit for
// each voxel of the volume. Errors: usage for a seed outside of the volume or of `within`, in padding, or
// itself not in the range; cancelled; outOfMemory.
Result<Grown> grownFrom(const Volume& volume, const GrowRequest& request, Progress& progress);

}  // namespace macula::segment
