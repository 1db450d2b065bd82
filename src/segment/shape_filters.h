// Filters that change the shape of a segment: smoother, larger, smaller, filled between slices.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "base/voxel_set.h"

namespace macula::segment {

// The voxels that a segment may have: those of a volume.
struct SegmentGrid {
    glm::ivec3 size{0};
    glm::dvec3 spacingMm{1.0};  // between neighbours along i, j, k; distances take the axes as perpendicular
};

// Results are cropped, and lie in the grid. All of them work on the box around the set and its surroundings:
// they take 6 to 20 bytes for each voxel of it. Errors: usage for lengths that are not finite, not above 0,
// or above kMostMm; cancelled; outOfMemory.
inline constexpr double kMostMm = 100.0;

// Median: a voxel is in if more than half of those within `radiusMm` along each axis (a box) are. Beyond the
// grid there are no voxels to count.
Result<VoxelSet> medianOf(const VoxelSet& set, const SegmentGrid& grid, double radiusMm, Progress& progress);

// A voxel is in if the mean of the set, weighted by a Gaussian that is cut off at three standard deviations,
// is at least one half. Weights beyond the grid are left out of the mean.
Result<VoxelSet> gaussianOf(const VoxelSet& set, const SegmentGrid& grid, double sigmaMm, Progress& progress);

// The voxels of the grid whose centre is at most so far from that of a voxel of the set.
Result<VoxelSet> grownBy(const VoxelSet& set, const SegmentGrid& grid, double mm, Progress& progress);
// The voxels of the set whose centre is farther than that from each voxel of the grid that is not in it.
Result<VoxelSet> shrunkBy(const VoxelSet& set, const SegmentGrid& grid, double mm, Progress& progress);

// Fills empty slices between others that are not empty, along an axis of the grid (0 to 2): between two
// slices the signed distances to their outlines are interpolated linearly. `axis` below 0: the first of k, j
// and i along which there are such slices. Also fails with usage where there is none.
Result<VoxelSet> filledBetweenSlices(const VoxelSet& set, const SegmentGrid& grid, int axis,
                                     Progress& progress);

}  // namespace macula::segment
