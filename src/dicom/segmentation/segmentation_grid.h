// Finds grids on which all frames of a segmentation lie.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dicom/segmentation/grid_placement.h"
#include "dicom/segmentation/segmentation.h"

namespace macula::dicom {

using Placements = std::vector<GridPlacement>;  // one for each frame

// Places the frames on this grid without resampling; nothing when one does not lie on it: the first is
// `firstOff`. `slicePositionsMm` as in loadSegmentation.
std::optional<Placements> placeFrames(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                      std::span<const glm::dvec3> slicePositionsMm = {},
                                      std::size_t* firstOff = nullptr);

struct SegmentationGrid {
    glm::dmat4 worldFromVoxel{1.0};
    glm::ivec3 size{0};
    Placements placements;
};

// The smallest grid that holds all frames; nothing when they lie on no grid, or there are none.
std::optional<SegmentationGrid> ownGrid(const Segmentation& segmentation);

}  // namespace macula::dicom
