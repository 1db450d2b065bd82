// Segments as sets of voxels, which may overlap.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/voxel_set.h"
#include "dicom/segmentation/segmentation.h"

namespace macula::dicom {

struct SegmentVoxels {
    Segment segment;
    VoxelSet voxels;  // of the grid that was asked for; none where nothing of the segment lies in it
    // Of the voxels that it was drawn on; of those in the grid where these are the same. Nothing where it has
    // none, or where nothing says how far the only slice reaches.
    std::optional<double> volumeMm3;
    std::optional<glm::dvec3> centroidMm;  // patient LPS; likewise
};

struct SegmentVoxelSets {
    std::vector<SegmentVoxels> segments;  // by number; those that are described, and those that are there
    bool isResampled = false;  // it was drawn on another grid, and the nearest voxel of that counts
    std::size_t outside = 0;   // voxels of segments outside of the grid; not of resampled ones
};

// On the grid of a volume: without resampling where all frames lie on it, as in loadSegmentation, which says
// what `slicePositionsMm` are; else the nearest voxel counts. Takes a bit for each voxel of the box around a
// segment. Fails with inputNotUsable when the frames lie on no grid.
Result<SegmentVoxelSets> loadSegmentVoxels(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                           glm::ivec3 size, Progress& progress,
                                           std::span<const glm::dvec3> slicePositionsMm = {});

// Those voxels of a grid whose middle lies in a voxel of `set`, which is of another grid.
VoxelSet nearestVoxels(const VoxelSet& set, const glm::dmat4& setFromVoxel, const glm::ivec3& size,
                       const CancelToken& token = {});

}  // namespace macula::dicom
