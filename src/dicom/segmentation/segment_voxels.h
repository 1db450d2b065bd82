// Loads segments as sets of voxels, which may overlap.
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
    VoxelSet voxels;  // on the requested grid; empty if the segment has no voxel in it
    // From the voxels that it was drawn on; without resampling, only from those in the grid. Nothing if it
    // has none, or if the thickness of its only slice is unknown.
    std::optional<double> volumeMm3;
    std::optional<glm::dvec3> centroidMm;  // patient LPS; likewise
};

struct SegmentVoxelSets {
    std::vector<SegmentVoxels> segments;  // by number; described ones, and others that have voxels
    bool isResampled = false;             // drawn on another grid: each voxel takes the nearest one there
    std::size_t outside = 0;              // voxels of segments outside of the grid; 0 if resampled
};

// Loads segments on the grid of a volume: without resampling if all frames lie on it, as in loadSegmentation,
// which explains `slicePositionsMm`; otherwise by the nearest voxel. Takes a bit for each voxel of the box
// around a segment. Fails with inputNotUsable when the frames lie on no grid.
Result<SegmentVoxelSets> loadSegmentVoxels(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                           glm::ivec3 size, Progress& progress,
                                           std::span<const glm::dvec3> slicePositionsMm = {});

// The voxels of a grid whose centre lies in a voxel of `set`, which is on another grid.
VoxelSet nearestVoxels(const VoxelSet& set, const glm::dmat4& setFromVoxel, const glm::ivec3& size,
                       const CancelToken& token = {});

}  // namespace macula::dicom
