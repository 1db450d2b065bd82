// The connected parts of a set of voxels, and the holes in it.
#pragma once

#include <cstddef>

#include "base/progress.h"
#include "base/result.h"
#include "base/voxel_set.h"

namespace macula::segment {

// All functions take memory for each row of voxels and for each run in it, not for each voxel. Sets in
// results are cropped. Errors: cancelled, outOfMemory.

// Voxels that are neighbours over faces, or with `corners` over edges and corners too, are in one part.

// Keeps the largest part, of equal ones that which begins first; the empty set stays empty.
Result<VoxelSet> largestIsland(const VoxelSet& set, bool corners, Progress& progress);
// Keeps the parts that have at least so many voxels.
Result<VoxelSet> withoutSmallIslands(const VoxelSet& set, std::size_t fewest, bool corners,
                                     Progress& progress);
// Keeps the part of a voxel; nothing where that is not in the set.
Result<VoxelSet> islandOf(const VoxelSet& set, const glm::ivec3& voxel, bool corners, Progress& progress);
// The number of parts.
Result<std::size_t> islandCount(const VoxelSet& set, bool corners, Progress& progress);

// Adds what the set encloses: voxels from which no way over faces leads out of the box around the set. What
// is open towards the edge of the volume is no hole.
Result<VoxelSet> withoutHoles(const VoxelSet& set, Progress& progress);

}  // namespace macula::segment
